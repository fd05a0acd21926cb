// Capabilities, attribute stacks, hints, queries, evaluators, selection and feedback (GL 1.5 §4.1.7, §5,
// §6.1.14).
#include <iterator>

#include "commands.h"

namespace terrazzo::test {
namespace {

const Enumerants kEvaluators = {TERRAZZO_E(GL_AUTO_NORMAL), TERRAZZO_E(GL_MAP1_VERTEX_3),
                                TERRAZZO_E(GL_MAP2_COLOR_4), TERRAZZO_E(GL_MAP2_TEXTURE_COORD_2)};

const Enumerants kHints = {TERRAZZO_E(GL_PERSPECTIVE_CORRECTION_HINT), TERRAZZO_E(GL_POINT_SMOOTH_HINT),
                           TERRAZZO_E(GL_LINE_SMOOTH_HINT), TERRAZZO_E(GL_POLYGON_SMOOTH_HINT),
                           TERRAZZO_E(GL_FOG_HINT)};

const GLbitfield kAttributeBits[] = {GL_ACCUM_BUFFER_BIT, GL_COLOR_BUFFER_BIT,   GL_CURRENT_BIT,
                                     GL_DEPTH_BUFFER_BIT, GL_ENABLE_BIT,         GL_EVAL_BIT,
                                     GL_FOG_BIT,          GL_HINT_BIT,           GL_LIGHTING_BIT,
                                     GL_LINE_BIT,         GL_LIST_BIT,           GL_PIXEL_MODE_BIT,
                                     GL_POINT_BIT,        GL_POLYGON_BIT,        GL_POLYGON_STIPPLE_BIT,
                                     GL_SCISSOR_BIT,      GL_STENCIL_BUFFER_BIT, GL_TEXTURE_BIT,
                                     GL_TRANSFORM_BIT,    GL_VIEWPORT_BIT,       GL_ALL_ATTRIB_BITS};

void play_evaluator(Player& p) {
    const auto v = p.moderate_numbers(4);
    const auto segments = static_cast<GLint>(p.pick(6));
    p.note(std::to_string(segments));
    switch (p.pick(4)) {
        case 0:
            return p.gl().MapGrid1f(segments, v[0], v[1]);
        case 1:
            return p.gl().MapGrid2f(segments, v[0], v[1], 3, v[2], v[3]);
        case 2:
            return p.gl().Enable(p.enumerant(kEvaluators));
    }
    p.gl().Disable(p.enumerant(kEvaluators));
}

// Never selection or feedback for long: other commands mean something else then.
void play_render_mode(Player& p) {
    static GLuint names[64];
    static GLfloat values[64];
    const auto size = static_cast<GLsizei>(p.pick(60)) - 4;
    p.note(std::to_string(size));
    if (p.pick(2)) {
        p.gl().SelectBuffer(size, names);
        if (size <= 0) return;
        p.gl().RenderMode(GL_SELECT);
        for (unsigned i = p.pick(4); i > 0; --i) p.gl().PushName(i);
        for (unsigned i = p.pick(5); i > 0; --i) p.gl().PopName();
    } else {
        p.gl().FeedbackBuffer(size, GL_2D + p.pick(6), values);
        if (size <= 0) return;
    }
    p.gl().RenderMode(GL_RENDER);
}

// The reference forgets, when a stack entry is popped, that groups which this entry had not saved were
// changed, and then leaves them as they are when the entry below is popped. So what is nested saves
// everything. Nor does it restore which lights are enabled for GL_ENABLE_BIT, as GL 1.5 table 6.12 has it.
void play_push_attrib(Player& p) {
    GLint depth = 0;
    p.gl().GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    GLbitfield mask = 0;
    for (unsigned i = p.pick(4) + 1; i > 0; --i) mask |= kAttributeBits[p.pick(std::size(kAttributeBits))];
    if (depth > 0) mask = GL_ALL_ATTRIB_BITS;
    if (mask & GL_ENABLE_BIT) mask |= GL_LIGHTING_BIT;
    p.note(std::to_string(mask));
    p.gl().PushAttrib(mask);
}

void play_query(Player& p) {
    const GLuint name = p.pick(3);
    GLuint result = 0;
    const unsigned choice = p.pick(6);
    p.note(std::to_string(name) + ' ' + std::to_string(choice));
    const Enumerants target = {TERRAZZO_E(GL_SAMPLES_PASSED)};
    switch (choice) {
        case 0:
        case 1:
            return p.gl().BeginQuery(p.enumerant(target), name);
        case 2:
            return p.gl().EndQuery(p.enumerant(target));
        case 3:
            return p.gl().DeleteQueries(1, &name);
        case 4:
            p.gl().GetQueryObjectuiv(name, p.enumerant({TERRAZZO_E(GL_QUERY_RESULT)}), &result);
            return p.note("result " + std::to_string(result));
    }
    p.note(std::to_string(p.gl().IsQuery(name)));
}

const Command kCommands[] = {
    {"glEnable", [](Player& p) { p.gl().Enable(p.enumerant(kCapabilities)); }},
    {"glEnable", [](Player& p) { p.gl().Enable(p.enumerant(kCapabilities)); }},
    {"glDisable", [](Player& p) { p.gl().Disable(p.enumerant(kCapabilities)); }},
    {"glHint",
     [](Player& p) {
         const GLenum target = p.enumerant(kHints);
         p.gl().Hint(target,
                     p.enumerant({TERRAZZO_E(GL_FASTEST), TERRAZZO_E(GL_NICEST), TERRAZZO_E(GL_DONT_CARE)}));
     }},
    {"glPushAttrib", play_push_attrib},
    {"evaluator", play_evaluator},
    {"glRenderMode", play_render_mode},
    {"query", play_query},
    {"glListBase", [](Player& p) { p.gl().ListBase(p.pick(9)); }},
    {"glPopAttrib", [](Player& p) { p.gl().PopAttrib(); }},
    {"glPushClientAttrib", [](Player& p) { p.gl().PushClientAttrib(p.pick(4)); }},
    {"glPopClientAttrib", [](Player& p) { p.gl().PopClientAttrib(); }},
};

}  // namespace

std::span<const Command> modes_commands() {
    return kCommands;
}

}  // namespace terrazzo::test
