// Colours that display lists push, set and pop, as LDView's lists of parts do: what is drawn with them, and
// what the current colour and the material are afterwards (GL 1.5 §5.4, §6.1.14, §2.14.3). The reference
// loses them.
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "attach_picture.h"
#include "gl_fixture.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 8;
using Color = std::array<int, 3>;
constexpr Color kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255}, kWhite{255, 255, 255}, kBlack{0, 0, 0};
enum List : GLuint { kPart = 1, kInner, kOuter };

// How the lists come to be drawn.
enum class Way { kCompiled, kCompiledAndExecuted, kByCallLists };

class ListColors : public GlTest, public testing::WithParamInterface<Way> {
  protected:
    ListColors() {
        attach_picture(ctx(), kSize, kSize);
        glMatrixMode(GL_PROJECTION);
        glOrtho(0, kSize, 0, kSize, -1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }

    static void set(const Color& color) {
        glColor3ub(static_cast<GLubyte>(color[0]), static_cast<GLubyte>(color[1]),
                   static_cast<GLubyte>(color[2]));
    }
    // Column x of the picture, with whatever is current.
    static void column(int x) {
        glBegin(GL_QUADS);
        glNormal3f(0, 0, 1);
        glVertex2i(x, 0);
        glVertex2i(x + 1, 0);
        glVertex2i(x + 1, kSize);
        glVertex2i(x, kSize);
        glEnd();
    }
    static void pushed(const std::function<void()>& body) {
        glPushAttrib(GL_CURRENT_BIT);
        body();
        glPopAttrib();
    }
    static void define(GLuint list, const std::function<void()>& body) {
        glNewList(list, GL_COMPILE);
        body();
        glEndList();
    }
    // Draws the commands of a last list, which may call others.
    static void draw(const std::function<void()>& body) {
        glNewList(kOuter, GetParam() == Way::kCompiledAndExecuted ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
        body();
        glEndList();
        const GLuint name = kOuter;
        if (GetParam() == Way::kCompiled) glCallList(name);
        if (GetParam() == Way::kByCallLists) glCallLists(1, GL_UNSIGNED_INT, &name);
    }

    static Color pixel(int x) {
        std::array<GLubyte, 4> rgba;
        glReadPixels(x, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return {rgba[0], rgba[1], rgba[2]};
    }
    static Color current() {
        std::array<GLfloat, 4> color;
        glGetFloatv(GL_CURRENT_COLOR, color.data());
        return {static_cast<int>(color[0] * 255), static_cast<int>(color[1] * 255),
                static_cast<int>(color[2] * 255)};
    }
    static Color material(GLenum pname) {
        std::array<GLfloat, 4> color;
        glGetMaterialfv(GL_FRONT, pname, color.data());
        return {static_cast<int>(color[0] * 255), static_cast<int>(color[1] * 255),
                static_cast<int>(color[2] * 255)};
    }
};

TEST_P(ListColors, PoppedColorsAreThoseOfBefore) {
    set(kBlue);
    draw([] {
        column(0);
        pushed([] {
            set(kRed);
            column(1);
        });
        column(2);
        set(kGreen);
        column(3);
        pushed([] { set(kRed); });
        column(4);
    });
    EXPECT_EQ(current(), kGreen);
    column(5);
    EXPECT_EQ(pixel(0), kBlue);
    EXPECT_EQ(pixel(1), kRed);
    EXPECT_EQ(pixel(2), kBlue);
    EXPECT_EQ(pixel(3), kGreen);
    EXPECT_EQ(pixel(4), kGreen);
    EXPECT_EQ(pixel(5), kGreen);
    EXPECT_EQ(pixel(6), kBlack);
}

// The colour that a list begins with is the one of its call.
TEST_P(ListColors, PartsTakeTheColorOfTheirCall) {
    define(kPart, [] {
        column(0);
        glTranslatef(1, 0, 0);
    });
    set(kWhite);
    draw([] {
        for (const Color& color : {kRed, kGreen}) {
            pushed([&] {
                set(color);
                glCallList(kPart);
            });
        }
        glCallList(kPart);
    });
    EXPECT_EQ(pixel(0), kRed);
    EXPECT_EQ(pixel(1), kGreen);
    EXPECT_EQ(pixel(2), kWhite);
    EXPECT_EQ(current(), kWhite);
}

TEST_P(ListColors, ColorsOfNestedListsStayUnlessTheyArePopped) {
    define(kPart, [] {
        set(kRed);
        column(1);
    });
    define(kInner, [] { pushed([] { glCallList(kPart); }); });
    set(kBlue);
    draw([] {
        column(0);
        glCallList(kInner);
        column(2);
        glCallList(kPart);
        column(3);
        pushed([] {
            pushed([] {
                set(kGreen);
                glCallList(kInner);
                column(4);
            });
            column(5);
        });
        column(6);
    });
    EXPECT_EQ(pixel(0), kBlue);
    EXPECT_EQ(pixel(1), kRed);
    EXPECT_EQ(pixel(2), kBlue);
    EXPECT_EQ(pixel(3), kRed);
    EXPECT_EQ(pixel(4), kGreen);
    EXPECT_EQ(pixel(5), kRed);
    EXPECT_EQ(pixel(6), kRed);
    EXPECT_EQ(current(), kRed);
}

// A push in one list and its pop in another.
TEST_P(ListColors, PushAndPopMayBeInListsOfTheirOwn) {
    define(kPart, [] { glPushAttrib(GL_CURRENT_BIT); });
    define(kInner, [] { glPopAttrib(); });
    set(kBlue);
    draw([] {
        glCallList(kPart);
        set(kRed);
        column(0);
        glCallList(kInner);
        column(1);
    });
    EXPECT_EQ(pixel(0), kRed);
    EXPECT_EQ(pixel(1), kBlue);
}

TEST_P(ListColors, ColorsBetweenBeginAndEndAreCurrentAfterwards) {
    set(kBlue);
    draw([] {
        pushed([] {
            glBegin(GL_QUADS);
            for (const Color& color : {kBlue, kBlue, kBlue, kRed}) {
                set(color);
                glVertex2i(0, 0);
            }
            glEnd();
            column(0);
        });
        column(1);
    });
    EXPECT_EQ(pixel(0), kRed);
    EXPECT_EQ(pixel(1), kBlue);
}

// The material follows the colour where it is set, and where it is popped it is as it was: GL_CURRENT_BIT has
// the colour, and the material is GL_LIGHTING_BIT's.
TEST_P(ListColors, MaterialsFollowPushedColors) {
    const GLfloat white[] = {1, 1, 1, 1}, none[] = {0, 0, 0, 1};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, white);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, none);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT);
    glEnable(GL_COLOR_MATERIAL);
    set(kBlue);
    define(kPart, [] {
        set(kGreen);
        column(2);
    });
    draw([] {
        column(0);
        pushed([] {
            set(kRed);
            column(1);
            glCallList(kPart);
        });
        set(kBlue);
        column(3);
        glPushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT);
        set(kRed);
        column(4);
        glPopAttrib();
        column(5);
    });
    EXPECT_EQ(pixel(0), kBlue);
    EXPECT_EQ(pixel(1), kRed);
    EXPECT_EQ(pixel(2), kGreen);
    EXPECT_EQ(pixel(3), kBlue);
    EXPECT_EQ(pixel(4), kRed);
    EXPECT_EQ(pixel(5), kBlue);
    EXPECT_EQ(material(GL_AMBIENT), kBlue);
}

// Part of the attributes: normals, texture coordinates and secondary colours go with the colour.
TEST_P(ListColors, EverythingCurrentIsPopped) {
    glNormal3f(1, 0, 0);
    glTexCoord2f(0.5f, 0.25f);
    glEdgeFlag(GL_FALSE);
    draw([] {
        pushed([] {
            glNormal3f(0, 1, 0);
            glTexCoord2f(0, 0);
            glEdgeFlag(GL_TRUE);
            column(0);
        });
    });
    std::array<GLfloat, 4> normal{}, texture{};
    glGetFloatv(GL_CURRENT_NORMAL, normal.data());
    glGetFloatv(GL_CURRENT_TEXTURE_COORDS, texture.data());
    EXPECT_EQ(normal[0], 1);
    EXPECT_EQ(texture[0], 0.5f);
    EXPECT_EQ(texture[1], 0.25f);
    GLboolean flag = GL_TRUE;
    glGetBooleanv(GL_EDGE_FLAG, &flag);
    EXPECT_FALSE(flag);
}

INSTANTIATE_TEST_SUITE_P(Ways, ListColors,
                         testing::Values(Way::kCompiled, Way::kCompiledAndExecuted, Way::kByCallLists),
                         [](const auto& info) {
                             switch (info.param) {
                                 case Way::kCompiled:
                                     return "Compiled";
                                 case Way::kCompiledAndExecuted:
                                     return "CompiledAndExecuted";
                                 default:
                                     return "ByCallLists";
                             }
                         });

}  // namespace
}  // namespace terrazzo::gl
