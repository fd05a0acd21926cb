// What goes together and what does not. Rules that only keep a setting from being meaningless set it back to
// its default; rules that keep a combination valid prefer the rarer of the two.
#include "state.h"

#include <stdexcept>

namespace terrazzo::states {
namespace {

void reset(State& state, Axis axis) {
    state.set(axis, std::size_t{0});
}

// Mip-mapped filters have no place in a texture that is drawn to or copied to in part.
void without_mipmaps(State& state) {
    if (state.number(Axis::kFilter) != GL_NEAREST) reset(state, Axis::kFilter);
}

void settle_target(State& state) {
    const bool is_depth = state.is(Axis::kFormat, "depth-compare");
    const bool is_compressed = state.number(Axis::kFormat, 1) == 0;
    // GL 1.5 §3.8.1: depth textures are 1D and 2D; S3TC has blocks of two dimensions.
    if (is_depth && state.number(Axis::kTarget, 1) > 2) reset(state, Axis::kTarget);
    if (is_compressed && !state.is(Axis::kTarget, "cube")) reset(state, Axis::kTarget);
    if (state.number(Axis::kTexels) != kUploaded) reset(state, Axis::kTarget);
    // Of 1D textures the reference crashes with it.
    const bool is_flat = state.number(Axis::kTarget, 1) == 2 || state.is(Axis::kTarget, "cube");
    if (!is_flat && state.is(Axis::kFilter, "anisotropic")) state.set(Axis::kFilter, "trilinear");
    if (!state.is(Axis::kTarget, "cube")) return;
    // The faces of a cube are not joined by filters: what lies beyond an edge is a matter of taste.
    state.set(Axis::kWrap, "edge");
    if (state.is(Axis::kTexgen, "sphere")) state.set(Axis::kTexgen, "reflection");
}

void settle_texels(State& state) {
    const GLenum texels = state.number(Axis::kTexels);
    if (texels == kUploaded) return;
    const bool may_be_drawn_to = state.is(Axis::kFormat, "rgba8") || state.is(Axis::kFormat, "depth-compare");
    if (state.number(Axis::kFormat, 1) == 0) reset(state, Axis::kFormat);
    if (texels == kRendered && !may_be_drawn_to) reset(state, Axis::kFormat);
    // What is copied is colour.
    if (texels == kCopied && state.is(Axis::kFormat, "depth-compare")) reset(state, Axis::kFormat);
    // ARB_framebuffer_object: nothing is copied from several samples.
    if (texels == kCopied) reset(state, Axis::kSamples);
    without_mipmaps(state);
}

void settle_texturing(State& state) {
    if (state.number(Axis::kUnits) == 0) {
        for (const Axis axis : {Axis::kTarget, Axis::kFormat, Axis::kSize, Axis::kFilter, Axis::kWrap,
                                Axis::kTexels, Axis::kEnvironment, Axis::kTexgen})
            reset(state, axis);
        return;
    }
    if (state.is(Axis::kEnvironment, "combine-crossbar") && state.number(Axis::kUnits) == 1)
        state.set(Axis::kUnits, "two");
    settle_texels(state);
    settle_target(state);
    // GL 1.5 table 3.22: DECAL is defined for RGB and RGBA alone.
    const bool has_colours = state.number(Axis::kFormat, 1) == 0 || state.is(Axis::kFormat, "rgba8") ||
                             state.is(Axis::kFormat, "rgb8") || state.is(Axis::kFormat, "rgb565") ||
                             state.is(Axis::kFormat, "rgba16");
    if (state.is(Axis::kEnvironment, "decal") && !has_colours && state.number(Axis::kUnits) == 1)
        reset(state, Axis::kEnvironment);
}

bool draws_polygons(const State& state) {
    const GLenum mode = state.number(Axis::kPrimitive);
    return mode != GL_LINES && mode != GL_LINE_STRIP && mode != GL_POINTS;
}

void settle_primitives(State& state) {
    if (!draws_polygons(state)) {
        reset(state, Axis::kOffset);
        reset(state, Axis::kCull);
        if (state.number(Axis::kStencil) == kSides) state.set(Axis::kStencil, "counted");
    }
    const GLenum enabled = state.number(Axis::kPrimitive, 2);
    const bool is_smooth = enabled == GL_LINE_SMOOTH || enabled == GL_POINT_SMOOTH;
    if (!is_smooth) return;
    // GL 1.5 §3.3.3, §3.4.4: with samples nothing is smoothed. Without blending nobody sees the coverage.
    reset(state, Axis::kSamples);
    if (state.is(Axis::kBlend, "none")) state.set(Axis::kBlend, "alpha");
    // §3.11: coverage is in the alpha that is tested, and little of it in thin lines.
    if (state.is(Axis::kAlpha, "greater")) reset(state, Axis::kAlpha);
}

void settle_fragments(State& state) {
    // Depths alone are drawn so that something is seen behind them.
    if (state.is(Axis::kMask, "none")) {
        reset(state, Axis::kDepth);
        reset(state, Axis::kBlend);
    }
    if (state.is(Axis::kDepth, "off") || state.is(Axis::kDepth, "always")) reset(state, Axis::kOffset);
    // The object with samples is copied to a buffer of its own format.
    if (state.number(Axis::kSamples) > 1) reset(state, Axis::kBuffer);
    // GL 1.5 §4.1.9 says nothing of logic operations on floats.
    if (state.number(Axis::kBlend) == GL_COLOR_LOGIC_OP && state.is(Axis::kBuffer, "rgba32f"))
        reset(state, Axis::kBuffer);
}

}  // namespace

State& State::set(Axis axis, std::size_t index) {
    if (index >= entry(axis).values.size()) throw std::invalid_argument("no such value");
    m_values[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(index);
    return *this;
}

std::string State::text() const {
    std::string result;
    for (const AxisEntry& axis : axes()) {
        if (index(axis.axis) == 0) continue;
        if (!result.empty()) result += ' ';
        result += std::string(axis.name) + "=" + value(axis.axis).name;
    }
    return result;
}

State State::parse(std::string_view text) {
    State state;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        const std::size_t equals = word.find('=');
        if (equals == std::string_view::npos)
            throw std::invalid_argument(std::string(word) + " is not AXIS=VALUE");
        const AxisEntry& axis = axis_called(word.substr(0, equals));
        state.set(axis.axis, value_called(axis, word.substr(equals + 1)));
    }
    return state;
}

const char* reference_defect(const State& state) {
    const bool has_samples = state.number(Axis::kSamples) > 1;
    const bool is_filled = draws_polygons(state) && state.number(Axis::kPrimitive, 3) == GL_FILL;
    if (has_samples && state.number(Axis::kScissor))
        return "with samples a pixel beyond the scissor is drawn";
    if (has_samples && !is_filled)
        return "with samples lines and points lose pixels where a block of pixels ends";
    if (!is_filled && state.number(Axis::kStencil) == kSides)
        return "lines and points of back sides undergo the stencil test of front sides";
    const bool is_stippled = state.number(Axis::kPrimitive, 2) == GL_POLYGON_STIPPLE;
    if (is_stippled && state.number(Axis::kTexels) == kRendered)
        return "the polygon stipple of a window is turned over after drawing to an object";
    const bool is_compared = state.is(Axis::kFormat, "depth-compare");
    if (is_compared && state.is(Axis::kTarget, "1d"))
        return "1D depth textures are compared with t instead of r";
    if (state.is(Axis::kFilter, "anisotropic") && (is_compared || state.is(Axis::kTarget, "cube")))
        return "anisotropic cube maps and comparisons take another quad's or no number";
    const bool has_chain =
        !is_filled ? state.number(Axis::kPrimitive, 2) != 0 || draws_polygons(state) : is_stippled;
    if (has_chain && state.is(Axis::kMask, "none"))
        return "what is drawn after stages of their own may still use their rasterization state";
    return nullptr;
}

State settled(State state) {
    settle_texturing(state);
    settle_primitives(state);
    if (state.number(Axis::kLights) == 0) reset(state, Axis::kMaterial);
    settle_fragments(state);
    return state;
}

}  // namespace terrazzo::states
