// Vertex arrays in display lists (GL 1.5 §5.4): the arrays are read when the list is compiled, and what they
// hold is recorded as the Begin, attribute and End commands that draw the same.
#include <vector>

#include "gl/context.h"
#include "gl/generated/compile.h"

namespace terrazzo::gl {
namespace {

void record_element(Context& ctx, GLint i) {
    for_each_enabled_array(ctx.arrays, i, [&](int attribute, const std::array<GLfloat, 4>& v) {
        switch (attribute) {
            case pipeline::kNormal:
                return Compile::Normal3f(ctx, v[0], v[1], v[2]);
            case pipeline::kColor:
                return Compile::Color4f(ctx, v[0], v[1], v[2], v[3]);
            case pipeline::kEdgeFlag:
                return Compile::EdgeFlag(ctx, v[0] != 0);
            case pipeline::kTexture0:
                return Compile::TexCoord4f(ctx, v[0], v[1], v[2], v[3]);
            case pipeline::kPosition:
                return Compile::Vertex4f(ctx, v[0], v[1], v[2], v[3]);
        }
    });
}

GLuint index_at(const void* indices, GLenum type, GLsizei i) {
    if (type == GL_UNSIGNED_BYTE) return static_cast<const GLubyte*>(indices)[i];
    if (type == GL_UNSIGNED_SHORT) return static_cast<const GLushort*>(indices)[i];
    return static_cast<const GLuint*>(indices)[i];
}

bool is_index_type(GLenum type) {
    return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

bool check_draw(Context& ctx, GLenum mode, GLsizei count) {
    if (mode > GL_POLYGON) return Compile::error(ctx, GL_INVALID_ENUM, "no such primitive"), false;
    if (count < 0) return Compile::error(ctx, GL_INVALID_VALUE, "count is negative"), false;
    const ClientArray& vertex = ctx.arrays.vertex;
    return vertex.enabled && vertex.pointer != nullptr;
}

}  // namespace

void Compile::ArrayElement(Context& ctx, GLint i) {
    record_element(ctx, i);
}

void Compile::DrawArrays(Context& ctx, GLenum mode, GLint first, GLsizei count) {
    if (first < 0) return Compile::error(ctx, GL_INVALID_VALUE, "first is negative");
    if (!check_draw(ctx, mode, count)) return;
    Compile::Begin(ctx, mode);
    for (GLsizei i = 0; i < count; ++i) record_element(ctx, first + i);
    Compile::End(ctx);
}

void Compile::DrawElements(Context& ctx, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (!is_index_type(type)) return Compile::error(ctx, GL_INVALID_ENUM, "no type of indices");
    if (!check_draw(ctx, mode, count) || indices == nullptr) return;
    Compile::Begin(ctx, mode);
    for (GLsizei i = 0; i < count; ++i) record_element(ctx, static_cast<GLint>(index_at(indices, type, i)));
    Compile::End(ctx);
}

void Compile::DrawRangeElements(Context& ctx, GLenum mode, GLuint start, GLuint end, GLsizei count,
                                GLenum type, const void* indices) {
    if (end < start) return Compile::error(ctx, GL_INVALID_VALUE, "end is before start");
    DrawElements(ctx, mode, count, type, indices);
}

void Compile::MultiDrawArrays(Context& ctx, GLenum mode, const GLint* first, const GLsizei* count,
                              GLsizei drawcount) {
    if (drawcount < 0) return Compile::error(ctx, GL_INVALID_VALUE, "drawcount is negative");
    for (GLsizei i = 0; i < drawcount; ++i)
        if (count[i] > 0) DrawArrays(ctx, mode, first[i], count[i]);
}

void Compile::MultiDrawElements(Context& ctx, GLenum mode, const GLsizei* count, GLenum type,
                                const void* const* indices, GLsizei drawcount) {
    if (drawcount < 0) return Compile::error(ctx, GL_INVALID_VALUE, "drawcount is negative");
    for (GLsizei i = 0; i < drawcount; ++i)
        if (count[i] > 0) DrawElements(ctx, mode, count[i], type, indices[i]);
}

}  // namespace terrazzo::gl
