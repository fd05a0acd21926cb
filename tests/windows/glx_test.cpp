// GLX as programs use it: configurations, contexts, drawables, swaps, errors. Run by on_display.py, through libglvnd and
// without, on servers with and without GLX and shared memory.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "glx_fixture.h"

namespace terrazzo::test {
namespace {

// libglvnd takes another vendor in silence where ours fails to load.
TEST_F(Glx, TheRendererIsOurs) {
    const GLXFBConfig chosen = double_buffered();
    ASSERT_NE(chosen, nullptr);
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    EXPECT_EQ(renderer.substr(0, 8), "Terrazzo");
    EXPECT_TRUE(glXIsDirect(display, ctx));
    EXPECT_STREQ(glXGetClientString(display, GLX_VENDOR), "Terrazzo");
    int major = 0, minor = 0;
    EXPECT_TRUE(glXQueryVersion(display, &major, &minor));
    EXPECT_EQ(major * 10 + minor, 14);
    EXPECT_EQ(glXGetCurrentContext(), ctx);
    EXPECT_EQ(glXGetCurrentDrawable(), shown->id());
    EXPECT_EQ(glXGetCurrentDisplay(), display);
    glXDestroyContext(display, ctx);
    // Destroyed, but current: still good.
    clear_to(kRed);
    EXPECT_EQ(read(3, 3), kRed);
    EXPECT_EQ(take_x_error(), 0);
}

TEST_F(Glx, EveryConfigurationHasAVisualOfItsDepth) {
    int count = 0;
    GLXFBConfig* const all = glXGetFBConfigs(display, DefaultScreen(display), &count);
    ASSERT_GT(count, 15);
    for (int i = 0; i < count; ++i) {
        int id = 0, red = 0, green = 0, blue = 0, visual_id = 0;
        glXGetFBConfigAttrib(display, all[i], GLX_FBCONFIG_ID, &id);
        glXGetFBConfigAttrib(display, all[i], GLX_RED_SIZE, &red);
        glXGetFBConfigAttrib(display, all[i], GLX_GREEN_SIZE, &green);
        glXGetFBConfigAttrib(display, all[i], GLX_BLUE_SIZE, &blue);
        glXGetFBConfigAttrib(display, all[i], GLX_VISUAL_ID, &visual_id);
        EXPECT_EQ(id, i + 1);
        XVisualInfo* const visual = glXGetVisualFromFBConfig(display, all[i]);
        ASSERT_NE(visual, nullptr);
        EXPECT_EQ(static_cast<int>(visual->visualid), visual_id);
        EXPECT_GE(visual->depth, red + green + blue);
        const auto value = [&](int name) {
            int out = -1;
            EXPECT_EQ(glXGetFBConfigAttrib(display, all[i], name, &out), 0) << name;
            return out;
        };
        EXPECT_EQ(value(GLX_X_VISUAL_TYPE), visual->c_class == TrueColor ? GLX_TRUE_COLOR : GLX_DIRECT_COLOR);
        EXPECT_EQ(value(GLX_BUFFER_SIZE), red + green + blue + value(GLX_ALPHA_SIZE));
        EXPECT_EQ(value(GLX_SAMPLE_BUFFERS), value(GLX_SAMPLES) > 0);
        EXPECT_EQ(value(GLX_BIND_TO_TEXTURE_RGBA_EXT), value(GLX_ALPHA_SIZE) > 0);
        for (const int component : {GLX_ACCUM_GREEN_SIZE, GLX_ACCUM_BLUE_SIZE, GLX_ACCUM_ALPHA_SIZE})
            EXPECT_EQ(value(component), value(GLX_ACCUM_RED_SIZE));
        for (const auto& [name, expected] : std::vector<std::pair<int, int>>{
                 {GLX_CONFIG_CAVEAT, GLX_NONE},
                 {GLX_AUX_BUFFERS, 0},
                 {GLX_LEVEL, 0},
                 {GLX_STEREO, 0},
                 {GLX_RENDER_TYPE, GLX_RGBA_BIT},
                 {GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT | GLX_PIXMAP_BIT | GLX_PBUFFER_BIT},
                 {GLX_X_RENDERABLE, 1},
                 {GLX_TRANSPARENT_TYPE, GLX_NONE},
                 {GLX_MAX_PBUFFER_WIDTH, 16384},
                 {GLX_MAX_PBUFFER_HEIGHT, 16384},
                 {GLX_MAX_PBUFFER_PIXELS, 16384 * 16384},
                 {GLX_VISUAL_SELECT_GROUP_SGIX, 0},
                 {GLX_BIND_TO_TEXTURE_RGB_EXT, 1},
                 {GLX_BIND_TO_MIPMAP_TEXTURE_EXT, 0},
                 {GLX_BIND_TO_TEXTURE_TARGETS_EXT, GLX_TEXTURE_1D_BIT_EXT | GLX_TEXTURE_2D_BIT_EXT},
                 {GLX_Y_INVERTED_EXT, 0}})
            EXPECT_EQ(value(name), expected) << name;
        XFree(visual);
    }
    XFree(all);
}

// What an attribute of a context says, for one of a configuration and for one of none.
TEST_F(Glx, ContextsSayWhatTheyWereMadeOf) {
    const auto create = command<GLXContext(Display*, GLXFBConfig, GLXContext, int, const int*)>(
        "glXCreateContextAttribsARB");
    const GLXFBConfig chosen = config({GLX_DOUBLEBUFFER, 1, GLX_STENCIL_SIZE, 8});
    int id = 0, visual = 0;
    glXGetFBConfigAttrib(display, chosen, GLX_FBCONFIG_ID, &id);
    glXGetFBConfigAttrib(display, chosen, GLX_VISUAL_ID, &visual);
    const int of_screen[] = {GLX_SCREEN, DefaultScreen(display), kNone};  // libglvnd wants to know it
    const GLXContext of_one = context(chosen), of_none = create(display, nullptr, nullptr, 1, of_screen);
    ASSERT_NE(of_none, nullptr);
    struct Case {
        GLXContext ctx;
        int name, expected;
    };
    for (const auto& [ctx, name, expected] :
         {Case{of_one, GLX_FBCONFIG_ID, id}, {of_one, GLX_VISUAL_ID, visual},
          {of_one, GLX_RENDER_TYPE, GLX_RGBA_TYPE}, {of_one, GLX_SCREEN, DefaultScreen(display)},
          {of_none, GLX_FBCONFIG_ID, 0}, {of_none, GLX_VISUAL_ID, 0},
          {of_none, GLX_RENDER_TYPE, GLX_RGBA_TYPE}, {of_none, GLX_SCREEN, DefaultScreen(display)}}) {
        int value = -77;
        EXPECT_EQ(glXQueryContext(display, ctx, name, &value), 0) << name;
        EXPECT_EQ(value, expected) << name;
        EXPECT_EQ(glXQueryContext(display, ctx, name, nullptr), 0) << name;
    }
    int value = -77;
    EXPECT_EQ(glXQueryContext(display, of_one, 0x7777, &value), GLX_BAD_ATTRIBUTE);
    EXPECT_EQ(value, -77);
    EXPECT_EQ(take_x_error(), 0);
    for (const GLXContext made : {of_one, of_none}) glXDestroyContext(display, made);
}

TEST_F(Glx, TheRendererIsDescribed) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    const auto query = command<int(Display*, int, int, int, unsigned*)>("glXQueryRendererIntegerMESA");
    const auto query_current = command<int(int, unsigned*)>("glXQueryCurrentRendererIntegerMESA");
    const auto text = command<const char*(Display*, int, int, int)>("glXQueryRendererStringMESA");
    const auto text_current = command<const char*(int)>("glXQueryCurrentRendererStringMESA");
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    unsigned major = 0, minor = 0, version[3] = {77, 77, 77};
    const auto* const gl_version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    ASSERT_EQ(std::sscanf(gl_version, "%u.%u Terrazzo %u.%u.%u", &major, &minor, &version[0], &version[1], &version[2]),
              5)
        << gl_version;
    const auto memory = static_cast<unsigned>((static_cast<unsigned long long>(sysconf(_SC_PHYS_PAGES)) *
                                               static_cast<unsigned long long>(sysconf(_SC_PAGESIZE))) >>
                                              20);
    const std::vector<std::pair<int, std::vector<unsigned>>> expected = {
        {GLX_RENDERER_VENDOR_ID_MESA, {~0u}},
        {GLX_RENDERER_DEVICE_ID_MESA, {~0u}},
        {GLX_RENDERER_VERSION_MESA, {version[0], version[1], version[2]}},
        {GLX_RENDERER_ACCELERATED_MESA, {0}},
        {GLX_RENDERER_VIDEO_MEMORY_MESA, {memory}},
        {GLX_RENDERER_UNIFIED_MEMORY_ARCHITECTURE_MESA, {1}},
        {GLX_RENDERER_PREFERRED_PROFILE_MESA, {GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB}},
        {GLX_RENDERER_OPENGL_COMPATIBILITY_PROFILE_VERSION_MESA, {major, minor}},
        {GLX_RENDERER_OPENGL_CORE_PROFILE_VERSION_MESA, {0, 0}},
        {GLX_RENDERER_OPENGL_ES_PROFILE_VERSION_MESA, {0, 0}},
        {GLX_RENDERER_OPENGL_ES2_PROFILE_VERSION_MESA, {0, 0}},
    };
    for (const auto& [name, values] : expected) {
        for (const bool current : {false, true}) {
            std::vector<unsigned> found(4, 77u);  // what is not said is left alone
            auto wanted = values;
            wanted.resize(4, 77u);
            EXPECT_TRUE(current ? query_current(name, found.data())
                                : query(display, DefaultScreen(display), 0, name, found.data()))
                << name;
            EXPECT_EQ(found, wanted) << name;
        }
    }
    unsigned value = 77;
    EXPECT_FALSE(query(display, DefaultScreen(display), 0, 0x7777, &value));
    EXPECT_FALSE(query(display, DefaultScreen(display), 1, GLX_RENDERER_ACCELERATED_MESA, &value));
    EXPECT_FALSE(query_current(0x7777, &value));
    EXPECT_EQ(value, 77u);
    for (const auto& [name, wanted] :
         {std::pair{GLX_RENDERER_VENDOR_ID_MESA, GL_VENDOR}, {GLX_RENDERER_DEVICE_ID_MESA, GL_RENDERER}}) {
        const auto* const of_gl = reinterpret_cast<const char*>(glGetString(static_cast<GLenum>(wanted)));
        EXPECT_STREQ(text(display, DefaultScreen(display), 0, name), of_gl);
        EXPECT_STREQ(text_current(name), of_gl);
    }
    EXPECT_EQ(text(display, DefaultScreen(display), 0, GLX_RENDERER_VERSION_MESA), nullptr);
    EXPECT_EQ(text_current(GLX_RENDERER_VERSION_MESA), nullptr);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, ChoosesAsSpecified) {
    int value = 0;
    glXGetFBConfigAttrib(display, config({GLX_STENCIL_SIZE, 1}), GLX_STENCIL_SIZE, &value);
    EXPECT_EQ(value, 8);
    glXGetFBConfigAttrib(display, config({GLX_ALPHA_SIZE, 1}), GLX_ALPHA_SIZE, &value);
    EXPECT_EQ(value, 8);
    glXGetFBConfigAttrib(display, config(), GLX_STENCIL_SIZE, &value);
    EXPECT_EQ(value, 0);
    glXGetFBConfigAttrib(display, config(), GLX_DOUBLEBUFFER, &value);
    EXPECT_EQ(value, 0);
    EXPECT_EQ(config({GLX_SAMPLES, 64}), nullptr);
    EXPECT_EQ(config({GLX_STEREO, 1}), nullptr);
    EXPECT_EQ(config({0x7777, 1}), nullptr);
    int by_id = 0;
    glXGetFBConfigAttrib(display, config({GLX_FBCONFIG_ID, 3}), GLX_FBCONFIG_ID, &by_id);
    EXPECT_EQ(by_id, 3);
    EXPECT_EQ(glXGetFBConfigAttrib(display, config(), 0x7777, &value), GLX_BAD_ATTRIBUTE);

    for (const bool double_buffer : {false, true}) {
        std::vector<int> list{GLX_RGBA, GLX_DEPTH_SIZE, 1};
        if (double_buffer) list.push_back(GLX_DOUBLEBUFFER);
        list.push_back(kNone);
        XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), list.data());
        ASSERT_NE(visual, nullptr);
        EXPECT_EQ(glXGetConfig(display, visual, GLX_DOUBLEBUFFER, &value), 0);
        EXPECT_EQ(value, double_buffer);
        EXPECT_EQ(glXGetConfig(display, visual, GLX_USE_GL, &value), 0);
        EXPECT_EQ(value, 1);
        XFree(visual);
    }
    int color_index[] = {GLX_DEPTH_SIZE, 1, kNone};
    EXPECT_EQ(glXChooseVisual(display, DefaultScreen(display), color_index), nullptr);
}

// GLX 1.4 §3.3.3: all that fit, in the order of what table 3.4 says of them.
TEST_F(Glx, ThoseThatFitComeInTheOrderOfTheSpecification) {
    int count = 0;
    GLXFBConfig* const every = glXGetFBConfigs(display, DefaultScreen(display), &count);
    const std::vector<GLXFBConfig> all(every, every + count);
    XFree(every);
    const auto value = [&](GLXFBConfig of, int name) {
        int out = -1;
        glXGetFBConfigAttrib(display, of, name, &out);
        return out;
    };
    const std::vector<int> colors = {GLX_RED_SIZE, GLX_GREEN_SIZE, GLX_BLUE_SIZE, GLX_ALPHA_SIZE},
                           accums = {GLX_ACCUM_RED_SIZE, GLX_ACCUM_GREEN_SIZE, GLX_ACCUM_BLUE_SIZE,
                                     GLX_ACCUM_ALPHA_SIZE};
    const std::vector<std::map<int, int>> lists = {
        {},
        {{GLX_DEPTH_SIZE, 1}},
        {{GLX_DEPTH_SIZE, 17}},
        {{GLX_ALPHA_SIZE, 1}},
        {{GLX_RED_SIZE, 1}, {GLX_GREEN_SIZE, 1}},
        {{GLX_STENCIL_SIZE, 1}, {GLX_SAMPLES, 1}},
        {{GLX_ACCUM_RED_SIZE, 1}},
        {{GLX_ACCUM_GREEN_SIZE, 1}, {GLX_ACCUM_ALPHA_SIZE, 1}, {GLX_ALPHA_SIZE, 1}},
        {{GLX_BUFFER_SIZE, 30}},
        {{GLX_SAMPLE_BUFFERS, 1}, {GLX_DEPTH_SIZE, 1}},
    };
    for (std::size_t i = 0; i < lists.size(); ++i) {
        SCOPED_TRACE("list " + std::to_string(i));
        const auto& wishes = lists[i];
        std::vector<int> list;
        for (const auto& [name, least] : wishes) list.insert(list.end(), {name, least});
        list.push_back(kNone);
        const auto total = [&](GLXFBConfig of, const std::vector<int>& components) {
            int out = 0;
            for (const int name : components) out += wishes.count(name) ? value(of, name) : 0;
            return out;
        };
        // The smallest comes first.
        const auto place = [&](GLXFBConfig of) {
            return std::vector<int>{-total(of, colors),           value(of, GLX_BUFFER_SIZE),
                                    value(of, GLX_DOUBLEBUFFER),  value(of, GLX_SAMPLE_BUFFERS),
                                    value(of, GLX_SAMPLES),       -value(of, GLX_DEPTH_SIZE),
                                    value(of, GLX_STENCIL_SIZE),  -total(of, accums)};
        };
        std::vector<GLXFBConfig> expected;
        for (const GLXFBConfig one : all) {
            if (std::all_of(wishes.begin(), wishes.end(),
                            [&](const auto& wish) { return value(one, wish.first) >= wish.second; }))
                expected.push_back(one);
        }
        std::stable_sort(expected.begin(), expected.end(),
                         [&](GLXFBConfig a, GLXFBConfig b) { return place(a) < place(b); });
        GLXFBConfig* const some = glXChooseFBConfig(display, DefaultScreen(display), list.data(), &count);
        EXPECT_GT(count, 1);
        EXPECT_EQ(std::vector<GLXFBConfig>(some, some + count), expected);
        XFree(some);
    }
}

TEST_F(Glx, SwapShowsTheBackBuffer) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    for (const Pixel& color : {kRed, kGreen, kBlue}) {
        clear_to(color);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 10, 10);  // the lower left corner
        clear_to(kBlack);
        glDisable(GL_SCISSOR_TEST);
        glFinish();
        EXPECT_NE(shown->pixel(50, 40), color);
        glXSwapBuffers(display, shown->id());
        EXPECT_EQ(shown->pixel(50, 40), color);
        EXPECT_EQ(shown->pixel(0, 0), color);
        EXPECT_EQ(shown->pixel(99, 79), color);
        EXPECT_EQ(shown->pixel(5, 75), kBlack);
        EXPECT_EQ(shown->pixel(10, 69), color);
    }
    unsigned age = 7;
    glXQueryDrawable(display, shown->id(), GLX_BACK_BUFFER_AGE_EXT, &age);
    EXPECT_EQ(age, 1u);
    EXPECT_EQ(read(50, 40), kBlue);
    // What the front shows can be read, and drawn over.
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(read(50, 40), kBlue);
    EXPECT_EQ(read(5, 5), kBlack);
    glDrawBuffer(GL_FRONT);
    clear_to(kGreen);
    EXPECT_EQ(shown->pixel(50, 40), kBlue);
    glFlush();
    EXPECT_EQ(shown->pixel(50, 40), kGreen);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, MultisampledWindowsHaveSmoothEdges) {
    int value = 0;
    glXGetFBConfigAttrib(display, double_buffered(), GLX_SAMPLE_BUFFERS, &value);
    EXPECT_EQ(value, 0);
    const GLXFBConfig chosen =
        config({GLX_DOUBLEBUFFER, 1, GLX_SAMPLE_BUFFERS, 1, GLX_SAMPLES, 2, GLX_STENCIL_SIZE, 8});
    ASSERT_NE(chosen, nullptr);
    glXGetFBConfigAttrib(display, chosen, GLX_SAMPLES, &value);
    EXPECT_EQ(value, 4);
    int list[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_SAMPLES, 4, GLX_DEPTH_SIZE, 16, kNone};
    XVisualInfo* const visual = glXChooseVisual(display, DefaultScreen(display), list);
    ASSERT_NE(visual, nullptr);
    EXPECT_EQ(glXGetConfig(display, visual, GLX_SAMPLES, &value), 0);
    EXPECT_EQ(value, 4);
    XFree(visual);

    const auto shown = window(chosen, 80, 80);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    glGetIntegerv(GL_SAMPLES, &value);
    EXPECT_EQ(value, 4);
    // Two of each pixel's samples lie below its diagonal.
    const Pixel half{128, 0, 0};
    draw_diagonal();
    EXPECT_EQ(read(30, 49), half);
    glXSwapBuffers(display, shown->id());
    EXPECT_EQ(shown->pixel(30, 30), half);
    EXPECT_EQ(shown->pixel(30, 31), kRed);
    EXPECT_EQ(shown->pixel(30, 29), kBlack);
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(read(30, 49), half);
    glDisable(GL_MULTISAMPLE);
    glDrawBuffer(GL_FRONT);
    draw_diagonal();
    glFlush();
    EXPECT_NE(shown->pixel(30, 30), half);
    EXPECT_EQ(shown->pixel(30, 31), kRed);
    shown->resize(40, 40);
    glDrawBuffer(GL_BACK);
    glEnable(GL_MULTISAMPLE);
    glViewport(0, 0, 40, 40);
    draw_diagonal();
    glXSwapBuffers(display, shown->id());
    EXPECT_EQ(shown->pixel(10, 10), half);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, SingleBufferedShowsAtFlush) {
    const GLXFBConfig chosen = single_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    clear_to(kRed);
    EXPECT_NE(shown->pixel(50, 40), kRed);
    glFlush();
    EXPECT_EQ(shown->pixel(50, 40), kRed);
    clear_to(kGreen);
    glXMakeCurrent(display, 0, nullptr);  // as Flush
    EXPECT_EQ(shown->pixel(50, 40), kGreen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    EXPECT_EQ(read(50, 40), kGreen);
    clear_to(kBlue);
    glXWaitGL();
    EXPECT_EQ(shown->pixel(50, 40), kBlue);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, FollowsTheWindowsSize) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen, 64, 64);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    clear_to(kRed);
    glXSwapBuffers(display, shown->id());
    const int sizes[][2] = {{200, 100}, {40, 300}, {63, 65}, {1, 1}, {640, 480}};
    for (const auto& [width, height] : sizes) {
        shown->resize(width, height);
        glViewport(0, 0, width, height);
        clear_to(kGreen);
        // Two triangles that fill the viewport.
        glColor3f(0, 0, 1);
        glRectf(-1, -1, 1, 1);
        glXSwapBuffers(display, shown->id());
        EXPECT_EQ(shown->pixel(width - 1, height - 1), kBlue) << width << "x" << height;
        EXPECT_EQ(shown->pixel(0, 0), kBlue) << width << "x" << height;
        unsigned now = 0;
        glXQueryDrawable(display, shown->id(), GLX_WIDTH, &now);
        EXPECT_EQ(static_cast<int>(now), width);
    }
    glXDestroyContext(display, ctx);
}

// A program that resizes its window and draws on, without a word to GL: the second picture has the new size.
TEST_F(Glx, AYoungWindowIsFollowedWithoutViewport) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen, 32, 32);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    glViewport(0, 0, 300, 200);
    shown->resize(300, 200);
    for (const Pixel& color : {kRed, kGreen}) {
        clear_to(color);
        glXSwapBuffers(display, shown->id());
    }
    EXPECT_EQ(shown->pixel(299, 199), kGreen);
    glXDestroyContext(display, ctx);
}

// Whatever comes first in a picture, it has the window's size.
TEST_F(Glx, PicturesThatBeginWithPixelsFollowTheWindow) {
    const GLXFBConfig chosen = double_buffered();
    const GLXContext ctx = context(chosen);
    const auto draw_pixels = [] {
        const GLubyte green[4] = {0, 255, 0, 255};
        command<void(GLint, GLint)>("glWindowPos2i")(0, 0);
        glPixelZoom(300, 200);
        glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, green);
    };
    const auto draw_bitmap = [] {
        const std::vector<GLubyte> ones(200 * 40, 255);  // rows of 38 bytes, and of 40 with their alignment
        glColor3f(0, 1, 0);
        command<void(GLint, GLint)>("glWindowPos2i")(0, 0);
        glBitmap(300, 200, 0, 0, 0, 0, ones.data());
    };
    const auto blit = [] {
        GLuint object = 0, buffer = 0;
        command<void(GLsizei, GLuint*)>("glGenFramebuffers")(1, &object);
        command<void(GLsizei, GLuint*)>("glGenRenderbuffers")(1, &buffer);
        command<void(GLenum, GLuint)>("glBindFramebuffer")(GL_FRAMEBUFFER, object);
        command<void(GLenum, GLuint)>("glBindRenderbuffer")(GL_RENDERBUFFER, buffer);
        command<void(GLenum, GLenum, GLsizei, GLsizei)>("glRenderbufferStorage")(GL_RENDERBUFFER, GL_RGBA8, 300, 200);
        command<void(GLenum, GLenum, GLenum, GLuint)>("glFramebufferRenderbuffer")(
            GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
        clear_to(kGreen);
        command<void(GLenum, GLuint)>("glBindFramebuffer")(GL_DRAW_FRAMEBUFFER, 0);
        command<void(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum)>("glBlitFramebuffer")(
            0, 0, 300, 200, 0, 0, 300, 200, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        command<void(GLenum, GLuint)>("glBindFramebuffer")(GL_FRAMEBUFFER, 0);
    };
    for (const auto& draw : std::vector<std::function<void()>>{draw_pixels, draw_bitmap, blit}) {
        const auto shown = window(chosen, 32, 32);
        ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
        shown->resize(300, 200);
        for (int i = 0; i < 2; ++i) {
            draw();
            glXSwapBuffers(display, shown->id());
        }
        EXPECT_EQ(shown->pixel(299, 0), kGreen);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
    }
    glXDestroyContext(display, ctx);
}

// A window that changes under a program that never says Viewport again.
TEST_F(Glx, AWindowResizedWhileDrawing) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen, 64, 64);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    for (int i = 0; i < 60; ++i) {
        if (i % 3 == 0) XResizeWindow(display, shown->id(), 20 + 37u * unsigned(i) % 500, 20 + 53u * unsigned(i) % 400);
        clear_to(i % 2 ? kRed : kGreen);
        glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
        glXSwapBuffers(display, shown->id());
    }
    glXWaitX();
    clear_to(kBlue);
    glXSwapBuffers(display, shown->id());
    EXPECT_EQ(shown->pixel(0, 0), kBlue);
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, PbuffersAndSeparateReadDrawables) {
    const GLXFBConfig chosen = double_buffered();
    const int small[] = {GLX_PBUFFER_WIDTH, 33, GLX_PBUFFER_HEIGHT, 17, kNone};
    const GLXPbuffer one = glXCreatePbuffer(display, chosen, small), two = glXCreatePbuffer(display, chosen, small);
    ASSERT_NE(one, 0u);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeContextCurrent(display, one, one, ctx));
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], 33);
    EXPECT_EQ(viewport[3], 17);
    clear_to(kRed);
    ASSERT_TRUE(glXMakeContextCurrent(display, two, one, ctx));
    clear_to(kGreen);
    EXPECT_EQ(read(32, 16), kRed);
    EXPECT_EQ(glXGetCurrentReadDrawable(), one);
    ASSERT_TRUE(glXMakeContextCurrent(display, two, two, ctx));
    EXPECT_EQ(read(32, 16), kGreen);
    glXSwapBuffers(display, two);
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(read(0, 0), kGreen);
    unsigned value = 0;
    glXQueryDrawable(display, two, GLX_HEIGHT, &value);
    EXPECT_EQ(value, 17u);
    glXDestroyPbuffer(display, one);
    glXDestroyPbuffer(display, two);
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyPbuffer(display, two);
    EXPECT_NE(take_x_error(), 0);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, PixmapsAreDrawnToAndBecomeTextures) {
    const GLXFBConfig chosen =
        config({GLX_DOUBLEBUFFER, 0, GLX_DRAWABLE_TYPE, GLX_PIXMAP_BIT, GLX_BIND_TO_TEXTURE_RGB_EXT, 1});
    const auto shown = window(chosen, 32, 32);
    const Pixmap pixmap = XCreatePixmap(display, shown->id(), 16, 16, 24);
    const int list[] = {GLX_TEXTURE_FORMAT_EXT, GLX_TEXTURE_FORMAT_RGB_EXT, GLX_TEXTURE_TARGET_EXT, GLX_TEXTURE_2D_EXT,
                        kNone};
    const GLXPixmap drawable = glXCreatePixmap(display, chosen, pixmap, list);
    ASSERT_NE(drawable, 0u);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeContextCurrent(display, drawable, drawable, ctx));
    clear_to(kGreen);
    glFlush();
    XImage* const image = XGetImage(display, pixmap, 3, 3, 1, 1, ~0ul, ZPixmap);
    EXPECT_EQ(XGetPixel(image, 0, 0) & 0xffffff, 0x00ff00ul);
    XDestroyImage(image);

    // What X draws to it is the texture: red above, blue below.
    const GC gc = XCreateGC(display, pixmap, 0, nullptr);
    XSetForeground(display, gc, 0xff0000);
    XFillRectangle(display, pixmap, gc, 0, 0, 16, 8);
    XSetForeground(display, gc, 0x0000ff);
    XFillRectangle(display, pixmap, gc, 0, 8, 16, 8);
    ASSERT_TRUE(glXMakeContextCurrent(display, shown->id(), shown->id(), ctx));
    const auto bind = command<void(Display*, GLXDrawable, int, const int*)>("glXBindTexImageEXT");
    ASSERT_NE(bind, nullptr);
    bind(display, drawable, GLX_FRONT_LEFT_EXT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glViewport(0, 0, 32, 32);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        glTexCoord2i(x, y);
        glVertex2i(2 * x - 1, 2 * y - 1);
    }
    glEnd();
    EXPECT_EQ(read(16, 31), kRed);
    EXPECT_EQ(read(16, 0), kBlue);
    command<void(Display*, GLXDrawable, int)>("glXReleaseTexImageEXT")(display, drawable, GLX_FRONT_LEFT_EXT);
    glXDestroyPixmap(display, drawable);
    glXMakeCurrent(display, 0, nullptr);
    glXDestroyContext(display, ctx);
    XFreeGC(display, gc);
    XFreePixmap(display, pixmap);
    EXPECT_EQ(take_x_error(), 0);
}

TEST_F(Glx, ContextsShareAndCopy) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext one = context(chosen), two = context(chosen, one), alone = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), one));
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glEndList();
    glLineWidth(5);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), two));
    EXPECT_TRUE(glIsTexture(texture));
    EXPECT_TRUE(glIsList(list));
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), alone));
    EXPECT_FALSE(glIsTexture(texture));
    EXPECT_FALSE(glIsList(list));
    GLfloat width = 0;
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), one));
    glXCopyContext(display, one, two, GL_LINE_BIT);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), two));
    glGetFloatv(GL_LINE_WIDTH, &width);
    EXPECT_EQ(width, 5);
    EXPECT_EQ(take_x_error(), 0);
    glXCopyContext(display, one, two, GL_LINE_BIT);  // to a context that is current
    EXPECT_EQ(take_x_error(), BadAccess);
    for (const GLXContext ctx : {one, two, alone}) glXDestroyContext(display, ctx);
}

TEST_F(Glx, CreateContextAttribs) {
    const auto create = command<GLXContext(Display*, GLXFBConfig, GLXContext, int, const int*)>(
        "glXCreateContextAttribsARB");
    ASSERT_NE(create, nullptr);
    const GLXFBConfig chosen = double_buffered();
    const int old[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 1, GLX_CONTEXT_MINOR_VERSION_ARB, 0, kNone};
    const GLXContext ctx = create(display, chosen, nullptr, 1, old);
    EXPECT_NE(ctx, nullptr);
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyContext(display, ctx);
    const int no_version[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 1, GLX_CONTEXT_MINOR_VERSION_ARB, 7, kNone};
    EXPECT_EQ(create(display, chosen, nullptr, 1, no_version), nullptr);
    EXPECT_EQ(take_x_error(), BadMatch);
    const int unknown[] = {0x7777, 1, kNone};
    EXPECT_EQ(create(display, chosen, nullptr, 1, unknown), nullptr);
    EXPECT_EQ(take_x_error(), BadValue);
    const int too_new[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 0, kNone};
    EXPECT_EQ(create(display, chosen, nullptr, 1, too_new), nullptr);
    EXPECT_NE(take_x_error(), 0);
}

TEST_F(Glx, ErrorsOfTheSpecification) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    EXPECT_FALSE(glXMakeCurrent(display, 0x1234567, ctx));
    EXPECT_NE(take_x_error(), 0);
    EXPECT_FALSE(glXMakeContextCurrent(display, shown->id(), 0, ctx));
    EXPECT_EQ(take_x_error(), BadMatch);
    EXPECT_FALSE(glXMakeCurrent(display, shown->id(), nullptr));
    EXPECT_EQ(take_x_error(), BadMatch);
    EXPECT_EQ(glXCreateWindow(display, chosen, 0x1234567, nullptr), 0u);
    EXPECT_EQ(take_x_error(), BadWindow);
    EXPECT_EQ(glXCreatePixmap(display, chosen, 0x1234567, nullptr), 0u);
    EXPECT_EQ(take_x_error(), BadPixmap);
    // The message goes to the program and not through the connection: no more is needed of the server.
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    std::thread([&] { EXPECT_FALSE(glXMakeCurrent(display, shown->id(), ctx)); }).join();
    EXPECT_EQ(take_x_error(), BadAccess);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, TwoThreadsWithAContextEach) {
    const GLXFBConfig chosen = double_buffered();
    std::vector<std::thread> threads;
    for (int t = 0; t < 2; ++t) {
        threads.emplace_back([&, t] {
            Display* const own = XOpenDisplay(nullptr);
            int list[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, kNone};
            XVisualInfo* const visual = glXChooseVisual(own, DefaultScreen(own), list);
            const GLXContext ctx = glXCreateContext(own, visual, nullptr, 1);
            {
                const XWindow shown(own, *visual, 120, 90);
                ASSERT_TRUE(glXMakeCurrent(own, shown.id(), ctx));
                const Pixel color = t ? kRed : kBlue;
                for (int i = 0; i < 50; ++i) {
                    clear_to(kBlack);
                    glColor3f(t ? 1.0f : 0.0f, 0, t ? 0.0f : 1.0f);
                    glRectf(-1, -1, 1, 1);
                    EXPECT_EQ(read(60, 45), color);
                    glXSwapBuffers(own, shown.id());
                }
                glXMakeCurrent(own, 0, nullptr);
            }
            glXDestroyContext(own, ctx);
            XFree(visual);
            XCloseDisplay(own);
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_NE(chosen, nullptr);
}

TEST_F(Glx, AContextPassedBetweenThreads) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    clear_to(kRed);
    glColor3f(0, 1, 0);
    for (int i = 0; i < 10; ++i) {
        glXMakeCurrent(display, 0, nullptr);
        std::thread([&] {
            ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
            GLfloat color[4];
            glGetFloatv(GL_CURRENT_COLOR, color);
            EXPECT_EQ(color[1], 1);
            EXPECT_EQ(read(50, 40), kRed);
            if (i % 2) glXMakeCurrent(display, 0, nullptr);  // else the thread's end lets go of it
        }).join();
        ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
        EXPECT_EQ(read(50, 40), kRed);
    }
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, TheDisplayIsClosedUnderAContext) {
    const GLXFBConfig chosen = double_buffered();
    auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    clear_to(kRed);
    glXSwapBuffers(display, shown->id());
    shown->forget();
    XCloseDisplay(display);
    // Nobody sees it any more; libglvnd may have taken the context away.
    clear_to(kGreen);
    glFlush();
    read(50, 40);
    display = XOpenDisplay(nullptr);
    ASSERT_NE(display, nullptr);
    const GLXFBConfig again = double_buffered();
    const auto other = window(again);
    const GLXContext new_ctx = context(again);
    ASSERT_TRUE(glXMakeCurrent(display, other->id(), new_ctx));
    clear_to(kBlue);
    glXSwapBuffers(display, other->id());
    EXPECT_EQ(other->pixel(50, 40), kBlue);
    glXDestroyContext(display, new_ctx);
}

TEST_F(Glx, AWindowDestroyedUnderAContext) {
    const GLXFBConfig chosen = double_buffered();
    auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    const Window name = shown->id();
    shown.reset();
    for (int i = 0; i < 3; ++i) {
        clear_to(kGreen);
        EXPECT_EQ(read(50, 40), kGreen);
        glXSwapBuffers(display, name);
    }
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, SwapIntervalsAndCounters) {
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen, 8, 8);
    const GLXContext ctx = context(chosen);
    const auto sgi = command<int(int)>("glXSwapIntervalSGI");
    const auto ext = command<void(Display*, GLXDrawable, int)>("glXSwapIntervalEXT");
    const auto mesa = command<int(unsigned)>("glXSwapIntervalMESA");
    const auto get = command<int()>("glXGetSwapIntervalMESA");
    const auto values = command<int(Display*, GLXDrawable, std::int64_t*, std::int64_t*, std::int64_t*)>(
        "glXGetSyncValuesOML");
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    EXPECT_EQ(get(), 0);
    std::int64_t ust = 0, msc = 0, sbc = 0, end = 0;
    EXPECT_EQ(mesa(2), 0);
    EXPECT_EQ(get(), 2);
    ASSERT_TRUE(values(display, shown->id(), &ust, &msc, &sbc));
    EXPECT_EQ(sbc, 0);
    for (int i = 0; i < 4; ++i) glXSwapBuffers(display, shown->id());
    ASSERT_TRUE(values(display, shown->id(), &ust, &end, &sbc));
    EXPECT_EQ(sbc, 4);
    EXPECT_GE(end - msc, 7);  // four swaps, two refreshes each, less the one that is under way
    EXPECT_EQ(sgi(0), GLX_BAD_VALUE);
    EXPECT_EQ(sgi(1), 0);
    EXPECT_EQ(get(), 1);
    EXPECT_EQ(mesa(0x8000), GLX_BAD_VALUE);
    EXPECT_EQ(get(), 1);
    EXPECT_EQ(mesa(0x7fff), 0);
    EXPECT_EQ(get(), 0x7fff);
    ext(display, shown->id(), 0);
    unsigned interval = 9;
    glXQueryDrawable(display, shown->id(), GLX_SWAP_INTERVAL_EXT, &interval);
    EXPECT_EQ(interval, 0u);
    glXDestroyContext(display, ctx);
}

TEST_F(Glx, FontsBecomeBitmaps) {
    const Font font = XLoadFont(display, "fixed");
    if (take_x_error() != 0) GTEST_SKIP() << "the server has no font";
    const GLXFBConfig chosen = double_buffered();
    const auto shown = window(chosen);
    const GLXContext ctx = context(chosen);
    ASSERT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
    const GLuint base = glGenLists(128);
    glXUseXFont(font, 32, 96, static_cast<int>(base) + 32);
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    clear_to(kBlack);
    glOrtho(0, 100, 0, 80, -1, 1);
    glColor3f(0, 1, 0);
    glRasterPos2i(10, 20);
    glListBase(base);
    glCallLists(5, GL_UNSIGNED_BYTE, "HLLHi");
    GLfloat position[4];
    glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
    EXPECT_GE(position[0], 10 + 5 * 4);
    std::vector<GLubyte> pixels(100 * 80 * 4);
    glReadPixels(0, 0, 100, 80, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    int green = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) green += pixels[i + 1] == 255;
    EXPECT_GT(green, 30);
    EXPECT_LT(green, 500);
    glXDestroyContext(display, ctx);
    XUnloadFont(display, font);
}

TEST_F(Glx, EveryExtensionsFunctionsAreThere) {
    const std::string extensions = glXQueryExtensionsString(display, DefaultScreen(display));
    for (const char* wanted :
         {"GLX_ARB_create_context ", "GLX_ARB_get_proc_address ", "GLX_EXT_buffer_age ", "GLX_EXT_swap_control ",
          "GLX_EXT_texture_from_pixmap ", "GLX_SGIX_fbconfig ", "GLX_SGIX_pbuffer ", "GLX_SGI_make_current_read "})
        EXPECT_NE((extensions + " ").find(wanted), std::string::npos) << wanted;
    for (const char* name : {"glXSwapIntervalSGI", "glXWaitForMscOML", "glXCreateGLXPbufferSGIX", "glXCopySubBufferMESA",
                             "glXGetVideoSyncSGI", "glBegin", "glXQueryRendererIntegerMESA"})
        EXPECT_NE(command<void()>(name), nullptr) << name;
}

}  // namespace
}  // namespace terrazzo::test
