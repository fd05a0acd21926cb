// Polygons and what becomes of them: which offset moves which kind of primitive (GL 1.5 §3.5.5), which side's
// stencil test their points, lines and fills undergo (EXT_stencil_two_side, ATI_separate_stencil, GL 2.0
// §4.1.4).
#include <gtest/gtest.h>

#include <array>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl/vertex_inline.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 32;

class PolygonSidesTest : public GlTest {
  protected:
    PolygonSidesTest() {
        raster::TargetFormat format;
        format.depth_bits = 24;
        format.stencil_bits = 8;
        attach_picture(ctx(), kSize, kSize, format);
        clear_depth(ctx(), 0);
        depth_func(ctx(), GL_ALWAYS);
        clear(ctx(), GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }

    // A triangle whose first corner is on pixel (4, 4) and whose lower edge leads to (28, 4); `z` in the
    // middle of the depth range.
    void draw_triangle(bool back_facing) {
        const auto at = [](int pixel) { return (static_cast<GLfloat>(pixel) + 0.5f) * 2 / kSize - 1; };
        begin(ctx(), GL_TRIANGLES);
        vertex4f(ctx(), at(4), at(4), 0, 1);
        if (back_facing) vertex4f(ctx(), at(16), at(28), 0, 1);
        vertex4f(ctx(), at(28), at(4), 0, 1);
        if (!back_facing) vertex4f(ctx(), at(16), at(28), 0, 1);
        end(ctx());
    }

    template <typename Value>
    Value read(GLenum format, GLenum type, int x, int y) {
        Value value{};
        read_pixels(ctx(), x, y, 1, 1, format, type, &value);
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return value;
    }
    GLfloat depth(int x, int y) { return read<GLfloat>(GL_DEPTH_COMPONENT, GL_FLOAT, x, y); }
    int stencil(int x, int y) { return read<GLubyte>(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, x, y); }
};

struct OffsetCase {
    GLenum mode, capability;
};

// Whatever is enabled beside them, stages or none.
TEST_F(PolygonSidesTest, EachOffsetMovesItsOwnKindAlone) {
    constexpr OffsetCase kKinds[] = {{GL_POINT, GL_POLYGON_OFFSET_POINT},
                                     {GL_LINE, GL_POLYGON_OFFSET_LINE},
                                     {GL_FILL, GL_POLYGON_OFFSET_FILL}};
    constexpr GLenum kBeside[] = {GL_LIGHTING, GL_POLYGON_STIPPLE, GL_LINE_STIPPLE, GL_LINE_SMOOTH,
                                  GL_POINT_SMOOTH};
    enable(ctx(), GL_DEPTH_TEST);
    polygon_offset(ctx(), 0, -4194304);  // a quarter of the range, and r is twice the smallest step
    point_size(ctx(), 3);
    line_width(ctx(), 3);
    line_stipple(ctx(), 1, 0x7fff);
    for (const GLenum beside : kBeside) {
        if (beside != GL_LIGHTING) enable(ctx(), beside);
        for (const OffsetCase& drawn : kKinds) {
            polygon_mode(ctx(), GL_FRONT_AND_BACK, drawn.mode);
            const int y = drawn.mode == GL_FILL ? 5 : 4;
            for (const OffsetCase& moved : kKinds) {
                enable(ctx(), moved.capability);
                draw_triangle(false);
                const GLfloat expected = drawn.mode == moved.mode ? 0.0f : 0.5f;
                EXPECT_NEAR(depth(drawn.mode == GL_POINT ? 4 : 10, y), expected, 1e-4f)
                    << std::hex << "drawn 0x" << drawn.mode << " moved 0x" << moved.mode << " beside 0x"
                    << beside;
                disable(ctx(), moved.capability);
                clear(ctx(), GL_DEPTH_BUFFER_BIT);
            }
        }
        if (beside != GL_LIGHTING) disable(ctx(), beside);
    }
}

// Of no area: there is no slope to be multiplied, and nothing that could become one.
TEST_F(PolygonSidesTest, OffsetsOfOtherKindsLeaveTrianglesWithoutArea) {
    enable(ctx(), GL_DEPTH_TEST);
    enable(ctx(), GL_POLYGON_OFFSET_POINT);
    polygon_offset(ctx(), 1, 1);
    polygon_mode(ctx(), GL_FRONT_AND_BACK, GL_LINE);
    begin(ctx(), GL_TRIANGLES);
    vertex4f(ctx(), -0.9f, 0.03125f, 0, 1);
    vertex4f(ctx(), 0, 0.03125f, 0, 1);
    vertex4f(ctx(), 0.9f, 0.03125f, 0, 1);
    end(ctx());
    EXPECT_NEAR(depth(20, 16), 0.5f, 1e-4f);
}

// 1 where the front's operation was carried out, 2 where the back's was.
TEST_F(PolygonSidesTest, PointsAndLinesOfPolygonsBelongToTheirSide) {
    enable(ctx(), GL_STENCIL_TEST);
    point_size(ctx(), 3);
    line_width(ctx(), 3);
    const auto expect_sides = [&](const char* what) {
        for (const GLenum smooth : {GLenum{GL_NONE}, GLenum{GL_LINE_SMOOTH}, GLenum{GL_POINT_SMOOTH}}) {
            if (smooth != GL_NONE) enable(ctx(), smooth);
            for (const GLenum mode : {GLenum{GL_POINT}, GLenum{GL_LINE}, GLenum{GL_FILL}}) {
                polygon_mode(ctx(), GL_FRONT_AND_BACK, mode);
                for (const bool back : {false, true}) {
                    clear(ctx(), GL_STENCIL_BUFFER_BIT);
                    draw_triangle(back);
                    EXPECT_EQ(stencil(mode == GL_POINT ? 4 : 10, mode == GL_FILL ? 5 : 4), back ? 2 : 1)
                        << what << std::hex << " mode 0x" << mode << " with 0x" << smooth;
                }
            }
            if (smooth != GL_NONE) disable(ctx(), smooth);
        }
        polygon_mode(ctx(), GL_FRONT_AND_BACK, GL_FILL);
    };
    stencil_op_separate(ctx(), GL_FRONT, GL_KEEP, GL_KEEP, GL_REPLACE);
    stencil_op_separate(ctx(), GL_BACK, GL_KEEP, GL_KEEP, GL_INCR);
    stencil_func(ctx(), GL_ALWAYS, 1, 0xff);
    stencil_op_separate(ctx(), GL_BACK, GL_KEEP, GL_KEEP, GL_REPLACE);
    stencil_func_separate(ctx(), GL_BACK, GL_ALWAYS, 2, 0xff);
    expect_sides("separate");

    // The other extension's back side is one of its own, and takes its place.
    active_stencil_face_ext(ctx(), GL_BACK);
    stencil_func(ctx(), GL_NEVER, 2, 0xff);
    stencil_op(ctx(), GL_REPLACE, GL_KEEP, GL_KEEP);
    active_stencil_face_ext(ctx(), GL_FRONT);
    stencil_func_separate(ctx(), GL_BACK, GL_ALWAYS, 7, 0xff);
    enable(ctx(), GL_STENCIL_TEST_TWO_SIDE_EXT);
    expect_sides("two side");
}

// Neither polygons nor their parts: the front side's.
TEST_F(PolygonSidesTest, PointsLinesBitmapsAndPixelsAreFronts) {
    enable(ctx(), GL_STENCIL_TEST);
    stencil_func_separate_ati(ctx(), GL_ALWAYS, GL_ALWAYS, 0, 0xff);
    stencil_op_separate(ctx(), GL_FRONT, GL_INCR, GL_INCR, GL_INCR);
    stencil_op_separate(ctx(), GL_BACK, GL_DECR_WRAP, GL_DECR_WRAP, GL_DECR_WRAP);
    front_face(ctx(), GL_CW);
    for (const GLenum smooth : {GLenum{GL_NONE}, GLenum{GL_LINE_SMOOTH}, GLenum{GL_POINT_SMOOTH}}) {
        if (smooth != GL_NONE) enable(ctx(), smooth);
        clear(ctx(), GL_STENCIL_BUFFER_BIT);
        point_size(ctx(), 3);
        begin(ctx(), GL_POINTS);
        vertex4f(ctx(), -0.5f, -0.5f, 0, 1);
        end(ctx());
        begin(ctx(), GL_LINES);
        vertex4f(ctx(), -0.5f, 0.53125f, 0, 1);
        vertex4f(ctx(), 0.5f, 0.53125f, 0, 1);
        vertex4f(ctx(), 0.5f, 0.78125f, 0, 1);
        vertex4f(ctx(), -0.5f, 0.78125f, 0, 1);
        end(ctx());
        EXPECT_GE(stencil(8, 8), 1);
        EXPECT_LE(stencil(8, 8), 2) << "a point of two triangles";
        for (const int y : {24, 28}) {
            EXPECT_GE(stencil(16, y), 1) << y;
            EXPECT_LE(stencil(16, y), 2) << y;
        }
        if (smooth != GL_NONE) disable(ctx(), smooth);
    }
    clear(ctx(), GL_STENCIL_BUFFER_BIT);
    window_pos3f(ctx(), 2, 2, 0);
    const GLubyte bits[] = {0xff, 0, 0, 0};
    bitmap(ctx(), 8, 1, 0, 0, 0, 4, bits);
    EXPECT_EQ(stencil(3, 2), 1);
    const GLubyte pixel[4] = {255, 255, 255, 255};
    draw_pixels(ctx(), 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(stencil(2, 6), 1);
    stencil_mask_separate(ctx(), GL_FRONT, 0x0f);
    const GLubyte index = 0xff;
    window_pos3f(ctx(), 20, 2, 0);
    draw_pixels(ctx(), 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &index);
    EXPECT_EQ(stencil(20, 2), 0x0f);
    clear_stencil(ctx(), 0xa5);
    clear(ctx(), GL_STENCIL_BUFFER_BIT);
    EXPECT_EQ(stencil(25, 25), 5) << "clears go through the front's mask";
}

}  // namespace
}  // namespace terrazzo::gl
