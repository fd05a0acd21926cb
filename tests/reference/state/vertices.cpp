// Current values, Begin and End, vertex arrays and buffer objects (GL 1.5 §2.6 to §2.9).
#include <cstdint>

#include "commands.h"

namespace terrazzo::test {
namespace {

void play_current_value(Player& p) {
    const auto v = p.numbers(4);
    const GLuint bits = p.bits();
    p.note(std::to_string(bits));
    const auto b = static_cast<GLbyte>(bits);
    const auto s = static_cast<GLshort>(bits);
    const auto i = static_cast<GLint>(bits);
    switch (p.pick(22)) {
        case 14:
            return p.gl().MultiTexCoord4f(GL_TEXTURE0 + p.pick(8), v[0], v[1], v[2], v[3]);
        case 15:
            return p.gl().MultiTexCoord1d(GL_TEXTURE0 + p.pick(8), v[0]);
        case 16:
            return p.gl().MultiTexCoord3s(GL_TEXTURE0 + p.pick(8), s, 7, -1);
        case 17:
            return p.gl().SecondaryColor3f(v[0], v[1], v[2]);
        case 18:
            return p.gl().SecondaryColor3b(b, 1, -128);
        case 19:
            return p.gl().SecondaryColor3us(static_cast<GLushort>(s), 1, 65535);
        case 20:
            return p.gl().FogCoordf(v[0]);
        case 21:
            return p.gl().FogCoordd(v[0]);
        case 0:
            return p.gl().Color4f(v[0], v[1], v[2], v[3]);
        case 1:
            return p.gl().Color3b(b, 1, -128);
        case 2:
            return p.gl().Color4ub(static_cast<GLubyte>(b), 1, 254, 255);
        case 3:
            return p.gl().Color3s(s, 1, -32768);
        case 4:
            return p.gl().Color4us(static_cast<GLushort>(s), 1, 2, 65535);
        case 5:
            return p.gl().Color3i(i, 1, -1);
        case 6:
            return p.gl().Color3ui(bits, 1, 0xffffffffu);
        case 7:
            return p.gl().Color3d(v[0], v[1], v[2]);
        case 8:
            return p.gl().Normal3f(v[0], v[1], v[2]);
        case 9:
            return p.gl().Normal3s(s, 0, -1);
        case 10:
            return p.gl().TexCoord4f(v[0], v[1], v[2], v[3]);
        case 11:
            return p.gl().TexCoord2s(s, 7);
        case 12:
            return p.gl().EdgeFlag(p.flag());
    }
    p.gl().Indexf(v[0]);
}

// Values and materials, with commands among them that are not allowed there. No vertices: what is drawn is
// for other tests, and the reference would compile shaders for every state.
void play_primitive(Player& p) {
    p.gl().Begin(p.pick(10) ? p.pick(10) : p.enumerant({TERRAZZO_E(GL_QUADS)}));
    for (unsigned i = p.pick(6); i > 0; --i) {
        switch (p.pick(4)) {
            case 0:
                p.gl().Enable(p.enumerant(kCapabilities));
                break;
            case 1:
                p.gl().PopMatrix();
                break;
            case 2:
                play_material(p);
                break;
            default:
                play_current_value(p);
        }
    }
    p.gl().End();
}

const Enumerants kArrays = {TERRAZZO_E(GL_VERTEX_ARRAY),          TERRAZZO_E(GL_NORMAL_ARRAY),
                            TERRAZZO_E(GL_COLOR_ARRAY),           TERRAZZO_E(GL_INDEX_ARRAY),
                            TERRAZZO_E(GL_TEXTURE_COORD_ARRAY),   TERRAZZO_E(GL_EDGE_FLAG_ARRAY),
                            TERRAZZO_E(GL_SECONDARY_COLOR_ARRAY), TERRAZZO_E(GL_FOG_COORDINATE_ARRAY)};

// Pointers are never read: arrays are set and enabled, but nothing is drawn from them. The reference stores
// some negative strides although it records the error, so there are none here.
void play_array(Player& p) {
    const GLint size = p.pick(4) == 0 ? GL_BGRA : static_cast<GLint>(p.pick(6));
    const GLsizei stride = static_cast<GLsizei>(p.pick(40));
    const void* pointer = reinterpret_cast<const void*>(std::uintptr_t{p.pick(64)} * 8);
    p.note(std::to_string(size) + ' ' + std::to_string(stride));
    const GLenum type =
        p.enumerant({TERRAZZO_E(GL_FLOAT), TERRAZZO_E(GL_SHORT), TERRAZZO_E(GL_BYTE),
                     TERRAZZO_E(GL_UNSIGNED_BYTE), TERRAZZO_E(GL_UNSIGNED_SHORT), TERRAZZO_E(GL_DOUBLE)});
    switch (p.pick(8)) {
        case 5:
            return p.gl().FogCoordPointer(type, stride, pointer);
        case 6:
            // The reference takes four components as well.
            return p.gl().SecondaryColorPointer(size == 4 ? 3 : size, type, stride, pointer);
        case 0:
            return p.gl().VertexPointer(size, type, stride, pointer);
        case 1:
            return p.gl().NormalPointer(type, stride, pointer);
        case 2:
            return p.gl().ColorPointer(size, type, stride, pointer);
        case 3:
            return p.gl().IndexPointer(type, stride, pointer);
        case 4:
            return p.gl().TexCoordPointer(size, type, stride, pointer);
    }
    p.gl().EdgeFlagPointer(stride, pointer);
}

// Objects keep to names that the program chooses: the libraries need not make the same ones.
void play_buffer(Player& p) {
    const GLuint name = p.pick(4);
    p.note(std::to_string(name));
    const GLenum target = p.enumerant({TERRAZZO_E(GL_ARRAY_BUFFER), TERRAZZO_E(GL_ELEMENT_ARRAY_BUFFER),
                                       TERRAZZO_E(GL_PIXEL_UNPACK_BUFFER)});
    const GLintptr offset = static_cast<GLintptr>(p.pick(40)) - 4;
    const GLsizeiptr size = static_cast<GLsizeiptr>(p.pick(40)) - 4;
    GLubyte bytes[64] = {};
    const unsigned choice = p.pick(10);
    p.note(std::to_string(choice) + ' ' + std::to_string(offset) + ' ' + std::to_string(size));
    switch (choice) {
        case 0:
        case 1:
        case 2:
            return p.gl().BindBuffer(target, name);
        case 3:
            return p.gl().DeleteBuffers(1, &name);
        case 4:
            return p.gl().BufferSubData(target, offset, size, bytes);
        case 5:
            return p.gl().GetBufferSubData(target, offset, size, bytes);
        case 6:
            p.gl().MapBuffer(target, p.enumerant({TERRAZZO_E(GL_READ_ONLY), TERRAZZO_E(GL_WRITE_ONLY),
                                                  TERRAZZO_E(GL_READ_WRITE)}));
            return;
        case 7:
            p.gl().UnmapBuffer(target);
            return;
    }
    p.gl().BufferData(
        target, size, p.pick(2) ? bytes : nullptr,
        p.enumerant({TERRAZZO_E(GL_STATIC_DRAW), TERRAZZO_E(GL_STREAM_READ), TERRAZZO_E(GL_DYNAMIC_COPY)}));
}

void play_interleaved_arrays(Player& p) {
    const GLsizei stride = static_cast<GLsizei>(p.pick(100)) - 4;
    p.note(std::to_string(stride));
    // The reference leaves these arrays as they are; GL 1.5 §2.8 disables them.
    p.gl().DisableClientState(GL_SECONDARY_COLOR_ARRAY);
    p.gl().DisableClientState(GL_FOG_COORDINATE_ARRAY);
    const GLenum format = p.pick(8) ? GL_V2F + p.pick(14) : p.enumerant({TERRAZZO_E(GL_T2F_V3F)});
    p.gl().InterleavedArrays(format, stride, nullptr);
}

const Command kCommands[] = {
    {"glClientActiveTexture",
     [](Player& p) {
         p.gl().ClientActiveTexture(p.pick(8) ? texture_unit(p) : p.enumerant({TERRAZZO_E(GL_TEXTURE)}));
     }},
    {"current value", play_current_value},
    {"glBegin...glEnd", play_primitive},
    {"array pointer", play_array},
    {"buffer object", play_buffer},
    {"glInterleavedArrays", play_interleaved_arrays},
    {"glEnableClientState", [](Player& p) { p.gl().EnableClientState(p.enumerant(kArrays)); }},
    {"glDisableClientState", [](Player& p) { p.gl().DisableClientState(p.enumerant(kArrays)); }},
    {"glLockArraysEXT",
     [](Player& p) {
         const GLint first = static_cast<GLint>(p.pick(6)) - 1;
         const GLsizei count = static_cast<GLsizei>(p.pick(6)) - 1;
         p.note(std::to_string(first) + ' ' + std::to_string(count));
         p.gl().LockArraysEXT(first, count);
     }},
    {"glUnlockArraysEXT", [](Player& p) { p.gl().UnlockArraysEXT(); }},
};

}  // namespace

std::span<const Command> vertices_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
