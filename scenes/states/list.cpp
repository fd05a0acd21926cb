// The named list: base states, which of their axes are changed, and the states of programs. What the table of
// axes gains, the list gains.
#include "list.h"

#include <algorithm>
#include <initializer_list>
#include <random>

namespace terrazzo::states {
namespace {

struct Base {
    const char* name;
    const char* state;
    std::initializer_list<Axis> changed;
};

const Base kBases[] = {
    {"plain",
     "",
     {Axis::kPrimitive, Axis::kGiven, Axis::kColour, Axis::kView, Axis::kShade, Axis::kCull, Axis::kStencil,
      Axis::kDepth, Axis::kOffset, Axis::kScissor, Axis::kClip, Axis::kSamples}},
    {"textured",
     "units=one filter=trilinear colour=constant",
     {Axis::kUnits, Axis::kTarget, Axis::kFormat, Axis::kSize, Axis::kFilter, Axis::kWrap, Axis::kEnvironment,
      Axis::kTexgen, Axis::kFog, Axis::kAlpha, Axis::kBuffer, Axis::kSamples}},
    {"sampled", "units=one", {Axis::kFormat, Axis::kTexels}},
    {"blended", "units=one blend=alpha", {Axis::kBlend, Axis::kMask}},
    {"lit", "lights=directional material=tracks-colour", {Axis::kLights, Axis::kMaterial, Axis::kGiven}},
};

struct Program {
    const char* name;
    const char* state;
};

constexpr Program kPrograms[] = {
    {"lit-trilinear", "units=one filter=trilinear lights=directional material=tracks-colour"},
    {"alpha-test-blended-quads", "primitive=quads units=one alpha=greater blend=alpha depth=read-only"},
    {"two-units-combine-sphere",
     "units=two filter=trilinear lights=directional environment=combine-interpolate texgen=sphere"},
    {"stencil-lines-offset", "primitive=mode-line stencil=masked offset=on given=list"},
    {"four-samples-lit", "samples=four units=one filter=trilinear lights=directional material=tracks-colour"},
    {"shadow-map",
     "units=one format=depth-compare texels=rendered size=1024 texgen=projective lights=specular "
     "material=tracks-colour given=list"},
    {"shadow-map-four-samples",
     "units=one format=depth-compare texels=rendered size=1024 texgen=projective lights=directional "
     "samples=four"},
    {"immediate-strips", "primitive=strips given=immediate units=one"},
    {"immediate-lit", "primitive=quads given=immediate lights=directional"},
    {"light-map", "units=two filter=linear-mipmap-nearest given=locked-arrays colour=constant depth=lequal"},
    {"light-map-fog", "units=two filter=trilinear primitive=strips given=vbo colour=constant fog=exp2"},
    {"model-immediate",
     "primitive=strips given=immediate units=one filter=linear-mipmap-nearest cull=back colour=floats"},
    {"sprites",
     "view=orthographic primitive=quads given=immediate units=one filter=nearest wrap=edge size=npot "
     "blend=alpha depth=off"},
    {"glyphs",
     "view=orthographic primitive=quads given=immediate units=one format=alpha blend=alpha depth=off "
     "colour=constant"},
    {"particles",
     "primitive=quads given=streamed-vbo units=one format=luminance-alpha blend=alpha-add depth=read-only"},
    {"cad-flat", "lights=two-sided shade=flat given=list offset=on colour=constant"},
    {"cad-wires", "primitive=smooth-lines given=list colour=constant blend=alpha"},
    {"isosurface", "given=vbo colour=floats lights=specular material=tracks-colour"},
    {"volume-slices", "units=one target=3d format=luminance-alpha blend=alpha depth=read-only wrap=edge"},
    {"environment-cube",
     "units=one target=cube filter=trilinear texgen=reflection lights=directional given=vbo"},
    {"mirror", "units=one texels=rendered given=vbo colour=constant"},
    {"depth-first", "depth=equal units=one filter=trilinear lights=directional given=vbo"},
    {"depth-alone", "mask=none given=vbo colour=constant"},
    {"depth-alone-textured", "mask=none units=one alpha=greater colour=constant"},
    {"bumps-dot3", "units=two environment=combine-dot3 given=vbo"},
    {"terrain",
     "units=three filter=anisotropic format=dxt1 primitive=strips given=vbo fog=linear colour=constant"},
    {"eight-units", "units=eight filter=trilinear colour=constant"},
    {"stencil-volumes", "stencil=sides depth=read-only given=vbo colour=constant"},
    {"wide-target", "buffer=rgba32f units=one blend=add lights=specular"},
    {"small-target", "buffer=rgb565 units=one filter=linear-mipmap-nearest fog=linear"},
    {"spot-lights-fog", "lights=spot fog=exp units=one filter=trilinear"},
    {"eight-lights", "lights=eight material=tracks-colour given=list"},
};

void add(std::vector<NamedState>& states, std::string name, const State& state) {
    const auto same = [&](const NamedState& other) { return other.state == state || other.name == name; };
    if (std::none_of(states.begin(), states.end(), same)) states.push_back({std::move(name), state});
}

void add_changes(std::vector<NamedState>& states, const Base& base) {
    const State start = State::parse(base.state);
    add(states, base.name, settled(start));
    for (const Axis axis : base.changed)
        for (std::size_t i = 0; i < entry(axis).values.size(); ++i) {
            State state = start;
            const State settled_state = settled(state.set(axis, i));
            const AxisEntry& changed = entry(axis);
            // What cannot be drawn beside the base's other values is another state by then.
            if (settled_state.index(axis) == i)
                add(states, std::string(base.name) + "/" + changed.name + "=" + changed.values[i].name,
                    settled_state);
        }
}

// The standard's distributions differ from library to library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_engine() >> 33) % count; }

  private:
    std::mt19937_64 m_engine;
};

}  // namespace

std::vector<NamedState> named_states_of_one_geometry() {
    std::vector<NamedState> states;
    for (const Program& program : kPrograms)
        add(states, std::string("program/") + program.name, settled(State::parse(program.state)));
    for (const Base& base : kBases) add_changes(states, base);
    return states;
}

std::vector<NamedState> named_states() {
    std::vector<NamedState> states;
    const AxisEntry& geometry = entry(Axis::kGeometry);
    for (std::size_t i = 0; i < geometry.values.size(); ++i)
        for (NamedState state : named_states_of_one_geometry()) {
            state.name += std::string("/") + geometry.values[i].name;
            state.state.set(Axis::kGeometry, i);
            states.push_back(std::move(state));
        }
    return states;
}

std::vector<NamedState> random_states(int count, std::uint64_t seed) {
    std::vector<NamedState> states;
    Random random(seed);
    const AxisEntry& geometry = entry(Axis::kGeometry);
    for (int i = 0; i < count; ++i) {
        State state;
        // Programs change some of it: half of the axes stay as they are. Most are textured.
        for (const AxisEntry& axis : axes())
            if (axis.axis == Axis::kUnits || random.below(2) == 0)
                state.set(axis.axis, random.below(axis.values.size()));
        const std::size_t turn = static_cast<std::size_t>(i) % geometry.values.size();
        state.set(Axis::kGeometry, turn);
        states.push_back(
            {"random/" + std::to_string(seed) + "-" + std::to_string(i) + "/" + geometry.values[turn].name,
             settled(state)});
    }
    return states;
}

}  // namespace terrazzo::states
