// Commands that take a parameter's name and its values read as many values as the parameter has, and none of
// a name that they do not know; queries write no more. The same in display lists, whose records keep no more
// either.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include "gl/generated/thunks.h"
#include "gl_fixture.h"
#include "guarded_memory.h"

namespace terrazzo::gl {
namespace {

constexpr GLenum kNames = 0x10000;

template <typename Value>
struct Setter {
    const char* name;
    ParameterCount (*count)(GLenum);
    void (*call)(GLenum pname, const Value* values);
};

template <typename Value>
struct Query {
    const char* name;
    ParameterCount (*count)(GLenum);
    void (*call)(GLenum pname, Value* values);
};

constexpr Setter<GLfloat> kFloatSetters[] = {
    {"glFogfv", thunk::fog_count, [](GLenum p, const GLfloat* v) { glFogfv(p, v); }},
    {"glLightfv", thunk::light_count, [](GLenum p, const GLfloat* v) { glLightfv(GL_LIGHT1, p, v); }},
    {"glLightModelfv", thunk::light_model_count, [](GLenum p, const GLfloat* v) { glLightModelfv(p, v); }},
    {"glMaterialfv", thunk::material_count, [](GLenum p, const GLfloat* v) { glMaterialfv(GL_BACK, p, v); }},
    {"glPointParameterfv", thunk::point_parameter_count,
     [](GLenum p, const GLfloat* v) { glPointParameterfv(p, v); }},
    {"glTexEnvfv", thunk::tex_env_count,
     [](GLenum p, const GLfloat* v) { glTexEnvfv(GL_TEXTURE_ENV, p, v); }},
    {"glTexEnvfv of filters", thunk::tex_env_count,
     [](GLenum p, const GLfloat* v) { glTexEnvfv(GL_TEXTURE_FILTER_CONTROL, p, v); }},
    {"glTexEnvfv of sprites", thunk::tex_env_count,
     [](GLenum p, const GLfloat* v) { glTexEnvfv(GL_POINT_SPRITE, p, v); }},
    {"glTexGenfv", thunk::tex_gen_count, [](GLenum p, const GLfloat* v) { glTexGenfv(GL_S, p, v); }},
    {"glTexParameterfv", thunk::tex_parameter_count,
     [](GLenum p, const GLfloat* v) { glTexParameterfv(GL_TEXTURE_2D, p, v); }},
};

constexpr Setter<GLint> kIntegerSetters[] = {
    {"glFogiv", thunk::fog_count, [](GLenum p, const GLint* v) { glFogiv(p, v); }},
    {"glLightiv", thunk::light_count, [](GLenum p, const GLint* v) { glLightiv(GL_LIGHT1, p, v); }},
    {"glLightModeliv", thunk::light_model_count, [](GLenum p, const GLint* v) { glLightModeliv(p, v); }},
    {"glMaterialiv", thunk::material_count, [](GLenum p, const GLint* v) { glMaterialiv(GL_BACK, p, v); }},
    {"glPointParameteriv", thunk::point_parameter_count,
     [](GLenum p, const GLint* v) { glPointParameteriv(p, v); }},
    {"glTexEnviv", thunk::tex_env_count, [](GLenum p, const GLint* v) { glTexEnviv(GL_TEXTURE_ENV, p, v); }},
    {"glTexGeniv", thunk::tex_gen_count, [](GLenum p, const GLint* v) { glTexGeniv(GL_S, p, v); }},
    {"glTexParameteriv", thunk::tex_parameter_count,
     [](GLenum p, const GLint* v) { glTexParameteriv(GL_TEXTURE_2D, p, v); }},
};

constexpr Setter<GLdouble> kDoubleSetters[] = {
    {"glTexGendv", thunk::tex_gen_count, [](GLenum p, const GLdouble* v) { glTexGendv(GL_T, p, v); }},
};

constexpr Query<GLfloat> kFloatQueries[] = {
    {"glGetLightfv", thunk::light_count, [](GLenum p, GLfloat* v) { glGetLightfv(GL_LIGHT1, p, v); }},
    {"glGetMaterialfv", thunk::material_count, [](GLenum p, GLfloat* v) { glGetMaterialfv(GL_BACK, p, v); }},
    {"glGetTexEnvfv", thunk::tex_env_count,
     [](GLenum p, GLfloat* v) { glGetTexEnvfv(GL_TEXTURE_ENV, p, v); }},
    {"glGetTexGenfv", thunk::tex_gen_count, [](GLenum p, GLfloat* v) { glGetTexGenfv(GL_S, p, v); }},
    {"glGetTexParameterfv", thunk::tex_parameter_count,
     [](GLenum p, GLfloat* v) { glGetTexParameterfv(GL_TEXTURE_2D, p, v); }},
    {"glGetTexLevelParameterfv", thunk::tex_level_parameter_count,
     [](GLenum p, GLfloat* v) { glGetTexLevelParameterfv(GL_TEXTURE_2D, 0, p, v); }},
};

constexpr Query<GLint> kIntegerQueries[] = {
    {"glGetLightiv", thunk::light_count, [](GLenum p, GLint* v) { glGetLightiv(GL_LIGHT1, p, v); }},
    {"glGetMaterialiv", thunk::material_count, [](GLenum p, GLint* v) { glGetMaterialiv(GL_BACK, p, v); }},
    {"glGetTexEnviv", thunk::tex_env_count, [](GLenum p, GLint* v) { glGetTexEnviv(GL_TEXTURE_ENV, p, v); }},
    {"glGetTexGeniv", thunk::tex_gen_count, [](GLenum p, GLint* v) { glGetTexGeniv(GL_S, p, v); }},
    {"glGetTexParameteriv", thunk::tex_parameter_count,
     [](GLenum p, GLint* v) { glGetTexParameteriv(GL_TEXTURE_2D, p, v); }},
    {"glGetTexLevelParameteriv", thunk::tex_level_parameter_count,
     [](GLenum p, GLint* v) { glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, p, v); }},
};

class ParameterReadsTest : public GlTest {
  protected:
    template <typename Command, typename Value>
    void call_with_exact_memory(const Command& command, Value value) {
        SCOPED_TRACE(command.name);
        int known = 0;
        for (GLenum pname = 0; pname < kNames; ++pname) {
            const std::size_t count = static_cast<std::size_t>(command.count(pname).size);
            command.call(pname, m_memory.last<Value>(count, value));
            const GLenum error = take_error();
            known += error == GL_NO_ERROR;
            if (count == 0) {
                ASSERT_EQ(error, GLenum{GL_INVALID_ENUM}) << std::hex << pname;
            }
        }
        EXPECT_GT(known, 0);
    }

    // All of them in one list: none is carried out, and each that fails does so when the list is called.
    template <typename Value>
    void record_unknown_names(const Setter<Value>& setter) {
        SCOPED_TRACE(setter.name);
        glNewList(1, GL_COMPILE);
        for (GLenum pname = 0; pname < kNames; ++pname)
            if (setter.count(pname).size == 0) setter.call(pname, m_memory.last<Value>(0));
        glEndList();
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        glCallList(1);
        EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
    }

    test::GuardedMemory m_memory{4096};
};

TEST_F(ParameterReadsTest, NoMoreThanTheParameterHas) {
    for (const auto& setter : kFloatSetters) call_with_exact_memory(setter, GLfloat{1});
    for (const auto& setter : kIntegerSetters) call_with_exact_memory(setter, GLint{1});
    for (const auto& setter : kDoubleSetters) call_with_exact_memory(setter, GLdouble{1});
    for (const auto& query : kFloatQueries) call_with_exact_memory(query, GLfloat{});
    for (const auto& query : kIntegerQueries) call_with_exact_memory(query, GLint{});
}

TEST_F(ParameterReadsTest, NothingOfUnknownNamesInLists) {
    for (const auto& setter : kFloatSetters) record_unknown_names(setter);
    for (const auto& setter : kIntegerSetters) record_unknown_names(setter);
    for (const auto& setter : kDoubleSetters) record_unknown_names(setter);
}

}  // namespace
}  // namespace terrazzo::gl
