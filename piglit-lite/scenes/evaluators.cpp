// Chapter: evaluators (GL 1.5 §5.1).
#include "helpers.h"

using namespace terrazzo::piglit;

namespace {

std::vector<GLfloat> random_points(Random& random, int count, float low = -1, float high = 1) {
    std::vector<GLfloat> points(static_cast<std::size_t>(count));
    for (GLfloat& value : points) value = random(low, high);
    return points;
}

// The vertices that draw() makes, by way of feedback.
template <typename Draw>
void note_vertices(const Gl& gl, Notes& notes, const std::string& name, Draw draw) {
    std::vector<GLfloat> buffer(4096);
    gl.FeedbackBuffer(4096, GL_4D_COLOR_TEXTURE, buffer.data());
    gl.RenderMode(GL_FEEDBACK);
    draw();
    const GLint written = gl.RenderMode(GL_RENDER);
    notes.value(name + " written", written);
    for (GLint i = 0; i < written; ++i)
        if (buffer[static_cast<std::size_t>(i)] != GLfloat{GL_LINE_RESET_TOKEN})  // the reference has none
            notes.value(name + '[' + std::to_string(i) + ']',
                        static_cast<double>(buffer[static_cast<std::size_t>(i)]));
}

// A patch over the window with some relief.
void wavy_patch(const Gl& gl, Random& random, int u_order, int v_order, float u2 = 1, float v2 = 1) {
    std::vector<GLfloat> points;
    for (int i = 0; i < u_order; ++i) {
        for (int j = 0; j < v_order; ++j) {
            points.push_back(-0.9F + 1.8F * static_cast<float>(i) / static_cast<float>(u_order - 1));
            points.push_back(-0.9F + 1.8F * static_cast<float>(j) / static_cast<float>(v_order - 1));
            points.push_back(random(-0.9F, 0.9F));
        }
    }
    gl.Map2f(GL_MAP2_VERTEX_3, 0, u2, 3 * v_order, u_order, 0, v2, 3, v_order, points.data());
    gl.Enable(GL_MAP2_VERTEX_3);
}

void light_up(const Gl& gl) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_NORMALIZE);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    const Colour diffuse = hue(0.1F), specular = hue(0.6F);
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, diffuse.data());
    gl.Materialfv(GL_BACK, GL_DIFFUSE, hue(0.8F).data());
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular.data());
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
    gl.Enable(GL_DEPTH_TEST);
}

}  // namespace

SCENE(evaluators_curves, "curves of every order: positions, colours, texture coordinates",
      .draws_nothing_visible = true) {
    Random random(41);
    gl.Enable(GL_MAP1_COLOR_4);
    for (int order = 1; order <= 12; ++order) {
        const bool four = order % 2 == 0;
        const GLenum target = four ? GL_MAP1_VERTEX_4 : GL_MAP1_VERTEX_3;
        std::vector<GLfloat> points = random_points(random, 6 * order, -0.9F, 0.9F);
        for (int i = 0; four && i < order; ++i) points[static_cast<std::size_t>(5 * i + 3)] = random(1, 1.2F);
        gl.Disable(four ? GL_MAP1_VERTEX_3 : GL_MAP1_VERTEX_4);
        gl.Enable(target);
        gl.Map1f(target, -0.5F, 2, 5, order, points.data());
        gl.Map1f(GL_MAP1_COLOR_4, 0, 3, 4, order, random_points(random, 4 * order, 0, 1).data());
        const GLenum texture = GL_MAP1_TEXTURE_COORD_1 + static_cast<GLenum>(order % 4);
        gl.Map1f(texture, 1, 0, 4, order, random_points(random, 4 * order).data());
        gl.Enable(texture);
        note_vertices(gl, notes, std::to_string(order), [&] {
            gl.Begin(GL_POINTS);
            for (int i = 0; i < 4; ++i) gl.EvalCoord1f(random(-0.5F, 2));
            gl.EvalCoord1d(0.25);
            gl.End();
            gl.MapGrid1f(5, -0.5F, 2);
            gl.EvalMesh1(GL_POINT, 0, 5);
            gl.Begin(GL_POINTS);
            for (int i = 0; i <= 5; ++i) gl.EvalPoint1(i);
            gl.End();
        });
        gl.Disable(texture);
    }
}

SCENE(evaluators_surfaces, "surfaces of all orders, with and without normals",
      .draws_nothing_visible = true) {
    Random random(42);
    gl.Enable(GL_MAP2_VERTEX_3);
    for (int u_order = 2; u_order <= 6; ++u_order) {
        for (int v_order = 2; v_order <= 6; ++v_order) {
            gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3 * v_order, u_order, -1, 1, 3, v_order,
                     random_points(random, 3 * u_order * v_order, -0.9F, 0.9F).data());
            if (v_order % 2) {
                gl.Enable(GL_AUTO_NORMAL);
            } else {
                gl.Disable(GL_AUTO_NORMAL);
            }
            gl.MapGrid2d(3, 0, 1, 2, -1, 1);
            note_vertices(gl, notes, std::to_string(10 * u_order + v_order), [&] {
                gl.Begin(GL_POINTS);
                for (int i = 0; i < 4; ++i) InOrder{gl.EvalCoord2f, random(0, 1), random(-1, 1)};
                gl.EvalPoint2(2, 1);
                gl.End();
                gl.EvalMesh2(GL_POINT, 0, 3, 0, 2);
            });
        }
    }
}

SCENE(evaluators_normals, "lit patches of all orders: automatic normals, also of rational ones") {
    light_up(gl);
    Random random(43);
    for_viewports(gl, 4, 4, [&](int cell) {
        const int u_order = 2 + cell % 4, v_order = 2 + cell / 4;
        gl.Enable(GL_AUTO_NORMAL);
        gl.MapGrid2f(10, 0, 1, 8, 0, 1);
        if (cell % 3 != 1) {
            wavy_patch(gl, random, u_order, v_order);
        } else {
            std::vector<GLfloat> points;
            for (int i = 0; i < u_order; ++i) {
                for (int j = 0; j < v_order; ++j) {
                    const float w = random(0.7F, 1.3F);
                    points.push_back(
                        w * (-0.9F + 1.8F * static_cast<float>(i) / static_cast<float>(u_order - 1)));
                    points.push_back(
                        w * (-0.9F + 1.8F * static_cast<float>(j) / static_cast<float>(v_order - 1)));
                    points.push_back(w * random(-0.9F, 0.9F));
                    points.push_back(w);
                }
            }
            gl.Disable(GL_MAP2_VERTEX_3);
            gl.Map2f(GL_MAP2_VERTEX_4, 0, 1, 4 * v_order, u_order, 0, 1, 4, v_order, points.data());
            gl.Enable(GL_MAP2_VERTEX_4);
        }
        gl.EvalMesh2(GL_FILL, 0, 10, 0, 8);
        gl.Disable(GL_MAP2_VERTEX_4);
    });
}

SCENE(evaluators_meshes, "meshes as points, lines and filled, with colours, in display lists") {
    Random random(44);
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    wavy_patch(gl, random, 4, 4);
    gl.Map2f(GL_MAP2_COLOR_4, 0, 1, 4, 2, 0, 1, 8, 2, random_points(random, 16, 0, 1).data());
    gl.Enable(GL_MAP2_COLOR_4);
    gl.MapGrid2f(12, 0, 1, 9, 0, 1);
    gl.EndList();
    gl.CallList(list);
    gl.PointSize(3);
    for_viewports(gl, 2, 2, [&](int cell) {
        constexpr GLenum kModes[] = {GL_POINT, GL_LINE, GL_FILL, GL_FILL};
        gl.PolygonMode(GL_FRONT_AND_BACK, cell == 3 ? GL_LINE : GL_FILL);
        gl.EvalMesh2(kModes[cell], cell == 2 ? 3 : 0, 12, 0, cell == 2 ? 5 : 9);
    });
}

SCENE(evaluators_texture, "a textured patch between other vertices; the current values stay") {
    gl.BindTexture(GL_TEXTURE_2D, painted_texture(gl, 32, 32, GL_LINEAR, GL_LINEAR));
    gl.Enable(GL_TEXTURE_2D);
    Random random(45);
    wavy_patch(gl, random, 3, 4);
    const GLfloat corners[8] = {0, 0, 0, 1, 1, 0, 1, 1};
    gl.Map2f(GL_MAP2_TEXTURE_COORD_2, 0, 1, 4, 2, 0, 1, 2, 2, corners);
    gl.Enable(GL_MAP2_TEXTURE_COORD_2);
    gl.MapGrid2f(20, 0, 1, 20, 0, 1);
    gl.EvalMesh2(GL_FILL, 0, 20, 0, 20);
    gl.TexCoord2f(0.25F, 0.5F);
    gl.Begin(GL_TRIANGLES);
    gl.EvalCoord2f(0.1F, 0.2F);
    gl.Vertex2f(0.9F, -0.9F);
    gl.EvalCoord2f(0.9F, 0.8F);
    gl.End();
    gl.EvalCoord2f(0.1F, 0.2F);  // ignored
    GLfloat coordinates[4];
    gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, coordinates);
    notes.values("current", coordinates);
}

SCENE(evaluators_queries, "maps and grids as they are kept; errors; GL_EVAL_BIT",
      .draws_nothing_visible = true) {
    Random random(46);
    const auto note_map = [&](GLenum target, const char* name) {
        GLint order[2] = {-1, -1}, integers[36] = {};
        GLfloat domain[4] = {}, points[36] = {};
        GLdouble doubles[36] = {};
        gl.GetMapiv(target, GL_ORDER, order);
        gl.GetMapfv(target, GL_DOMAIN, domain);
        gl.GetMapfv(target, GL_COEFF, points);
        gl.GetMapdv(target, GL_COEFF, doubles);
        gl.GetMapiv(target, GL_COEFF, integers);
        notes.values(std::string(name) + " order", order);
        notes.values(std::string(name) + " domain", domain);
        notes.values(std::string(name) + " points", points);
        notes.values(std::string(name) + " doubles", doubles);
        notes.values(std::string(name) + " integers", integers);
    };
    for (GLenum target = GL_MAP1_COLOR_4; target <= GL_MAP1_VERTEX_4; ++target) note_map(target, "initial 1");
    for (GLenum target = GL_MAP2_COLOR_4; target <= GL_MAP2_VERTEX_4; ++target) note_map(target, "initial 2");
    std::vector<GLdouble> points(64);
    for (GLdouble& value : points) value = static_cast<double>(random(-3, 3));
    gl.Map1d(GL_MAP1_NORMAL, 2, -1, 4, 3, points.data());
    gl.Map2d(GL_MAP2_TEXTURE_COORD_3, 0.5, 1.5, 4, 3, -2, 2, 13, 4, points.data());
    note_map(GL_MAP1_NORMAL, "normal");
    note_map(GL_MAP2_TEXTURE_COORD_3, "texture");
    gl.PushAttrib(GL_EVAL_BIT);
    gl.MapGrid1f(7, 0.5F, 2);
    gl.MapGrid2f(3, 0.25F, 2, 4, -1, 1);
    gl.Enable(GL_MAP1_INDEX);
    gl.Enable(GL_AUTO_NORMAL);
    const auto note_grids = [&](const char* name) {
        GLint segments[3] = {};
        GLfloat domain[6] = {};
        gl.GetIntegerv(GL_MAP1_GRID_SEGMENTS, segments);
        gl.GetIntegerv(GL_MAP2_GRID_SEGMENTS, segments + 1);
        gl.GetFloatv(GL_MAP1_GRID_DOMAIN, domain);
        gl.GetFloatv(GL_MAP2_GRID_DOMAIN, domain + 2);
        notes.values(std::string(name) + " segments", segments);
        notes.values(std::string(name) + " domain", domain);
        notes.value(std::string(name) + " index", gl.IsEnabled(GL_MAP1_INDEX));
        notes.value(std::string(name) + " automatic", gl.IsEnabled(GL_AUTO_NORMAL));
    };
    note_grids("set");
    gl.PopAttrib();
    note_grids("popped");
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_EVAL_ORDER, &most);
    notes.value("highest order", most);
    const std::vector<GLfloat> many(4096);
    const auto note_error = [&](const char* name) { notes.value(name, gl.GetError()); };
    gl.Map1f(GL_MAP1_VERTEX_3, 1, 1, 3, 2, many.data());
    note_error("empty domain");
    gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, many.data());
    note_error("short stride");
    gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 31, many.data());
    note_error("high order");
    gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, many.data());
    note_error("order 0");
    gl.Map1f(GL_LIGHT0, 0, 1, 3, 2, many.data());
    note_error("no map");
    gl.MapGrid1f(0, 0, 1);
    note_error("no segment");
    gl.EvalMesh1(GL_FILL, 0, 1);
    note_error("filled curve");
    gl.EvalMesh2(GL_QUADS, 0, 1, 0, 1);
    note_error("no mode");
    GLfloat nothing[4];
    gl.GetMapfv(GL_MAP1_VERTEX_3, GL_FOG, nothing);
    note_error("no query");
}
