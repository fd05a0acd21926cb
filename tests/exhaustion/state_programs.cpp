// Matrices, lighting, attribute stacks, evaluators, selection and feedback.
#include "program.h"

namespace terrazzo::test {
namespace {

Program matrices() {
    return {"Matrices",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.MatrixMode(GL_PROJECTION)),
             TERRAZZO_CALL(gl.Ortho(-1, 1, -1, 1, -2, 2)),
             TERRAZZO_CALL(gl.PushMatrix()),
             TERRAZZO_CALL(gl.MatrixMode(GL_MODELVIEW)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.PushMatrix()),
             TERRAZZO_CALL(gl.Translatef(0.2f, 0.1f, 0)),
             TERRAZZO_CALL(gl.Rotatef(33, 0, 0, 1)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.Scalef(0.5f, 0.7f, 1)),
             TERRAZZO_CALL(gl.PushMatrix()),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.PopMatrix()),
             TERRAZZO_CALL(gl.PopMatrix()),
             TERRAZZO_CALL(gl.Rectf(-0.1f, -0.1f, 0.1f, 0.1f)),
             TERRAZZO_CALL(gl.Viewport(4, 4, 30, 30)),
             TERRAZZO_CALL(gl.Rectf(-1, -1, -0.5f, 1)),
             TERRAZZO_CALL(gl.DepthRange(0.2, 0.7)),
             TERRAZZO_CALL(gl.LoadIdentity()),
             TERRAZZO_CALL(gl.MatrixMode(GL_TEXTURE)),
             TERRAZZO_CALL(gl.PushMatrix()),
             TERRAZZO_CALL(gl.Finish())}};
}

Program lighting() {
    return {
        "Lighting",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
         TERRAZZO_CALL(gl.Enable(GL_LIGHTING)), TERRAZZO_CALL(gl.Enable(GL_LIGHT0)),
         TERRAZZO_BLOCK("position", const GLfloat at[] = {1, 2, 3, 1};
                        gl.Lightfv(GL_LIGHT0, GL_POSITION, at);),
         TERRAZZO_BLOCK("triangle", gl.Normal3f(0, 0.3f, 1); draw_triangle(gl);),
         TERRAZZO_CALL(const GLfloat red[] = {0.8f, 0.2f, 0.1f, 1};
                       gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, red)),
         TERRAZZO_BLOCK("materials between vertices", gl.Begin(GL_TRIANGLES); gl.Vertex2f(-0.9f, -0.9f);
                        const GLfloat green[] = {0, 1, 0, 1};
                        gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, green);
                        gl.Vertex2f(0.9f, -0.9f); gl.Materialf(GL_FRONT, GL_SHININESS, 9);
                        gl.Vertex2f(0, 0.9f); gl.End();),
         TERRAZZO_CALL(gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)),
         TERRAZZO_CALL(gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR)),
         TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
         TERRAZZO_CALL(gl.ColorMaterial(GL_FRONT, GL_DIFFUSE)), TERRAZZO_CALL(gl.Enable(GL_COLOR_MATERIAL)),
         TERRAZZO_CALL(gl.Enable(GL_FOG)), TERRAZZO_CALL(gl.Rectf(-0.2f, -0.9f, 0.2f, 0.9f)),
         TERRAZZO_CALL(gl.RasterPos2f(0.1f, 0.1f)), TERRAZZO_CALL(gl.Finish())}};
}

Program attributes() {
    return {"AttributeStacks",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_CALL(gl.PushAttrib(GL_ALL_ATTRIB_BITS)),
             TERRAZZO_CALL(gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS)),
             TERRAZZO_CALL(gl.Enable(GL_SCISSOR_TEST)), TERRAZZO_CALL(gl.Scissor(3, 4, 30, 20)),
             TERRAZZO_CALL(gl.Color3f(0, 1, 1)), TERRAZZO_CALL(gl.DrawBuffer(GL_NONE)),
             TERRAZZO_CALL(gl.Rectf(-1, -1, 1, 1)),
             TERRAZZO_CALL(gl.PushAttrib(GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT)),
             TERRAZZO_CALL(gl.DrawBuffer(GL_FRONT)), TERRAZZO_CALL(gl.Rectf(-0.8f, -0.8f, 0.1f, 0.8f)),
             TERRAZZO_CALL(gl.PopAttrib()), TERRAZZO_CALL(gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1)),
             TERRAZZO_CALL(gl.PopClientAttrib()), TERRAZZO_CALL(gl.PopAttrib()),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);), TERRAZZO_CALL(gl.Finish())}};
}

std::vector<GLfloat> control_points() {
    std::vector<GLfloat> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            points.push_back(static_cast<GLfloat>(i) / 2 - 0.75f);
            points.push_back(static_cast<GLfloat>(j) / 2 - 0.75f);
            points.push_back(i == 1 && j == 2 ? 0.9f : 0.1f);
        }
    return points;
}

Program evaluators() {
    return {
        "Evaluators",
        {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
         TERRAZZO_CALL(gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, control_points().data())),
         TERRAZZO_CALL(gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, control_points().data())),
         TERRAZZO_CALL(gl.Enable(GL_MAP2_VERTEX_3)), TERRAZZO_CALL(gl.Enable(GL_MAP1_VERTEX_3)),
         TERRAZZO_CALL(gl.Enable(GL_AUTO_NORMAL)), TERRAZZO_CALL(gl.MapGrid2f(6, 0, 1, 5, 0, 1)),
         TERRAZZO_CALL(gl.MapGrid1f(9, 0, 1)), TERRAZZO_CALL(gl.Color3f(0.9f, 0.3f, 0.4f)),
         TERRAZZO_BLOCK("surface", gl.EvalMesh2(GL_FILL, 0, 6, 0, 5);), TERRAZZO_CALL(gl.Color3f(1, 1, 0)),
         TERRAZZO_BLOCK("net", gl.EvalMesh2(GL_LINE, 0, 6, 0, 5);), TERRAZZO_CALL(gl.LineWidth(2)),
         TERRAZZO_BLOCK("curve", gl.EvalMesh1(GL_LINE, 0, 9);),
         TERRAZZO_BLOCK("point", gl.Begin(GL_POINTS); gl.EvalCoord1f(0.3f); gl.EvalPoint2(2, 3); gl.End();),
         TERRAZZO_CALL(gl.Finish())}};
}

void keep_floats(Run& r, GLint count) {
    if (count > 0) r.results[0].assign(r.floats.begin(), r.floats.begin() + count);
}

Program feedback() {
    return {"Feedback",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.FeedbackBuffer(4096, GL_4D_COLOR_TEXTURE, r.floats.data())),
             TERRAZZO_CALL(gl.RenderMode(GL_FEEDBACK)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.PassThrough(5)), TERRAZZO_CALL(gl.Translatef(0.4f, 0, 0)),
             TERRAZZO_BLOCK("loop", gl.Begin(GL_LINE_LOOP); for (int i = 0; i < 5000; ++i) gl.Vertex2f(
                 i == 2500 ? 0.5f : 3.0f, i == 2500 ? 0.5f : 4.0f);
                            gl.End();),
             TERRAZZO_CALL(gl.RasterPos2f(0, 0)), TERRAZZO_CALL(gl.Bitmap(0, 0, 0, 0, 1, 1, nullptr)),
             TERRAZZO_CALL(keep_floats(r, gl.RenderMode(GL_RENDER))), TERRAZZO_CALL(gl.Finish())}};
}

Program selection() {
    return {"Selection",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(gl.SelectBuffer(256, r.selected.data())), TERRAZZO_CALL(gl.RenderMode(GL_SELECT)),
             TERRAZZO_CALL(gl.InitNames()), TERRAZZO_CALL(gl.PushName(3)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);), TERRAZZO_CALL(gl.LoadName(4)),
             TERRAZZO_CALL(gl.Rectf(-0.2f, -0.3f, 0.1f, 0.1f)), TERRAZZO_CALL(gl.PushName(9)),
             TERRAZZO_CALL(gl.Rectf(2, 2, 3, 3)), TERRAZZO_CALL(gl.PopName()),
             TERRAZZO_CALL(const GLint hits = gl.RenderMode(GL_RENDER); if (hits > 0) {
                 r.results[0].assign(r.selected.begin(), r.selected.begin() + 16);
                 r.results[1] = {static_cast<float>(hits)};
             }),
             TERRAZZO_CALL(gl.Finish())}};
}

}  // namespace

std::vector<Program> state_programs() {
    return {matrices(), lighting(), attributes(), evaluators(), feedback(), selection()};
}

}  // namespace terrazzo::test
