// GetBooleanv, GetIntegerv, GetFloatv and GetDoublev (GL 1.5 §6.1.1, §6.1.2, tables 6.5-6.35).
//
// The table of state variables (state_table.cpp) reads each one in its own type; the conversion to the type
// asked for is here, once.
#include "gl/convert.h"
#include "gl/generated/commands.h"
#include "gl/state_table.h"

namespace terrazzo::gl {
namespace {

GLboolean to_boolean(const StateValues&, GLdouble value) {
    return value != 0 ? GL_TRUE : GL_FALSE;
}

GLint to_integer(const StateValues& values, GLdouble value) {
    return values.kind == StateKind::kNormalized ? denormalised(value) : rounded(value);
}

GLfloat to_float(const StateValues&, GLdouble value) {
    return static_cast<GLfloat>(value);
}

GLdouble to_double(const StateValues&, GLdouble value) {
    return value;
}

template <typename Result>
void get(Context& ctx, GLenum pname, Result* params, Result (*convert)(const StateValues&, GLdouble)) {
    StateValues values;
    if (!read_state(ctx, pname, values)) {
        return record_error(ctx, GL_INVALID_ENUM, "no such state variable");
    }
    for (int i = 0; i < values.count; ++i) params[i] = convert(values, values.data[i]);
}

}  // namespace

void get_booleanv(Context& ctx, GLenum pname, GLboolean* data) {
    get(ctx, pname, data, to_boolean);
}

void get_integerv(Context& ctx, GLenum pname, GLint* data) {
    get(ctx, pname, data, to_integer);
}

void get_floatv(Context& ctx, GLenum pname, GLfloat* data) {
    get(ctx, pname, data, to_float);
}

void get_doublev(Context& ctx, GLenum pname, GLdouble* data) {
    get(ctx, pname, data, to_double);
}

void get_pointerv(Context& ctx, GLenum pname, void** params) {
    if (pname == GL_SELECTION_BUFFER_POINTER) {
        *params = ctx.render_mode.selection.buffer;
        return;
    }
    if (pname == GL_FEEDBACK_BUFFER_POINTER) {
        *params = ctx.render_mode.feedback.buffer;
        return;
    }
    const ArrayState& arrays = ctx.arrays;
    const ClientArray* array = nullptr;
    switch (pname) {
        case GL_VERTEX_ARRAY_POINTER:
            array = &arrays.vertex;
            break;
        case GL_NORMAL_ARRAY_POINTER:
            array = &arrays.normal;
            break;
        case GL_COLOR_ARRAY_POINTER:
            array = &arrays.color;
            break;
        case GL_SECONDARY_COLOR_ARRAY_POINTER:
            array = &arrays.secondary_color;
            break;
        case GL_FOG_COORDINATE_ARRAY_POINTER:
            array = &arrays.fog_coordinate;
            break;
        case GL_INDEX_ARRAY_POINTER:
            array = &arrays.index;
            break;
        case GL_TEXTURE_COORD_ARRAY_POINTER:
            array = &arrays.texture[arrays.active_texture];
            break;
        case GL_EDGE_FLAG_ARRAY_POINTER:
            array = &arrays.edge_flag;
            break;
    }
    if (!array) return record_error(ctx, GL_INVALID_ENUM, "no such pointer");
    *params = const_cast<GLvoid*>(array->pointer);
}

}  // namespace terrazzo::gl
