// Client arrays with and without indices, Begin/End, lists, buffers: GL 1.5 §2.6-2.9, §5.4.
#include "mesh_drawing.h"

#include "axes.h"

namespace terrazzo::states {
namespace {

// glDrawArrays takes vertices in order: the mesh without its indices.
void unroll(Mesh& mesh) {
    std::vector<Vertex> vertices;
    vertices.reserve(mesh.indices.size());
    for (const GLuint index : mesh.indices) vertices.push_back(mesh.vertices[index]);
    mesh.vertices = std::move(vertices);
}

void give_coordinates(const kit::Gl& gl, std::size_t unit, const Attributes::Unit& how,
                      const Vertex& vertex) {
    const GLenum name = GL_TEXTURE0 + static_cast<GLenum>(unit);
    const float* values = how.direction ? vertex.direction : unit % 2 ? vertex.light_map : vertex.texture;
    if (how.components == 1)
        unit == 0 ? gl.TexCoord1fv(values) : gl.MultiTexCoord1fv(name, values);
    else if (how.components == 2)
        unit == 0 ? gl.TexCoord2fv(values) : gl.MultiTexCoord2fv(name, values);
    else if (how.components == 3)
        unit == 0 ? gl.TexCoord3fv(values) : gl.MultiTexCoord3fv(name, values);
}

void enable_array(const kit::Gl& gl, GLenum array, bool enabled) {
    enabled ? gl.EnableClientState(array) : gl.DisableClientState(array);
}

}  // namespace

void MeshDrawing::prepare(const kit::Gl& gl, Mesh mesh, const Attributes& attributes, GLenum given) {
    m_mesh = std::move(mesh);
    m_attributes = attributes;
    m_given = given;
    if (given == kArrays) unroll(m_mesh);
    if (given == kVertexBuffer || given == kStreamedBuffer) make_buffers(gl);
    if (given != kList) return;
    m_list = gl.GenLists(1);
    set_arrays(gl, true);
    gl.NewList(m_list, GL_COMPILE);
    draw_elements(gl, m_mesh.indices.data());
    gl.EndList();
    set_arrays(gl, false);
}

void MeshDrawing::make_buffers(const kit::Gl& gl) {
    gl.GenBuffers(2, m_buffers);
    gl.BindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(m_mesh.vertices.size() * sizeof(Vertex)),
                  m_mesh.vertices.data(), m_given == kStreamedBuffer ? GL_STREAM_DRAW : GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(m_mesh.indices.size() * sizeof(GLuint)),
                  m_mesh.indices.data(), GL_STATIC_DRAW);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void MeshDrawing::draw(const kit::Gl& gl) const {
    switch (m_given) {
        case kImmediate:
            draw_immediate(gl);
            return;
        case kList:
            gl.CallList(m_list);
            return;
        case kVertexBuffer:
        case kStreamedBuffer:
            draw_buffers(gl);
            return;
        default:
            draw_arrays(gl);
    }
}

const Vertex* MeshDrawing::base() const {
    return m_given == kVertexBuffer || m_given == kStreamedBuffer ? nullptr : m_mesh.vertices.data();
}

void MeshDrawing::set_arrays(const kit::Gl& gl, bool enabled) const {
    constexpr GLsizei kStride = sizeof(Vertex);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(base());
    enable_array(gl, GL_VERTEX_ARRAY, enabled);
    gl.VertexPointer(3, GL_FLOAT, kStride, bytes + offsetof(Vertex, position));
    if (m_attributes.normals) {
        enable_array(gl, GL_NORMAL_ARRAY, enabled);
        gl.NormalPointer(GL_FLOAT, kStride, bytes + offsetof(Vertex, normal));
    }
    if (m_attributes.colours) {
        const bool are_floats = m_attributes.colours == GL_FLOAT;
        enable_array(gl, GL_COLOR_ARRAY, enabled);
        gl.ColorPointer(4, m_attributes.colours, kStride,
                        bytes + (are_floats ? offsetof(Vertex, colour) : offsetof(Vertex, colour_bytes)));
    }
    for (std::size_t unit = 0; unit < m_attributes.units.size(); ++unit) {
        const Attributes::Unit& how = m_attributes.units[unit];
        if (how.components == 0) continue;
        gl.ClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        enable_array(gl, GL_TEXTURE_COORD_ARRAY, enabled);
        gl.TexCoordPointer(how.components, GL_FLOAT, kStride,
                           bytes + (how.direction ? offsetof(Vertex, direction)
                                    : unit % 2    ? offsetof(Vertex, light_map)
                                                  : offsetof(Vertex, texture)));
    }
    gl.ClientActiveTexture(GL_TEXTURE0);
}

void MeshDrawing::draw_elements(const kit::Gl& gl, const GLuint* indices) const {
    for (const Mesh::Run& run : m_mesh.runs)
        gl.DrawElements(m_mesh.mode, run.count, GL_UNSIGNED_INT, indices + run.first);
}

void MeshDrawing::draw_arrays(const kit::Gl& gl) const {
    set_arrays(gl, true);
    if (m_given == kLockedArrays) gl.LockArraysEXT(0, static_cast<GLsizei>(m_mesh.vertices.size()));
    if (m_given == kArrays) {
        for (const Mesh::Run& run : m_mesh.runs) gl.DrawArrays(m_mesh.mode, run.first, run.count);
    } else {
        draw_elements(gl, m_mesh.indices.data());
    }
    if (m_given == kLockedArrays) gl.UnlockArraysEXT();
    set_arrays(gl, false);
}

void MeshDrawing::draw_buffers(const kit::Gl& gl) const {
    gl.BindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
    if (m_given == kStreamedBuffer)
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(m_mesh.vertices.size() * sizeof(Vertex)),
                      m_mesh.vertices.data(), GL_STREAM_DRAW);
    set_arrays(gl, true);
    draw_elements(gl, nullptr);
    set_arrays(gl, false);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void MeshDrawing::draw_immediate(const kit::Gl& gl) const {
    std::size_t units = m_attributes.units.size();
    while (units > 0 && m_attributes.units[units - 1].components == 0) --units;
    for (const Mesh::Run& run : m_mesh.runs) {
        gl.Begin(m_mesh.mode);
        for (GLsizei i = run.first; i < run.first + run.count; ++i) {
            const Vertex& vertex = m_mesh.vertices[m_mesh.indices[static_cast<std::size_t>(i)]];
            if (m_attributes.normals) gl.Normal3fv(vertex.normal);
            if (m_attributes.colours == GL_FLOAT) gl.Color4fv(vertex.colour);
            if (m_attributes.colours == GL_UNSIGNED_BYTE) gl.Color4ubv(vertex.colour_bytes);
            for (std::size_t unit = 0; unit < units; ++unit)
                give_coordinates(gl, unit, m_attributes.units[unit], vertex);
            gl.Vertex3fv(vertex.position);
        }
        gl.End();
    }
}

}  // namespace terrazzo::states
