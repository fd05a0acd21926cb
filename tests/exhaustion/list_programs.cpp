// Display lists of every kind of content. A list that could not be made is made anew from NewList on (GL 1.5
// §5.4: it is as if nobody had tried).
#include "program.h"

namespace terrazzo::test {
namespace {

// Whether a list is being compiled from then on. If not, what was to be in it must not be carried out.
bool new_list(const kit::Gl& gl, GLuint name, GLenum mode = GL_COMPILE) {
    gl.NewList(name, mode);
    GLint compiling = 0;
    gl.GetIntegerv(GL_LIST_INDEX, &compiling);
    return compiling != 0;
}

void draw_strips(const kit::Gl& gl) {
    for (int strip = 0; strip < 3; ++strip) {
        gl.Begin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 200; ++i) {
            gl.Color3ub(static_cast<GLubyte>(i), static_cast<GLubyte>(60 * strip), 9);
            gl.Vertex2f(static_cast<GLfloat>(i) / 100 - 1,
                        static_cast<GLfloat>(strip) / 3 + (i % 2 ? 0.2f : -0.7f));
        }
        gl.End();
    }
}

// An attribute that comes first in the middle of a run, a vertex outside, another list.
void draw_unruly(const kit::Gl& gl, GLuint list) {
    gl.Begin(GL_LINES);
    gl.Vertex2f(-1, 0.5f);
    gl.Color3f(1, 0, 1);
    gl.Vertex2f(1, -0.5f);
    gl.End();
    gl.Vertex2f(0, 0);
    gl.CallList(list);
}

Program geometry() {
    return {
        "ListsOfGeometry",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
         TERRAZZO_CALL(r.names[0] = gl.GenLists(3); r.refused = r.names[0] == 0),
         TERRAZZO_BLOCK("list of a triangle", if (new_list(gl, r.names[0])) draw_triangle(gl), gl.EndList()),
         TERRAZZO_BLOCK("list of strips", if (new_list(gl, r.names[0] + 1)) draw_strips(gl), gl.EndList()),
         TERRAZZO_BLOCK("list of what is no batch",
                        if (new_list(gl, r.names[0] + 2)) draw_unruly(gl, r.names[0]), gl.EndList()),
         TERRAZZO_BLOCK("call", gl.CallList(r.names[0])), TERRAZZO_BLOCK("call", gl.CallList(r.names[0] + 1)),
         TERRAZZO_CALL(gl.ListBase(r.names[0])),
         TERRAZZO_BLOCK("calls", gl.CallLists(4, GL_BYTE, "\0\2\1\0")),
         TERRAZZO_CALL(gl.DeleteLists(r.names[0] + 1, 1)), TERRAZZO_CALL(gl.Finish())}};
}

// The first two begin anew, because a call of which a part has failed is repeated whole.
void draw_wheel(const kit::Gl& gl) {
    gl.Clear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 60; ++i) {
        gl.LoadIdentity();
        gl.Rotatef(static_cast<GLfloat>(i) * 6, 0, 0, 1);
        gl.Color3f(static_cast<GLfloat>(i) / 60, 0.5f, 0.2f);
        gl.Rectf(0.5f, 0.5f, 0.6f, 0.6f);
    }
    gl.LoadIdentity();
}

void draw_moved(const kit::Gl& gl) {
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.LoadIdentity();
    gl.Translatef(0.1f, 0, 0);
    draw_triangle(gl);
    gl.LoadIdentity();
}

Program commands() {
    return {
        "ListsOfCommands",
        {TERRAZZO_CALL(gl.ClearColor(0, 0.1f, 0.2f, 1)),
         TERRAZZO_BLOCK("list", if (new_list(gl, 4)) draw_wheel(gl), gl.EndList()),
         TERRAZZO_BLOCK("call", gl.CallList(4)),
         TERRAZZO_BLOCK("list, and carried out", if (new_list(gl, 4, GL_COMPILE_AND_EXECUTE)) draw_moved(gl),
                        gl.EndList()),
         TERRAZZO_BLOCK("nested", if (new_list(gl, 5)) gl.CallList(4), gl.CallList(4), gl.EndList()),
         TERRAZZO_BLOCK("call", gl.CallList(5)), TERRAZZO_CALL(gl.DeleteLists(4, 1)),
         TERRAZZO_BLOCK("call of nothing", gl.CallList(4)),
         TERRAZZO_BLOCK("empty", if (new_list(gl, 7)) gl.EndList()),
         TERRAZZO_CALL(r.results[0] = {static_cast<float>(gl.GenLists(2))}; r.refused = r.results[0][0] == 0),
         TERRAZZO_CALL(gl.DeleteLists(1, 3)), TERRAZZO_CALL(gl.DeleteLists(1, 20)),
         TERRAZZO_CALL(gl.Finish())}};
}

void define_images(const kit::Gl& gl) {
    const std::vector<GLubyte> pixels(4 * 16 * 16, 0x6c);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl.RasterPos2f(-0.5f, -0.5f);
    gl.DrawPixels(16, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl.Bitmap(32, 8, 0, 0, 3, 3, pixels.data());
}

void define_map(const kit::Gl& gl) {
    constexpr GLfloat kPoints[] = {-0.9f, 0.5f, 0, 0.9f, -0.5f, 0};
    gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, kPoints);
    gl.Enable(GL_MAP1_VERTEX_3);
    gl.MapGrid1f(4, 0, 1);
}

constexpr GLfloat kPositions[] = {-0.9f, -0.9f, 0.9f, -0.5f, 0.2f, 0.8f, -0.6f, 0.9f};
constexpr GLubyte kIndices[] = {0, 2, 3, 1, 0, 2};

void draw_arrays(const kit::Gl& gl) {
    gl.DrawArrays(GL_LINE_LOOP, 0, 4);
    gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, kIndices);
}

Program data() {
    return {"ListsOfData",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.VertexPointer(2, GL_FLOAT, 0, kPositions)),
             TERRAZZO_CALL(gl.EnableClientState(GL_VERTEX_ARRAY)),
             TERRAZZO_BLOCK("arrays", if (new_list(gl, 1)) draw_arrays(gl), gl.EndList()),
             TERRAZZO_BLOCK("images", if (new_list(gl, 2)) define_images(gl), gl.EndList()),
             TERRAZZO_BLOCK("call", gl.CallList(1)), TERRAZZO_BLOCK("call", gl.CallList(2)),
             TERRAZZO_BLOCK("map", if (new_list(gl, 3)) define_map(gl), gl.EndList()),
             TERRAZZO_BLOCK("call", gl.CallList(3)), TERRAZZO_BLOCK("curve", gl.EvalMesh1(GL_LINE, 0, 4)),
             TERRAZZO_CALL(gl.Finish())}};
}

}  // namespace

std::vector<Program> list_programs() {
    return {geometry(), commands(), data()};
}

}  // namespace terrazzo::test
