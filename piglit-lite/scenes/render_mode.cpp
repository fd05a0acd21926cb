// Chapter: selection and feedback (GL 1.5 §5.2, §5.3).
#include <algorithm>

#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

constexpr GLsizei kBufferSize = 8192;

// Calls draw() in feedback mode and notes what it leaves in the buffer.
template <typename Draw>
void note_feedback(const Gl& gl, Notes& notes, const std::string& name, GLenum type, Draw draw) {
    std::vector<GLfloat> buffer(kBufferSize, -7);
    gl.FeedbackBuffer(kBufferSize, type, buffer.data());
    gl.RenderMode(GL_FEEDBACK);
    draw();
    const GLint written = gl.RenderMode(GL_RENDER);
    notes.value(name + " written", written);
    // The reference never says that a line begins anew.
    std::replace(buffer.begin(), buffer.end(), GLfloat{GL_LINE_RESET_TOKEN}, GLfloat{GL_LINE_TOKEN});
    for (GLint i = 0; i < written; ++i)
        notes.value(name + '[' + std::to_string(i) + ']',
                    static_cast<double>(buffer[static_cast<std::size_t>(i)]));
}

template <typename Draw>
void note_selection(const Gl& gl, Notes& notes, const std::string& name, GLsizei size, Draw draw) {
    std::vector<GLuint> buffer(kBufferSize, 7);
    gl.SelectBuffer(size, buffer.data());
    gl.RenderMode(GL_SELECT);
    draw();
    notes.value(name + " hits", gl.RenderMode(GL_RENDER));
    for (std::size_t i = 0; i < 100; ++i) notes.value(name + '[' + std::to_string(i) + ']', buffer[i]);
}

void random_vertices(const Gl& gl, Random& random, int count, float extent) {
    for (int i = 0; i < count; ++i) {
        InOrder{gl.Color4f, random(0, 1), random(0, 1), random(0, 1), random(0, 1)};
        InOrder{gl.TexCoord4f, random(0, 1), random(0, 1), random(0, 1), random(0.5F, 1)};
        gl.EdgeFlag(i % 3 != 1);
        InOrder{gl.Vertex3f, random(-extent, extent), random(-extent, extent), random(-extent, extent)};
    }
    gl.EdgeFlag(GL_TRUE);
}

void perspective(const Gl& gl) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Frustum(-1, 1, -1, 1, 2, 12);
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    gl.Translatef(0, 0, -6);
    gl.Rotatef(20, 1, 2, 3);
}

const std::string& mode_name(GLenum mode) {
    static const std::string names[] = {"points",     "lines",          "line loop",    "line strip",
                                        "triangles",  "triangle strip", "triangle fan", "quads",
                                        "quad strip", "polygon"};
    return names[mode];
}

}  // namespace

SCENE(feedback_primitives, "every primitive inside the volume, with colours and texture coordinates",
      .draws_nothing_visible = true) {
    perspective(gl);
    Random random(31);
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        note_feedback(gl, notes, mode_name(mode), GL_4D_COLOR_TEXTURE, [&] {
            gl.Begin(mode);
            random_vertices(gl, random, 8, 1);
            gl.End();
        });
    }
}

SCENE(feedback_clipped, "every primitive cut by the volume and a user's plane",
      .draws_nothing_visible = true) {
    perspective(gl);
    const GLdouble plane[4] = {1, 0.3, 0.2, 0.5};
    gl.ClipPlane(GL_CLIP_PLANE1, plane);
    gl.Enable(GL_CLIP_PLANE1);
    Random random(32);
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        note_feedback(gl, notes, mode_name(mode), GL_3D_COLOR, [&] {
            gl.Begin(mode);
            random_vertices(gl, random, 8, 4);
            gl.End();
        });
    }
}

// Filled and smooth: the reference has no feedback for other polygon modes and forgets flat shading.
SCENE(feedback_polygons, "culled, lit on two sides", .draws_nothing_visible = true) {
    perspective(gl);
    Random random(33);
    for (int i = 0; i < 12; ++i) {
        gl.PushAttrib(GL_ALL_ATTRIB_BITS);
        if (i & 2) gl.Enable(GL_CULL_FACE);
        if (i & 4) gl.FrontFace(GL_CW);
        if (i >= 9) {
            gl.Enable(GL_LIGHTING);
            gl.Enable(GL_LIGHT0);
            gl.Enable(GL_COLOR_MATERIAL);
            gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
        }
        note_feedback(gl, notes, std::to_string(i), GL_3D_COLOR, [&] {
            for (const GLenum mode : {GL_TRIANGLES, GL_QUADS, GL_POLYGON}) {
                gl.Begin(mode);
                random_vertices(gl, random, mode == GL_POLYGON ? 5 : 12, 1);
                gl.End();
            }
        });
        gl.PopAttrib();
    }
}

SCENE(feedback_others,
      "pass-through, bitmaps and pixel rectangles, state between; each type; too small a buffer") {
    pixel_projection(gl);
    const GLubyte bits[8] = {255, 255, 255, 255, 255, 255, 255, 255};
    const std::vector<std::uint8_t> picture = painted_texels(8, 8);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (GLenum type = GL_2D; type <= GL_4D_COLOR_TEXTURE; ++type) {
        note_feedback(gl, notes, "type " + std::to_string(type), type, [&] {
            gl.PassThrough(1.5F);
            gl.Color3f(1, 0.5F, 0.25F);
            gl.TexCoord2f(0.75F, 0.125F);
            gl.RasterPos3f(10, 20, 0.5F);
            gl.Bitmap(8, 8, 0, 0, 5, 6, bits);
            gl.PassThrough(2);
            gl.DrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
            gl.CopyPixels(0, 0, 4, 4, GL_COLOR);
            gl.RasterPos3f(-10, 20, 0.5F);
            gl.Bitmap(8, 8, 0, 0, 5, 6, bits);
            gl.Clear(GL_COLOR_BUFFER_BIT);
            gl.Begin(GL_LINE_STRIP);
            gl.Vertex2f(1, 2);
            gl.Vertex2f(30, 40);
            gl.Vertex2f(50, 60);
            gl.End();
            gl.PassThrough(3);
        });
    }
    GLfloat few[4] = {};
    gl.FeedbackBuffer(4, GL_3D, few);
    gl.RenderMode(GL_FEEDBACK);
    rectangle(gl, 10, 10, 20, 20);
    notes.value("overflow", gl.RenderMode(GL_RENDER));
    notes.values("few", few);
    gl.PassThrough(9);  // ignored
    gl.Color3f(0, 1, 0);
    rectangle(gl, 30, 30, 200, 200);
}

SCENE(selection_names, "hits under names; nothing is drawn; culled and clipped things do not hit") {
    perspective(gl);
    Random random(34);
    note_selection(gl, notes, "all", 1000, [&] {
        gl.InitNames();
        gl.Begin(GL_POINTS);
        gl.Vertex3f(0, 0, 0);
        gl.End();
        gl.PushName(1);
        for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
            gl.LoadName(100 + mode);
            gl.PushName(mode);
            gl.Begin(mode);
            random_vertices(gl, random, 8, 2);
            gl.End();
            gl.PopName();
        }
        gl.Enable(GL_CULL_FACE);
        gl.LoadName(500);
        rectangle(gl, 1, 1, -1, 1);
        gl.CullFace(GL_FRONT_AND_BACK);
        rectangle(gl, -1, -1, 1, 1);
        gl.Disable(GL_CULL_FACE);
        gl.LoadName(501);
        rectangle(gl, 100, 100, 101, 101);
        gl.LoadName(502);
        gl.RasterPos3f(0, 0, 1);
        gl.LoadName(503);
        gl.RasterPos3f(50, 0, 1);
        gl.Clear(GL_COLOR_BUFFER_BIT);
    });
    gl.Color3f(1, 0, 1);
    rectangle(gl, -1, -1, 1, 1);
}

SCENE(selection_limits, "too small a buffer; a full and an empty stack; errors; queries",
      .draws_nothing_visible = true) {
    const auto point = [&] {
        gl.Begin(GL_POINTS);
        gl.Vertex2f(0, 0);
        gl.End();
    };
    note_selection(gl, notes, "overflow", 6, [&] {
        gl.InitNames();
        gl.PushName(3);
        point();
        gl.LoadName(4);
        point();
    });
    note_selection(gl, notes, "stack", 1000, [&] {
        gl.InitNames();
        gl.PopName();
        notes.value("underflow", gl.GetError());
        gl.LoadName(1);
        notes.value("load on empty", gl.GetError());
        for (GLuint i = 0; i < 64; ++i) gl.PushName(i);
        GLint depth = 0;
        gl.GetIntegerv(GL_NAME_STACK_DEPTH, &depth);
        notes.value("depth", depth);
        gl.PushName(64);
        notes.value("overflow", gl.GetError());
        point();
        GLuint other[4];
        gl.SelectBuffer(4, other);
        notes.value("buffer while selecting", gl.GetError());
        GLint mode = 0;
        gl.GetIntegerv(GL_RENDER_MODE, &mode);
        notes.value("mode", mode);
    });
    gl.LoadName(9);
    gl.PopName();
    notes.value("names while rendering", gl.GetError());
    GLfloat buffer[8];
    gl.FeedbackBuffer(8, GL_LINE, buffer);
    notes.value("no type", gl.GetError());
    gl.FeedbackBuffer(-1, GL_2D, buffer);
    notes.value("negative size", gl.GetError());
    gl.RenderMode(GL_LINE);
    notes.value("no mode", gl.GetError());
    gl.FeedbackBuffer(8, GL_3D_COLOR, buffer);
    GLint size = 0, type = 0;
    gl.GetIntegerv(GL_FEEDBACK_BUFFER_SIZE, &size);
    gl.GetIntegerv(GL_FEEDBACK_BUFFER_TYPE, &type);
    void* pointer = nullptr;
    gl.GetPointerv(GL_FEEDBACK_BUFFER_POINTER, &pointer);
    notes.value("size", size);
    notes.value("type", type);
    notes.value("pointer", pointer == buffer);
    gl.GetPointerv(GL_SELECTION_BUFFER_POINTER, &pointer);
    notes.value("selection pointer", pointer != nullptr);
    gl.GetIntegerv(GL_SELECTION_BUFFER_SIZE, &size);
    notes.value("selection size", size);
}

SCENE(selection_lists, "names and geometry in display lists", .draws_nothing_visible = true) {
    perspective(gl);
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.InitNames();
    gl.PushName(7);
    rectangle(gl, -1, -1, 1, 1);
    gl.LoadName(8);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex3f(0, 0, 0);
    gl.Vertex3f(1, 0, 1);
    gl.Vertex3f(0, 1, -1);
    gl.End();
    gl.PassThrough(4);
    gl.EndList();
    note_selection(gl, notes, "list", 1000, [&] { gl.CallList(list); });
    note_feedback(gl, notes, "feedback", GL_3D, [&] { gl.CallList(list); });
}
