// Every format and type of an OSMesa buffer, with its rows up and down, packed and apart: where each
// component of each pixel lies, and that nothing else is written. Mesa's library cannot be asked about
// OSMESA_RGB, which it garbles.
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr int kWidth = 67, kHeight = 66;  // more than one bin, and not a whole number of tiles

struct Layout {
    const char* name;
    GLenum format, type;
    std::vector<int> components;  // 0 red to 3 alpha, in the order of memory
    std::size_t component_bytes;
};

const Layout kLayouts[] = {
    {"RgbaBytes", OSMESA_RGBA, GL_UNSIGNED_BYTE, {0, 1, 2, 3}, 1},
    {"BgraBytes", OSMESA_BGRA, GL_UNSIGNED_BYTE, {2, 1, 0, 3}, 1},
    {"ArgbBytes", OSMESA_ARGB, GL_UNSIGNED_BYTE, {3, 0, 1, 2}, 1},
    {"RgbBytes", OSMESA_RGB, GL_UNSIGNED_BYTE, {0, 1, 2}, 1},
    {"RgbaShorts", OSMESA_RGBA, GL_UNSIGNED_SHORT, {0, 1, 2, 3}, 2},
    {"RgbShorts", OSMESA_RGB, GL_UNSIGNED_SHORT, {0, 1, 2}, 2},
    {"RgbaFloats", OSMESA_RGBA, GL_FLOAT, {0, 1, 2, 3}, 4},
    {"RgbFloats", OSMESA_RGB, GL_FLOAT, {0, 1, 2}, 4},
    {"Rgb565", OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, {}, 2},
};

struct Rows {
    const char* name;
    bool y_up;
    int length;  // OSMESA_ROW_LENGTH, 0 for none
};
constexpr Rows kRows[] = {
    {"Up", true, 0}, {"Down", false, 0}, {"UpApart", true, 71}, {"DownApart", false, 71}};

// Each pixel has a colour of its own made of zeros and ones, which all types hold exactly.
std::array<int, 4> color_of(int x, int y) {
    return {(x ^ y) & 1, x >> 1 & 1, (x >> 2 ^ y >> 1) & 1, (y >> 2 ^ x >> 3) & 1};
}

class OsmesaLayouts : public testing::TestWithParam<std::tuple<Layout, Rows>> {
  protected:
    OsmesaLayouts()
        : m_context(OSMesaCreateContextExt(static_cast<GLenum>(layout().format), 0, 0, 0, nullptr)) {}
    ~OsmesaLayouts() override { OSMesaDestroyContext(m_context); }

    static const Layout& layout() { return std::get<0>(GetParam()); }
    static const Rows& rows() { return std::get<1>(GetParam()); }
    static std::size_t pixel_bytes() {
        return layout().components.empty() ? 2 : layout().components.size() * layout().component_bytes;
    }

    static void draw() {
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, kWidth, 0, kHeight, -1, 1);
        glBegin(GL_POINTS);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto color = color_of(x, y);
                glColor4f(static_cast<float>(color[0]), static_cast<float>(color[1]),
                          static_cast<float>(color[2]), static_cast<float>(color[3]));
                glVertex2f(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            }
        }
        glEnd();
        glFinish();
    }

    // What the pixel's memory holds.
    static std::vector<std::uint8_t> expected(int x, int y) {
        const auto color = color_of(x, y);
        std::vector<std::uint8_t> out(pixel_bytes());
        if (layout().components.empty()) {
            const auto word =
                static_cast<std::uint16_t>(color[0] * 31 << 11 | color[1] * 63 << 5 | color[2] * 31);
            std::memcpy(out.data(), &word, sizeof word);
            return out;
        }
        const float one = 1;
        for (std::size_t c = 0; c < layout().components.size(); ++c) {
            if (!color[static_cast<std::size_t>(layout().components[c])]) continue;
            std::uint8_t* const to = &out[c * layout().component_bytes];
            layout().type == GL_FLOAT ? std::memcpy(to, &one, 4)
                                      : std::memset(to, 0xff, layout().component_bytes);
        }
        return out;
    }

    template <typename Number>
    static void expect_read(GLenum type, Number one) {
        const bool has_alpha = layout().format != OSMESA_RGB && layout().format != OSMESA_RGB_565;
        std::vector<std::array<Number, 4>> all(std::size_t{kWidth} * kHeight);
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, type, all.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto color = color_of(x, y);
                std::array<Number, 4> wanted{}, single{};
                for (std::size_t c = 0; c < 4; ++c)
                    wanted[c] = color[c] || (c == 3 && !has_alpha) ? one : Number{0};
                ASSERT_EQ(all[static_cast<std::size_t>(y * kWidth + x)], wanted) << x << ", " << y;
                if (y % 13 != 0) continue;
                glReadPixels(x, y, 1, 1, GL_RGBA, type, single.data());
                ASSERT_EQ(single, wanted) << x << ", " << y;
            }
        }
    }

    OSMesaContext m_context;
};

TEST_P(OsmesaLayouts, HaveEachComponentInItsPlace) {
    const int length = rows().length ? rows().length : kWidth;
    const std::size_t stride = static_cast<std::size_t>(length) * pixel_bytes();
    constexpr std::size_t kGuard = 64;
    std::vector<std::uint8_t> memory(stride * kHeight + kGuard, 0xcd);
    ASSERT_TRUE(OSMesaMakeCurrent(m_context, memory.data(), layout().type, kWidth, kHeight));
    OSMesaPixelStore(OSMESA_Y_UP, rows().y_up);
    OSMesaPixelStore(OSMESA_ROW_LENGTH, rows().length);
    draw();
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    for (int row = 0; row < kHeight; ++row) {
        const std::uint8_t* const line = memory.data() + static_cast<std::size_t>(row) * stride;
        const int y = rows().y_up ? row : kHeight - 1 - row;
        for (int x = 0; x < kWidth; ++x) {
            const std::uint8_t* const at = line + static_cast<std::size_t>(x) * pixel_bytes();
            ASSERT_EQ(std::vector(at, at + pixel_bytes()), expected(x, y)) << x << ", " << y;
        }
        // The last row ends with its last pixel.
        for (std::size_t b = kWidth * pixel_bytes(); b < stride; ++b)
            ASSERT_EQ(line[b], 0xcd) << "behind row " << row;
    }
    for (std::size_t b = stride * kHeight; b < memory.size(); ++b) ASSERT_EQ(memory[b], 0xcd);
    // What is read back is what was drawn, whatever the client's memory is like: at once, and one by one.
    expect_read<GLubyte>(GL_UNSIGNED_BYTE, 255);
    expect_read<GLushort>(GL_UNSIGNED_SHORT, 65535);
    expect_read<GLfloat>(GL_FLOAT, 1);
}

INSTANTIATE_TEST_SUITE_P(All, OsmesaLayouts,
                         testing::Combine(testing::ValuesIn(kLayouts), testing::ValuesIn(kRows)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) + std::get<1>(info.param).name;
                         });

// OSMESA_BGR is made and has no type, as in Mesa 22.3; 5-6-5 and the others do not exchange types.
TEST(OsmesaPairs, ThatDoNotExistAreRefused) {
    constexpr GLenum kTypes[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, GL_UNSIGNED_SHORT_5_6_5,
                                 GL_BYTE};
    constexpr GLenum kFormats[] = {OSMESA_RGBA, OSMESA_BGRA, OSMESA_ARGB,
                                   OSMESA_RGB,  OSMESA_BGR,  OSMESA_RGB_565};
    std::vector<float> memory(16);
    for (const GLenum format : kFormats) {
        const OSMesaContext context = OSMesaCreateContext(format, nullptr);
        ASSERT_NE(context, nullptr) << format;
        for (const GLenum type : kTypes) {
            const bool is_565 = format == OSMESA_RGB_565;
            const bool fits =
                format != OSMESA_BGR && type != GL_BYTE && (type == GL_UNSIGNED_SHORT_5_6_5) == is_565;
            EXPECT_EQ(OSMesaMakeCurrent(context, memory.data(), type, 2, 2), fits) << format << ' ' << type;
            OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        }
        OSMesaDestroyContext(context);
    }
}

}  // namespace
