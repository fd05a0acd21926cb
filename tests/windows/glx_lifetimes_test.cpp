// What outlives what in GLX: contexts destroyed while they are current, windows destroyed under their
// GLXWindow; and which contexts are made, and refused, for a list of attributes.
#include "glx_fixture.h"

namespace terrazzo::test {
namespace {

// Of GLX's protocol: an error's number counts from the first that the server has set aside for GLX.
constexpr int kBadFBConfig = 9, kBadGlxWindow = 12, kBadProfile = 13;

class GlxLife : public Glx {
  protected:
    void SetUp() override {
        Glx::SetUp();
        chosen = double_buffered();
        ASSERT_NE(chosen, nullptr);
        int opcode = 0, event = 0;
        has_glx = XQueryExtension(display, "GLX", &opcode, &event, &first_error);
    }
    std::unique_ptr<XWindow> window() { return Glx::window(chosen, 60, 50); }
    // The number that the server has set aside for an error of GLX.
    int glx_error(int error) const { return first_error + error; }

    GLXFBConfig chosen = nullptr;
    bool has_glx = false;
    int first_error = 0;
};

// GLX 1.4 §3.3.7: it is destroyed when it is no longer current, and a context until then.
TEST_F(GlxLife, AContextDestroyedWhileCurrentIsOneUntilItIsLetGoOf) {
    const auto one = window();
    const GLXContext ctx = glXCreateNewContext(display, chosen, GLX_RGBA_TYPE, nullptr, 1);
    ASSERT_TRUE(glXMakeCurrent(display, one->id(), ctx));
    clear_to(kRed);
    glXDestroyContext(display, ctx);
    ASSERT_TRUE(glXMakeCurrent(display, one->id(), ctx));
    clear_to(kGreen);
    EXPECT_EQ(read(1, 1), kGreen);
    glXSwapBuffers(display, one->id());
    EXPECT_EQ(one->pixel(1, 1), kGreen);
    EXPECT_TRUE(glXIsDirect(display, ctx));
    glXDestroyContext(display, ctx);  // once more
    EXPECT_EQ(take_x_error(), 0);
    EXPECT_EQ(glXGetCurrentContext(), ctx);
    clear_to(kBlue);
    EXPECT_EQ(read(1, 1), kBlue);
    ASSERT_TRUE(glXMakeCurrent(display, 0, nullptr));
    EXPECT_EQ(take_x_error(), 0);
    // Now it is gone.
    EXPECT_FALSE(glXMakeCurrent(display, one->id(), ctx));
    EXPECT_NE(take_x_error(), 0);
}

// Windows are not counted as pixmaps are: the GLXWindow goes with its window.
TEST_F(GlxLife, AGlxWindowGoesWithItsWindow) {
    {
        const auto shown = window();
        const GLXWindow name = glXCreateWindow(display, chosen, shown->id(), nullptr);
        glXDestroyWindow(display, name);
        XWindowAttributes attributes;
        EXPECT_TRUE(XGetWindowAttributes(display, shown->id(), &attributes));
        EXPECT_EQ(take_x_error(), 0);
        glXDestroyWindow(display, name);
        EXPECT_NE(take_x_error(), 0);
    }
    auto shown = window();
    const GLXWindow name = glXCreateWindow(display, chosen, shown->id(), nullptr);
    shown.reset();
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyWindow(display, name);
    EXPECT_EQ(take_x_error(), has_glx ? glx_error(kBadGlxWindow) : BadWindow);
}

struct Attempt {
    const char* text;
    std::vector<int> list;
    int core_error, glx_error;  // -1: none
};

// GLX_ARB_create_context, ..._profile and ..._no_error.
TEST_F(GlxLife, ContextAttributesAreCheckedAsSpecified) {
    const auto create =
        command<GLXContext(Display*, GLXFBConfig, GLXContext, int, const int*)>("glXCreateContextAttribsARB");
    ASSERT_NE(create, nullptr);
    constexpr int kMajor = GLX_CONTEXT_MAJOR_VERSION_ARB, kMinor = GLX_CONTEXT_MINOR_VERSION_ARB,
                  kFlags = GLX_CONTEXT_FLAGS_ARB, kMask = GLX_CONTEXT_PROFILE_MASK_ARB,
                  kCore = GLX_CONTEXT_CORE_PROFILE_BIT_ARB,
                  kCompatible = GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB,
                  kForward = GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB, kDebug = GLX_CONTEXT_DEBUG_BIT_ARB,
                  kRobust = GLX_CONTEXT_ROBUST_ACCESS_BIT_ARB, kNoError = GLX_CONTEXT_OPENGL_NO_ERROR_ARB,
                  kReset = GLX_CONTEXT_RESET_NOTIFICATION_STRATEGY_ARB,
                  kRelease = GLX_CONTEXT_RELEASE_BEHAVIOR_ARB;
    const Attempt attempts[] = {
        {"nothing asked for", {}, -1, -1},
        {"the first version", {kMajor, 1, kMinor, 0}, -1, -1},
        {"the last version", {kMajor, 1, kMinor, 5}, -1, -1},
        {"only a major version", {kMajor, 1}, -1, -1},
        {"a debugged one", {kFlags, kDebug}, -1, -1},
        {"no flags", {kFlags, 0}, -1, -1},
        {"a profile before there were any", {kMask, kCore}, -1, -1},
        {"the other profile", {kMajor, 1, kMinor, 5, kMask, kCompatible}, -1, -1},
        {"render type", {GLX_RENDER_TYPE, GLX_RGBA_TYPE}, -1, -1},
        {"reset strategy", {kReset, GLX_LOSE_CONTEXT_ON_RESET_ARB}, -1, -1},
        {"release behaviour", {kRelease, GLX_CONTEXT_RELEASE_BEHAVIOR_NONE_ARB}, -1, -1},
        {"no errors wanted", {kNoError, 1}, -1, -1},
        {"the configuration's screen", {GLX_SCREEN, DefaultScreen(display)}, -1, -1},

        {"an unknown attribute", {0x7777, 1}, BadValue, -1},
        {"an attribute of configurations", {GLX_SAMPLES, 4}, BadValue, -1},
        {"a screen that is none", {GLX_SCREEN, ScreenCount(display)}, BadValue, -1},
        {"a screen below zero", {GLX_SCREEN, -1}, BadValue, -1},
        {"an unknown flag", {kFlags, 0x100}, BadValue, -1},
        {"an unknown reset strategy", {kReset, 1}, BadValue, -1},
        {"an unknown release behaviour", {kRelease, 77}, BadValue, -1},
        {"an unknown render type", {GLX_RENDER_TYPE, 77}, BadValue, -1},
        {"colour indices", {GLX_RENDER_TYPE, GLX_COLOR_INDEX_TYPE}, BadMatch, -1},
        {"no version 0", {kMajor, 0}, BadMatch, -1},
        {"no negative version", {kMajor, -1}, BadMatch, -1},
        {"no negative minor version", {kMajor, 1, kMinor, -1}, BadMatch, -1},
        {"no version 1.6", {kMajor, 1, kMinor, 6}, BadMatch, -1},
        {"no version 2.2", {kMajor, 2, kMinor, 2}, BadMatch, -1},
        {"no version 3.4", {kMajor, 3, kMinor, 4}, BadMatch, -1},
        {"no version 4.7", {kMajor, 4, kMinor, 7}, BadMatch, -1},
        {"no version 5", {kMajor, 5}, BadMatch, -1},
        {"forward compatible before there was any", {kFlags, kForward}, BadMatch, -1},
        {"no errors but debugging", {kNoError, 1, kFlags, kDebug}, BadMatch, -1},
        {"no errors but robust", {kNoError, 1, kFlags, kRobust}, BadMatch, -1},

        {"no profile", {kMajor, 3, kMinor, 2, kMask, 0}, -1, kBadProfile},
        {"both profiles", {kMajor, 3, kMinor, 2, kMask, kCore | kCompatible}, -1, kBadProfile},
        {"an unknown profile", {kMajor, 3, kMinor, 2, kMask, 0x100}, -1, kBadProfile},
        {"OpenGL ES", {kMajor, 2, kMinor, 0, kMask, 4}, -1, kBadProfile},
        {"no profile before there were any", {kMask, 0}, -1, kBadProfile},

        {"a version that is not there", {kMajor, 2, kMinor, 0}, -1, kBadFBConfig},
        {"one with profiles", {kMajor, 3, kMinor, 2, kMask, kCompatible}, -1, kBadFBConfig},
        {"the core of one", {kMajor, 4, kMinor, 6, kMask, kCore}, -1, kBadFBConfig},
        {"forward compatible", {kMajor, 3, kMinor, 0, kFlags, kForward}, -1, kBadFBConfig},
    };
    const auto shown = window();
    for (const Attempt& attempt : attempts) {
        SCOPED_TRACE(attempt.text);
        std::vector<int> list = attempt.list;
        list.push_back(kNone);
        const GLXContext ctx = create(display, chosen, nullptr, 1, list.data());
        const int error = take_x_error();
        if (attempt.core_error < 0 && attempt.glx_error < 0) {
            ASSERT_NE(ctx, nullptr);
            EXPECT_EQ(error, 0);
            EXPECT_TRUE(glXMakeCurrent(display, shown->id(), ctx));
            glXMakeCurrent(display, 0, nullptr);
            glXDestroyContext(display, ctx);
            continue;
        }
        EXPECT_EQ(ctx, nullptr);
        const int expected = attempt.core_error >= 0 ? attempt.core_error
                             : has_glx               ? glx_error(attempt.glx_error)
                                                     : BadValue;
        EXPECT_EQ(error, expected);
    }
    // What is shared with must be a context; null for a list is an empty one.
    EXPECT_EQ(create(display, chosen, reinterpret_cast<GLXContext>(0x12345670), 1, nullptr), nullptr);
    EXPECT_NE(take_x_error(), 0);
    const GLXContext plain = create(display, chosen, nullptr, 1, nullptr);
    EXPECT_NE(plain, nullptr);
    EXPECT_EQ(take_x_error(), 0);
    glXDestroyContext(display, plain);
}

}  // namespace
}  // namespace terrazzo::test
