// GLX where programs leave the usual ways: parts of a back buffer, pixels of earlier frames, images taken
// while the program's own pixel state is set, pixmaps asked for back buffers, drawables of every format.
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "glx_fixture.h"
#include "pictures.h"

namespace terrazzo::test {
namespace {

class GlxState : public Glx {
  protected:
    void copy_part(GLXDrawable name, int x, int y, int width, int height) {
        command<void(Display*, GLXDrawable, int, int, int, int)>("glXCopySubBufferMESA")(display, name, x, y,
                                                                                         width, height);
    }
    unsigned age(GLXDrawable name) {
        unsigned out = 77;
        glXQueryDrawable(display, name, GLX_BACK_BUFFER_AGE_EXT, &out);
        return out;
    }
};

TEST_F(GlxState, PartsOfTheBackBufferAreShown) {
    constexpr int kWidth = 60, kHeight = 50;
    struct Part {
        int x, y, width, height;
    };
    const Part parts[] = {{10, 20, 17, 9},
                          {0, 0, 1, 1},
                          {59, 49, 1, 1},
                          {-5, -7, 20, 15},
                          {50, 40, 100, 100},
                          {0, 30, 60, 1},
                          {7, 0, 1, 50},
                          {20, 20, 0, 5},
                          {20, 20, 5, 0},
                          {20, 20, -5, 5},
                          {20, 20, 5, -5},
                          {60, 0, 5, 5},
                          {0, 50, 5, 5},
                          {-9, -9, 9, 9},
                          {5, 6, 0x7fffffff, 0x7fffffff},
                          {-0x7fffffff, -0x7fffffff, 0x7fffffff, 0x7fffffff}};
    const auto shown = window(double_buffered(), kWidth, kHeight);
    const GLXContext ctx = context(double_buffered());
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    for (const Part& part : parts) {
        clear_to(kBlue);
        glXSwapBuffers(display, shown->id());
        draw_pattern(kWidth, kHeight);
        copy_part(shown->id(), part.x, part.y, part.width, part.height);
        const Picture found = picture_of(display, shown->id(), kWidth, kHeight);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto within = [](int at, long long begin, int size) {
                    return at >= begin && at < begin + size;
                };
                const bool inside = within(x, part.x, part.width) && within(y, part.y, part.height);
                ASSERT_EQ(found.at(x, y), inside ? pattern(x, y) : kBlue)
                    << x << "," << y << " of " << part.x << "," << part.y << " " << part.width << "x"
                    << part.height;
            }
        }
        // The back buffer keeps what it had.
        EXPECT_EQ(read(kWidth - 1, 3), pattern(kWidth - 1, 3));
    }
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyContext(display, ctx);
}

TEST_F(GlxState, TheAgeOfTheBackBufferSaysWhatIsInIt) {
    const auto shown = window(double_buffered(), 40, 30);
    const GLXContext ctx = context(double_buffered());
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    std::vector<Pixel> frames;
    std::vector<unsigned> ages;
    const auto next_frame = [&] {
        ages.push_back(age(shown->id()));
        if (ages.back() > 0) {
            ASSERT_LE(ages.back(), frames.size());
            EXPECT_EQ(read(20, 15), frames[frames.size() - ages.back()]) << "frame " << frames.size();
        }
        const int n = static_cast<int>(frames.size());
        frames.push_back({n * 20 % 256, 255 - n * 10, n * 50 % 256});
        clear_to(frames.back());
        glXSwapBuffers(display, shown->id());
        EXPECT_EQ(shown->pixel(20, 15), frames.back());
    };
    for (int i = 0; i < 3; ++i) next_frame();
    glReadBuffer(GL_FRONT);  // now it needs pixels of its own, which the swaps exchange
    EXPECT_EQ(read(20, 15), frames.back());
    glReadBuffer(GL_BACK);
    for (int i = 0; i < 3; ++i) next_frame();
    EXPECT_EQ(ages, (std::vector<unsigned>{0, 1, 1, 1, 2, 2}));

    shown->resize(50, 60);
    glXWaitX();
    frames.clear(), ages.clear();
    for (int i = 0; i < 2; ++i) next_frame();
    EXPECT_EQ(ages, (std::vector<unsigned>{0, 1}));
    // Before the first swap of a size the front has pixels already: nobody knows them as a frame.
    shown->resize(40, 30);
    glXWaitX();
    glReadBuffer(GL_FRONT);
    read(20, 15);
    glReadBuffer(GL_BACK);
    const std::size_t before = frames.size();
    for (int i = 0; i < 3; ++i) next_frame();
    EXPECT_EQ(frames.size(), before + 3);
    EXPECT_EQ(ages[2], 0u);
    EXPECT_EQ(ages[4], 2u);
    glXDestroyContext(display, ctx);
}

// What a program may have set for its own images; each is undone.
struct PixelState {
    const char* what;
    std::function<void()> set;
};

const std::vector<PixelState>& pixel_states() {
    static const std::vector<PixelState> states = {
        {"nothing", [] {}},
        {"row length", [] { glPixelStorei(GL_UNPACK_ROW_LENGTH, 37); }},
        {"skipped rows", [] { glPixelStorei(GL_UNPACK_SKIP_ROWS, 3); }},
        {"skipped pixels", [] { glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5); }},
        {"swapped bytes", [] { glPixelStorei(GL_UNPACK_SWAP_BYTES, 1); }},
        {"bits from the right", [] { glPixelStorei(GL_UNPACK_LSB_FIRST, 1); }},
        {"alignment", [] { glPixelStorei(GL_UNPACK_ALIGNMENT, 8); }},
        {"a scale", [] { glPixelTransferf(GL_RED_SCALE, 0.25f); }},
        {"a bias", [] { glPixelTransferf(GL_GREEN_BIAS, 0.5f); }},
        {"a map",
         [] {
             const GLfloat inverted[] = {1, 0};
             glPixelMapfv(GL_PIXEL_MAP_B_TO_B, 2, inverted);
             glPixelTransferi(GL_MAP_COLOR, 1);
         }},
        {"a buffer",
         [] {
             GLuint buffer = 0;
             command<void(GLsizei, GLuint*)>("glGenBuffers")(1, &buffer);
             command<void(GLenum, GLuint)>("glBindBuffer")(GL_PIXEL_UNPACK_BUFFER, buffer);
             command<void(GLenum, GLsizeiptr, const void*, GLenum)>("glBufferData")(
                 GL_PIXEL_UNPACK_BUFFER, 1 << 16, nullptr, GL_STATIC_DRAW);
         }},
        {"a full stack of client attributes",
         [] {
             GLint depth = 0;
             for (glGetIntegerv(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, &depth); depth > 0; --depth)
                 glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
             glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
         }},
    };
    return states;
}

// All of it that can be asked for.
std::vector<GLfloat> pixel_values() {
    std::vector<GLfloat> out;
    for (const GLenum name :
         {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES,
          GL_UNPACK_LSB_FIRST, GL_UNPACK_ALIGNMENT, GL_RED_SCALE, GL_GREEN_BIAS, GL_MAP_COLOR,
          GL_PIXEL_UNPACK_BUFFER_BINDING, GL_CLIENT_ATTRIB_STACK_DEPTH}) {
        GLfloat value = -1;
        glGetFloatv(name, &value);
        out.push_back(value);
    }
    return out;
}

TEST_F(GlxState, ImagesOfPixmapsDoNotMeetTheProgramsPixelState) {
    constexpr int kSize = 16;
    const GLXFBConfig chosen = single_buffered();
    const auto shown = window(chosen, kSize, kSize);
    const Pixmap pixmap = XCreatePixmap(display, shown->id(), kSize, kSize, 24);
    const GC gc = XCreateGC(display, pixmap, 0, nullptr);
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const Pixel color = pattern(x, kSize - 1 - y);
            XSetForeground(display, gc,
                           static_cast<unsigned long>(color[0] << 16 | color[1] << 8 | color[2]));
            XDrawPoint(display, pixmap, gc, x, y);
        }
    }
    const int list[] = {GLX_TEXTURE_FORMAT_EXT, GLX_TEXTURE_FORMAT_RGB_EXT, GLX_TEXTURE_TARGET_EXT,
                        GLX_TEXTURE_2D_EXT, kNone};
    const GLXPixmap drawable = glXCreatePixmap(display, chosen, pixmap, list);
    const auto bind = command<void(Display*, GLXDrawable, int, const int*)>("glXBindTexImageEXT");
    for (const bool compiling : {false, true}) {
        for (const PixelState& state : pixel_states()) {
            const GLXContext ctx = context(chosen);
            ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            state.set();
            const auto before = pixel_values();
            ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << state.what;
            const GLuint of_program = glGenLists(1);
            if (compiling) glNewList(of_program, GL_COMPILE);
            bind(display, drawable, GLX_FRONT_LEFT_EXT, nullptr);
            if (compiling) glEndList();
            EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << state.what;
            EXPECT_EQ(pixel_values(), before) << state.what;
            glDeleteLists(of_program, 1);
            glEnable(GL_TEXTURE_2D);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            draw_unit_square();
            // Copied and not read with ReadPixels, which the transfer state would meet.
            glFlush();
            const Picture found = picture_of(display, shown->id(), kSize, kSize);
            EXPECT_EQ(found.differing(pattern), "")
                << state.what << (compiling ? " while compiling a list" : "");
            ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
            glXDestroyContext(display, ctx);
        }
    }
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyPixmap(display, drawable);
    XFreeGC(display, gc);
    XFreePixmap(display, pixmap);
}

TEST_F(GlxState, FontsDoNotMeetTheProgramsPixelState) {
    const Font font = XLoadFont(display, "fixed");
    if (take_x_error() != 0) GTEST_SKIP() << "the server has no font";
    constexpr int kWidth = 40, kHeight = 24;
    const auto shown = window(single_buffered(), kWidth, kHeight);
    Picture expected;
    for (const PixelState& state : pixel_states()) {
        const GLXContext ctx = context(single_buffered());
        ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
        state.set();
        const auto before = pixel_values();
        glXUseXFont(font, 'A', 26, 100);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << state.what;
        EXPECT_EQ(pixel_values(), before) << state.what;
        clear_to(kBlack);
        glOrtho(0, kWidth, 0, kHeight, -1, 1);
        glColor3f(0, 1, 0);
        glRasterPos2i(2, 6);
        for (const char letter : std::string("KLR")) glCallList(100u + static_cast<GLuint>(letter - 'A'));
        glFlush();
        const Picture found = picture_of(display, shown->id(), kWidth, kHeight);
        if (expected.pixels.empty()) {
            expected = found;
            EXPECT_GT(found.count(kGreen), 20);
        }
        EXPECT_EQ(found.differing([&](int x, int y) { return expected.at(x, y); }), "") << state.what;
        ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
        glXDestroyContext(display, ctx);
    }
    XUnloadFont(display, font);
}

// A pixmap has the one buffer that X can see, whatever its configuration has.
TEST_F(GlxState, PixmapsHaveNoBackBuffer) {
    for (const GLXFBConfig chosen : {double_buffered(), single_buffered()}) {
        const Pixmap pixmap = XCreatePixmap(display, DefaultRootWindow(display), 8, 8, 24);
        const GLXPixmap drawable = glXCreatePixmap(display, chosen, pixmap, nullptr);
        const GLXContext ctx = context(single_buffered());
        ASSERT_TRUE(glXMakeCurrent(display, drawable, ctx));
        clear_to(kGreen);
        glDrawBuffer(GL_BACK);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        glReadBuffer(GL_BACK);
        EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(read(3, 3), kGreen);
        glXSwapBuffers(display, drawable);  // without effect on what has one buffer
        glFlush();
        EXPECT_EQ(picture_of(display, pixmap, 8, 8).count(kGreen), 64);
        EXPECT_EQ(age(drawable), 0u);
        ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
        glXDestroyContext(display, ctx);
        glXDestroyPixmap(display, drawable);
        XFreePixmap(display, pixmap);
    }
    EXPECT_EQ(take_x_error(), 0);
}

// Each configuration is what it says, in windows, pbuffers and pixmaps.
TEST_F(GlxState, DrawablesHaveTheFormatOfTheirConfiguration) {
    int count = 0;
    GLXFBConfig* const all = glXGetFBConfigs(display, DefaultScreen(display), &count);
    ASSERT_GT(count, 0);
    for (int i = 0; i < count; ++i) {
        const GLXFBConfig chosen = all[i];
        const auto value = [&](int name) {
            int out = -1;
            glXGetFBConfigAttrib(display, chosen, name, &out);
            return out;
        };
        const Bits bits{value(GLX_RED_SIZE),   value(GLX_GREEN_SIZE), value(GLX_BLUE_SIZE),
                        value(GLX_ALPHA_SIZE), value(GLX_DEPTH_SIZE), value(GLX_STENCIL_SIZE),
                        value(GLX_SAMPLES)};
        SCOPED_TRACE("configuration " + std::to_string(i + 1));
        const GLXContext ctx = context(chosen);
        const int size[] = {GLX_PBUFFER_WIDTH, kFormatSize, GLX_PBUFFER_HEIGHT, kFormatSize, kNone};
        const auto shown = window(chosen, kFormatSize, kFormatSize);
        XVisualInfo* const visual = glXGetVisualFromFBConfig(display, chosen);
        const Pixmap pixmap = XCreatePixmap(display, shown->id(), kFormatSize, kFormatSize,
                                            static_cast<unsigned>(visual->depth));
        XFree(visual);
        const GLXPbuffer hidden = glXCreatePbuffer(display, chosen, size);
        const GLXPixmap kept = glXCreatePixmap(display, chosen, pixmap, nullptr);
        for (const GLXDrawable drawable : {hidden, GLXDrawable{shown->id()}, kept}) {
            ASSERT_TRUE(glXMakeCurrent(display, drawable, ctx));
            const bool has_back = drawable != kept && value(GLX_DOUBLEBUFFER) == 1;
            check_format(bits, has_back);
            if (drawable == hidden) continue;
            if (has_back) glXSwapBuffers(display, drawable);
            glFlush();
            const bool is_window = drawable == shown->id();
            check_shown_format(picture_of(display, is_window ? shown->id() : pixmap, kFormatSize, kFormatSize,
                                          is_window ? 0 : shown->id()),
                               bits);
        }
        ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
        glXDestroyContext(display, ctx);
        glXDestroyPbuffer(display, hidden);
        glXDestroyPixmap(display, kept);
        XFreePixmap(display, pixmap);
    }
    XFree(all);
    EXPECT_EQ(take_x_error(), 0);
}

}  // namespace
}  // namespace terrazzo::test
