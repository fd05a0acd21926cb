// Points, lines, polygons and their coverage (GL 1.5 §3.2 to §3.5).
#include "commands.h"

namespace terrazzo::test {
namespace {

void play_point_parameter(Player& p) {
    if (p.pick(2)) return p.gl().PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, p.numbers(3).data());
    p.gl().PointParameterf(p.enumerant({TERRAZZO_E(GL_POINT_SIZE_MIN), TERRAZZO_E(GL_POINT_SIZE_MAX),
                                        TERRAZZO_E(GL_POINT_FADE_THRESHOLD_SIZE)}),
                           p.number());
}

void play_polygon_stipple(Player& p) {
    // Large enough for what play_pixel_store may ask to skip.
    std::vector<GLubyte> pattern(2048);
    for (GLubyte& byte : pattern) byte = static_cast<GLubyte>(p.bits());
    p.gl().PolygonStipple(pattern.data());
}

const Command kCommands[] = {
    {"glPointSize", [](Player& p) { p.gl().PointSize(p.number()); }},
    {"glPointParameter", play_point_parameter},
    {"glSampleCoverage",
     [](Player& p) {
         const GLfloat value = p.number();
         p.gl().SampleCoverage(value, p.flag());
     }},
    {"glLineWidth", [](Player& p) { p.gl().LineWidth(p.number()); }},
    {"glLineStipple",
     [](Player& p) {
         const GLint factor = p.integer();
         p.gl().LineStipple(factor, static_cast<GLushort>(p.bits()));
     }},
    {"glPolygonMode",
     [](Player& p) {
         const GLenum face = p.enumerant(kFaces);
         p.gl().PolygonMode(face,
                            p.enumerant({TERRAZZO_E(GL_POINT), TERRAZZO_E(GL_LINE), TERRAZZO_E(GL_FILL)}));
     }},
    {"glPolygonOffset",
     [](Player& p) {
         const auto v = p.numbers(2);
         p.gl().PolygonOffset(v[0], v[1]);
     }},
    {"glPolygonStipple", play_polygon_stipple},
    {"glCullFace", [](Player& p) { p.gl().CullFace(p.enumerant(kFaces)); }},
    {"glFrontFace",
     [](Player& p) {
         p.gl().FrontFace(p.enumerant({TERRAZZO_E(GL_CW), TERRAZZO_E(GL_CCW)}));
     }},
};

}  // namespace

std::span<const Command> rasterization_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
