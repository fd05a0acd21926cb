// Immediate vertices, arrays, buffer objects, queries and all kinds of primitives.
#include <vector>

#include "program.h"

namespace terrazzo::test {
namespace {

// Enough vertices for several pieces, and, of connected primitives, for a break.
void draw_many(const kit::Gl& gl, GLenum mode, int count) {
    gl.Begin(mode);
    gl.Color3ub(10, 90, 30);
    for (int i = 0; i < count; ++i) {
        if (i % 7 == 3) gl.Color3ub(static_cast<GLubyte>(i), static_cast<GLubyte>(i / 3), 200);
        gl.Vertex3f(static_cast<GLfloat>(i % 61) / 31 - 1, static_cast<GLfloat>(i % 53) / 27 - 1,
                    static_cast<GLfloat>(i % 11) / 20);
    }
    gl.End();
}

constexpr GLfloat kPositions[] = {-0.9f, -0.9f, 0.9f, -0.5f, 0.2f,  0.8f,
                                  -0.6f, 0.9f,  0.5f, 0.1f,  -0.2f, -0.1f};
constexpr GLubyte kColors[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 90, 90, 0, 0, 90, 90, 90, 0, 90};
constexpr GLushort kIndices[] = {0, 1, 2, 3, 4, 5, 2, 1, 0};

Program immediate() {
    return {"Immediate",
            {TERRAZZO_CALL(gl.ClearColor(0.1f, 0.2f, 0.3f, 1)),
             TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)),
             TERRAZZO_CALL(gl.Enable(GL_DEPTH_TEST)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.Color4f(1, 1, 0, 0.5f)), TERRAZZO_CALL(gl.Rectf(-0.3f, -0.3f, 0.4f, 0.2f)),
             TERRAZZO_CALL(gl.Enable(GL_BLEND)), TERRAZZO_CALL(gl.BlendFunc(GL_SRC_ALPHA, GL_ONE)),
             TERRAZZO_CALL(gl.Rectf(-0.1f, -0.9f, 0.8f, 0.9f)), TERRAZZO_CALL(gl.PointSize(7)),
             TERRAZZO_BLOCK("points", gl.Begin(GL_POINTS); gl.Vertex2f(0.5f, 0.5f); gl.Normal3f(0, 1, 0);
                            gl.SecondaryColor3f(0.1f, 0.2f, 0.3f); gl.FogCoordf(1); gl.Vertex2f(-0.5f, 0.5f);
                            gl.End();),
             TERRAZZO_CALL(gl.Flush()), TERRAZZO_CALL(gl.Disable(GL_BLEND)),
             TERRAZZO_BLOCK(
                 "strip", gl.Begin(GL_TRIANGLE_STRIP); for (int i = 0; i < 9; ++i) {
                     gl.Color3f(static_cast<GLfloat>(i) / 9, 0.4f, 0);
                     gl.Vertex2f(static_cast<GLfloat>(i) / 5 - 0.9f, i % 2 ? -0.6f : -0.95f);
                 } gl.End();),
             TERRAZZO_CALL(gl.Finish())}};
}

Program many() {
    return {"ManyVertices",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_BLOCK("triangles", draw_many(gl, GL_TRIANGLES, 9000);),
             TERRAZZO_BLOCK("quads", draw_many(gl, GL_QUADS, 9000);), TERRAZZO_CALL(gl.ShadeModel(GL_FLAT)),
             TERRAZZO_BLOCK("lines", draw_many(gl, GL_LINES, 5000);), TERRAZZO_CALL(gl.Finish())}};
}

Program connected() {
    return {"LongLoop",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_BLOCK("loop", draw_many(gl, GL_LINE_LOOP, 50000);), TERRAZZO_CALL(gl.Color3f(1, 1, 1)),
             TERRAZZO_BLOCK("strip", draw_many(gl, GL_TRIANGLE_STRIP, 300);), TERRAZZO_CALL(gl.Finish())}};
}

Program arrays() {
    return {"Arrays",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.VertexPointer(2, GL_FLOAT, 0, kPositions)),
             TERRAZZO_CALL(gl.EnableClientState(GL_VERTEX_ARRAY)),
             TERRAZZO_CALL(gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, kColors)),
             TERRAZZO_CALL(gl.EnableClientState(GL_COLOR_ARRAY)),
             TERRAZZO_CALL(gl.DrawArrays(GL_TRIANGLES, 0, 6)),
             TERRAZZO_CALL(gl.DrawElements(GL_LINE_STRIP, 9, GL_UNSIGNED_SHORT, kIndices)),
             TERRAZZO_CALL(gl.DrawRangeElements(GL_POINTS, 0, 5, 3, GL_UNSIGNED_SHORT, kIndices)),
             TERRAZZO_BLOCK("many", const GLint first[] = {0, 3}; const GLsizei count[] = {3, 3};
                            gl.MultiDrawArrays(GL_LINE_LOOP, first, count, 2);),
             TERRAZZO_BLOCK("elements", gl.Begin(GL_TRIANGLES);
                            for (GLint i = 0; i < 3; ++i) gl.ArrayElement(i + 2); gl.End();),
             TERRAZZO_CALL(gl.InterleavedArrays(GL_V2F, 0, kPositions)),
             TERRAZZO_CALL(gl.DrawArrays(GL_POLYGON, 1, 4)), TERRAZZO_CALL(gl.Finish())}};
}

// Draws of several pieces, which go to all threads.
Program large_arrays() {
    constexpr GLsizei kVertices = 9000;
    static const std::vector<GLfloat> positions = [] {
        std::vector<GLfloat> out;
        for (int i = 0; i < kVertices; ++i) {
            out.push_back(static_cast<GLfloat>(i % 61) / 31 - 1);
            out.push_back(static_cast<GLfloat>(i % 53) / 27 - 1);
        }
        return out;
    }();
    return {"LargeArrays",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.VertexPointer(2, GL_FLOAT, 0, positions.data())),
             TERRAZZO_CALL(gl.EnableClientState(GL_VERTEX_ARRAY)), TERRAZZO_CALL(gl.Color3f(1, 0.5f, 0)),
             TERRAZZO_CALL(gl.DrawArrays(GL_TRIANGLES, 0, kVertices)), TERRAZZO_CALL(gl.Color3f(0, 0.5f, 1)),
             TERRAZZO_CALL(gl.DrawArrays(GL_LINE_STRIP, 0, kVertices)), TERRAZZO_CALL(gl.Finish())}};
}

Program buffers() {
    return {
        "Buffers",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_CALL(gl.GenBuffers(3, r.names.data())),
         TERRAZZO_CALL(gl.BindBuffer(GL_ARRAY_BUFFER, r.names[0])),
         TERRAZZO_CALL(gl.BufferData(GL_ARRAY_BUFFER, sizeof kPositions, kPositions, GL_STATIC_DRAW)),
         TERRAZZO_CALL(gl.VertexPointer(2, GL_FLOAT, 0, nullptr)),
         TERRAZZO_CALL(gl.EnableClientState(GL_VERTEX_ARRAY)),
         TERRAZZO_CALL(gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 7)),
         TERRAZZO_CALL(gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kIndices, kIndices, GL_DYNAMIC_DRAW)),
         TERRAZZO_CALL(gl.DrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_SHORT, nullptr)),
         TERRAZZO_CALL(gl.DrawArrays(GL_LINE_LOOP, 2, 9)),  // beyond the buffer's end
         TERRAZZO_CALL(gl.BufferSubData(GL_ARRAY_BUFFER, 0, 8, kPositions + 4)),
         TERRAZZO_CALL(gl.BufferData(GL_ARRAY_BUFFER, 2 * sizeof kPositions, nullptr, GL_STREAM_DRAW)),
         TERRAZZO_CALL(r.refused = gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY) == nullptr),
         TERRAZZO_CALL(r.refused = !gl.UnmapBuffer(GL_ARRAY_BUFFER)),
         TERRAZZO_CALL(gl.DrawArrays(GL_TRIANGLES, 0, 6)), TERRAZZO_CALL(gl.DeleteBuffers(3, r.names.data())),
         TERRAZZO_CALL(gl.Finish())}};
}

Program queries() {
    return {"Queries",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_CALL(gl.GenQueries(2, r.names.data())),
             TERRAZZO_CALL(gl.BeginQuery(GL_SAMPLES_PASSED, r.names[0])),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);), TERRAZZO_CALL(gl.EndQuery(GL_SAMPLES_PASSED)),
             TERRAZZO_CALL(gl.BeginQuery(GL_SAMPLES_PASSED, 6)), TERRAZZO_CALL(gl.Rectf(0, 0, 0.5f, 0.5f)),
             TERRAZZO_CALL(gl.EndQuery(GL_SAMPLES_PASSED)),
             TERRAZZO_CALL(GLuint passed = 0; gl.GetQueryObjectuiv(r.names[0], GL_QUERY_RESULT, &passed);
                           r.results[0] = {static_cast<float>(passed)}),
             TERRAZZO_CALL(GLuint passed = 0; gl.GetQueryObjectuiv(6, GL_QUERY_RESULT, &passed);
                           r.results[1] = {static_cast<float>(passed)}),
             TERRAZZO_CALL(gl.BeginQuery(GL_SAMPLES_PASSED, r.names[1])),
             TERRAZZO_CALL(gl.Rectf(-0.5f, -0.5f, 0, 0)), TERRAZZO_CALL(gl.DeleteQueries(2, r.names.data())),
             TERRAZZO_CALL(gl.Finish())}};
}

Program primitives() {
    return {"Primitives",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.Enable(GL_LINE_STIPPLE)),
             TERRAZZO_CALL(gl.LineStipple(2, 0x3f5a)),
             TERRAZZO_CALL(gl.LineWidth(3)),
             TERRAZZO_BLOCK("stippled strip", draw_many(gl, GL_LINE_STRIP, 40);),
             TERRAZZO_CALL(gl.Enable(GL_LINE_SMOOTH)),
             TERRAZZO_CALL(gl.Enable(GL_BLEND)),
             TERRAZZO_CALL(gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)),
             TERRAZZO_BLOCK("smooth lines", draw_many(gl, GL_LINES, 20);),
             TERRAZZO_CALL(gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE)),
             TERRAZZO_BLOCK("outlines", draw_many(gl, GL_QUAD_STRIP, 30);),
             TERRAZZO_CALL(gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL)),
             TERRAZZO_CALL(gl.Enable(GL_POLYGON_STIPPLE)),
             TERRAZZO_BLOCK("stipple", std::vector<GLubyte> rows(128, 0x5a); gl.PolygonStipple(rows.data());),
             TERRAZZO_CALL(gl.Rectf(-0.9f, 0, 0, 0.9f)),
             TERRAZZO_BLOCK("clip", const GLdouble plane[] = {1, 1, 0, 0.5};
                            gl.ClipPlane(GL_CLIP_PLANE0, plane); gl.Enable(GL_CLIP_PLANE0);),
             TERRAZZO_BLOCK("fan", draw_many(gl, GL_TRIANGLE_FAN, 30);),
             TERRAZZO_CALL(gl.Enable(GL_POINT_SMOOTH)),
             TERRAZZO_CALL(gl.PointSize(9)),
             TERRAZZO_BLOCK("points", draw_many(gl, GL_POINTS, 12);),
             TERRAZZO_CALL(gl.Finish())}};
}

}  // namespace

std::vector<Program> vertex_programs() {
    return {immediate(), many(), connected(), arrays(), large_arrays(), buffers(), queries(), primitives()};
}

}  // namespace terrazzo::test
