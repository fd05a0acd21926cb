// Vertex arrays in display lists (GL 1.5 §5.4): the arrays are read when the list is compiled, and what they
// hold is recorded as a batch of primitives of its own.
#include <cstring>
#include <utility>

#include "gl/context.h"
#include "gl/generated/compile.h"
#include "gl/list_recorder.h"

namespace terrazzo::gl {
namespace {

constexpr const char* kMapped = "a buffer of the arrays is mapped";

template <typename Index>
GLuint index_at(const std::byte* indices, GLsizei i) {
    Index index;
    std::memcpy(&index, indices + static_cast<std::size_t>(i) * sizeof index, sizeof index);
    return index;
}

GLuint index_at(const std::byte* indices, GLenum type, GLsizei i) {
    if (type == GL_UNSIGNED_BYTE) return index_at<GLubyte>(indices, i);
    if (type == GL_UNSIGNED_SHORT) return index_at<GLushort>(indices, i);
    return index_at<GLuint>(indices, i);
}

bool is_index_type(GLenum type) {
    return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

// The error that a draw of arrays makes whenever the list is called; GL_NO_ERROR and "" for none.
std::pair<GLenum, const char*> error_of_draw(const Context& ctx, GLenum mode, GLsizei count) {
    if (ctx.lists.vertices.open()) return {GL_INVALID_OPERATION, "not allowed between glBegin and glEnd"};
    if (mode > GL_POLYGON) return {GL_INVALID_ENUM, "no such primitive"};
    if (count < 0) return {GL_INVALID_VALUE, "count is negative"};
    return {GL_NO_ERROR, ""};
}

// Records a run whose vertices are the array elements that `element` names.
template <typename Element>
void record_arrays(Context& ctx, GLenum mode, GLsizei count, Element element) {
    const EnabledArrays arrays(ctx);
    if (arrays.any_mapped()) return record_list_error(ctx, GL_INVALID_OPERATION, kMapped);
    if (count == 0 || !arrays.has_position()) return;
    record(ctx, [&](DisplayList& list) {
        ListVertices& vertices = ctx.lists.vertices;
        vertices.begin_arrays(list, mode);
        for (GLsizei i = 0; i < count; ++i) {
            for (const ReadableArray& array : arrays) {
                const std::array<GLfloat, 4> value = array.element(element(i));
                if (array.attribute == pipeline::kPosition)
                    vertices.vertex(list, value);
                else
                    vertices.attribute(list, array.attribute, value);
            }
        }
        vertices.end_arrays(list);
    });
}

void record_draw_arrays(Context& ctx, GLenum mode, GLint first, GLsizei count) {
    if (first < 0) return record_list_error(ctx, GL_INVALID_VALUE, "first is negative");
    const auto [error, rule] = error_of_draw(ctx, mode, count);
    if (error != GL_NO_ERROR) return record_list_error(ctx, error, rule);
    record_arrays(ctx, mode, count, [&](GLsizei i) {
        return static_cast<GLint>(static_cast<GLuint>(first) + static_cast<GLuint>(i));
    });
}

void record_draw_elements(Context& ctx, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    if (!is_index_type(type)) return record_list_error(ctx, GL_INVALID_ENUM, "no type of indices");
    const auto [error, rule] = error_of_draw(ctx, mode, count);
    if (error != GL_NO_ERROR) return record_list_error(ctx, error, rule);
    const auto [bytes, readable_count] = find_indices(ctx, count, type, indices);
    if (bytes.mapped) return record_list_error(ctx, GL_INVALID_OPERATION, kMapped);
    const std::byte* const from = bytes.data;
    record_arrays(ctx, mode, readable_count,
                  [&](GLsizei i) { return static_cast<GLint>(index_at(from, type, i)); });
}

}  // namespace

void Compile::ArrayElement(Context& ctx, GLint i) {
    if (i < 0) return record_list_error(ctx, GL_INVALID_VALUE, "the element is negative");
    const EnabledArrays arrays(ctx);
    if (arrays.any_mapped()) return record_list_error(ctx, GL_INVALID_OPERATION, kMapped);
    for (const ReadableArray& array : arrays) {
        const std::array<GLfloat, 4> v = array.element(i);
        switch (array.attribute) {
            case pipeline::kNormal:
                Normal3f(ctx, v[0], v[1], v[2]);
                break;
            case pipeline::kColor:
                Color4f(ctx, v[0], v[1], v[2], v[3]);
                break;
            case pipeline::kEdgeFlag:
                EdgeFlag(ctx, v[0] != 0);
                break;
            case pipeline::kTexture0:
                TexCoord4f(ctx, v[0], v[1], v[2], v[3]);
                break;
            case pipeline::kSecondaryColor:
                SecondaryColor3f(ctx, v[0], v[1], v[2]);
                break;
            case pipeline::kFogCoordinate:
                FogCoordf(ctx, v[0]);
                break;
            case pipeline::kPosition:
                Vertex4f(ctx, v[0], v[1], v[2], v[3]);
                break;
            default:
                MultiTexCoord4f(ctx, static_cast<GLenum>(GL_TEXTURE0 + array.attribute - pipeline::kTexture0),
                                v[0], v[1], v[2], v[3]);
        }
    }
}

void Compile::DrawArrays(Context& ctx, GLenum mode, GLint first, GLsizei count) {
    record_draw_arrays(ctx, mode, first, count);
    if (ctx.lists.execute_too) ctx.dispatch.execute->DrawArrays(&ctx, mode, first, count);
}

void Compile::DrawElements(Context& ctx, GLenum mode, GLsizei count, GLenum type, const void* indices) {
    record_draw_elements(ctx, mode, count, type, indices);
    if (ctx.lists.execute_too) ctx.dispatch.execute->DrawElements(&ctx, mode, count, type, indices);
}

void Compile::DrawRangeElements(Context& ctx, GLenum mode, GLuint start, GLuint end, GLsizei count,
                                GLenum type, const void* indices) {
    if (end < start) {
        record_list_error(ctx, GL_INVALID_VALUE, "end is before start");
    } else {
        record_draw_elements(ctx, mode, count, type, indices);
    }
    if (ctx.lists.execute_too)
        ctx.dispatch.execute->DrawRangeElements(&ctx, mode, start, end, count, type, indices);
}

void Compile::MultiDrawArrays(Context& ctx, GLenum mode, const GLint* first, const GLsizei* count,
                              GLsizei drawcount) {
    if (drawcount < 0) record_list_error(ctx, GL_INVALID_VALUE, "drawcount is negative");
    for (GLsizei i = 0; i < drawcount; ++i) {
        if (count[i] > 0) record_draw_arrays(ctx, mode, first[i], count[i]);
    }
    if (ctx.lists.execute_too) ctx.dispatch.execute->MultiDrawArrays(&ctx, mode, first, count, drawcount);
}

void Compile::MultiDrawElements(Context& ctx, GLenum mode, const GLsizei* count, GLenum type,
                                const void* const* indices, GLsizei drawcount) {
    if (drawcount < 0) record_list_error(ctx, GL_INVALID_VALUE, "drawcount is negative");
    for (GLsizei i = 0; i < drawcount; ++i) {
        if (count[i] > 0) record_draw_elements(ctx, mode, count[i], type, indices[i]);
    }
    if (ctx.lists.execute_too)
        ctx.dispatch.execute->MultiDrawElements(&ctx, mode, count, type, indices, drawcount);
}

}  // namespace terrazzo::gl
