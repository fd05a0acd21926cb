// Vertex arrays (GL 1.5 §2.8): the pointers a client has set and which of them are enabled; saved by
// glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT).
#pragma once

#include <GL/gl.h>

#include <array>

#include "gl/limits.h"
#include "pipeline/vertex_input.h"

namespace terrazzo::gl {

struct ClientArray {
    bool enabled = false;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    GLsizei stride = 0;  // as the client gave it; 0 stands for tightly packed
    const GLvoid* pointer = nullptr;
};

struct ArrayState {
    ArrayState() {
        normal.size = 3;
        secondary_color.size = 3;
        fog_coordinate.size = index.size = edge_flag.size = 1;
        edge_flag.type = GL_UNSIGNED_BYTE;
    }

    ClientArray vertex, normal, color, secondary_color, fog_coordinate, index, edge_flag;
    std::array<ClientArray, kMaxTextureUnits> texture;
    unsigned active_texture =
        0;  // the unit glTexCoordPointer and glEnableClientState(GL_TEXTURE_COORD_ARRAY) act on
};

// The array that glEnableClientState calls `name`, null when there is none.
ClientArray* find_client_array(ArrayState& arrays, GLenum name);

// Element `i` of an array as floats, missing components as 0, 0, 0, 1; `normalized` integers stand for [0, 1]
// or [-1, 1].
std::array<GLfloat, 4> element_of(const ClientArray& array, GLint i, bool normalized);

// Calls set(pipeline::Attribute, values) for element `i` of each enabled array, the position last. Index
// arrays, which RGBA mode ignores, are left out.
template <typename Set>
void for_each_enabled_array(const ArrayState& arrays, GLint i, Set set) {
    const auto visit = [&](int attribute, const ClientArray& array, bool normalized) {
        if (array.enabled && array.pointer != nullptr) set(attribute, element_of(array, i, normalized));
    };
    visit(pipeline::kNormal, arrays.normal, true);
    visit(pipeline::kColor, arrays.color, true);
    visit(pipeline::kSecondaryColor, arrays.secondary_color, true);
    visit(pipeline::kFogCoordinate, arrays.fog_coordinate, false);
    visit(pipeline::kEdgeFlag, arrays.edge_flag, false);
    for (int unit = 0; unit < kMaxTextureUnits; ++unit)
        visit(pipeline::kTexture0 + unit, arrays.texture[static_cast<std::size_t>(unit)], false);
    visit(pipeline::kPosition, arrays.vertex, false);
}

}  // namespace terrazzo::gl
