// The vertex program: fetch, transform, light, texgen, 16 vertices at a time, into the columns of
// ShadedVertices.
//
// Clip and window coordinates are the reference's bit for bit (doc/reference.md §2): products and sums of the
// matrix product are rounded one by one, the viewport is one fused step.
#include "pipeline/geometry/geometry_table.h"
#include "pipeline/geometry/program/texgen.h"
#include "pipeline/geometry/setup/setup_triangles.h"

namespace terrazzo::TERRAZZO_ISA_NAMESPACE {

namespace {

// One bit a plane where the vertex is outside, or not a number.
I32x16 outcode(const VertexState& state, const Wide4& clip) {
    const F32x16 zero(0.0f);
    const auto flag = [](Mask16 inside, uint32_t bit) {
        return select(inside, I32x16(0), I32x16(static_cast<int32_t>(bit)));
    };
    I32x16 code = flag(clip.x <= clip.w, kOutsideRight) | flag(clip.x + clip.w >= zero, kOutsideLeft) |
                  flag(clip.y <= clip.w, kOutsideTop) | flag(clip.y + clip.w >= zero, kOutsideBottom);
    if (state.clips_depth)
        code = code | flag((state.zero_to_one ? clip.z : clip.z + clip.w) >= zero, kOutsideNear) |
               flag(clip.z <= clip.w, kOutsideFar);
    for (int p = 0; p < kMaxClipPlanes; ++p) {
        if (!(state.clip_plane_mask >> p & 1)) continue;
        const float* const plane = state.clip_planes[p];
        F32x16 distance = clip.x * F32x16(plane[0]);
        distance = fused_multiply_add(clip.y, F32x16(plane[1]), distance);
        distance = fused_multiply_add(clip.z, F32x16(plane[2]), distance);
        distance = fused_multiply_add(clip.w, F32x16(plane[3]), distance);
        code = code | flag(distance >= zero, static_cast<uint32_t>(kOutsideUser) << p);
    }
    return code;
}

I32x16 snap(F32x16 window, float origin) {
    // No window reaches that far (snap.h): what is not a number, or divided by zero, goes there.
    const F32x16 limit(16777216.0f);
    return round_to_int(clamp((window - F32x16(origin)) * F32x16(256.0f), -limit, limit));
}

void store_position(const VertexState& state, const Wide4& clip, ShadedVertices& out, int at) {
    const F32x16 oow = F32x16(1.0f) / clip.w;
    const auto window = [&](F32x16 c, int axis) {
        return fused_multiply_add(c * oow, F32x16(state.viewport_scale[axis]),
                                  F32x16(state.viewport_translate[axis]));
    };
    const F32x16 x = window(clip.x, 0), y = window(clip.y, 1), z = window(clip.z, 2);
    store(clip.x, out.column(kClipX) + at);
    store(clip.y, out.column(kClipY) + at);
    store(clip.z, out.column(kClipZ) + at);
    store(clip.w, out.column(kClipW) + at);
    store(x, out.column(kWindowX) + at);
    store(y, out.column(kWindowY) + at);
    store(z, out.column(kWindowZ) + at);
    store(oow, out.column(kWindowOow) + at);
    store(snap(x, state.snap_origin), out.integers(kSnappedX) + at);
    store(snap(y, state.snap_origin), out.integers(kSnappedY) + at);
    store(outcode(state, clip), out.integers(kOutcode) + at);
}

// min first: a colour that is not a number becomes 1.
F32x16 clamp_color(F32x16 c) {
    return max(min(c, F32x16(1.0f)), F32x16(0.0f));
}

void store_color(const Wide4& c, ShadedVertices& out, int column, int at) {
    const F32x16 channels[4] = {c.x, c.y, c.z, c.w};
    for (int i = 0; i < 4; ++i) store(clamp_color(channels[i]), out.column(column + i) + at);
}
void store_secondary(const Wide3& c, ShadedVertices& out, int column, int at) {
    const F32x16 channels[3] = {c.x, c.y, c.z};
    for (int i = 0; i < 3; ++i) store(clamp_color(channels[i]), out.column(column + i) + at);
}

Wide3 transform_normal(const VertexState& state, const Wide4& n) {
    const float* const m = state.normal_matrix;
    Wide3 out{n.x, n.y, n.z};
    if (state.eye_space) {
        const float columns[3][3] = {{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}};
        out = {dot(out, wide3(columns[0])), dot(out, wide3(columns[1])), dot(out, wide3(columns[2]))};
    }
    if (state.normal_scaling == NormalScaling::kNormalize) return normalize(out);
    if (state.normal_scaling == NormalScaling::kRescale) return scale(out, F32x16(state.rescale_factor));
    return out;
}

void store_colors(const VertexState& state, const VertexInput& input, const ElementBatch& batch,
                  const Wide4& eye, const Wide3& normal, ShadedVertices& out, int at) {
    const raster::Varyings& v = state.varyings;
    const Wide4 color = fetch(input, kColor, batch);
    const Lighting& lighting = state.lighting;
    if (!lighting.enabled) {
        if (v.color >= 0) store_color(color, out, kFirstVarying + v.color, at);
        if (v.secondary >= 0) {
            const Wide4 second = fetch(input, kSecondaryColor, batch);
            store_secondary({second.x, second.y, second.z}, out, kFirstVarying + v.secondary, at);
        }
        return;
    }
    LitColor lit[2];
    light_vertices(lighting, input, batch, color, {eye.x, eye.y, eye.z}, normal, lit);
    for (int face = 0; face < (lighting.two_sided ? 2 : 1); ++face) {
        const int base = kFirstVarying + (face == 0 ? 0 : v.count);
        store_color(lit[face].color, out, base + v.color, at);
        if (v.secondary >= 0) store_secondary(lit[face].specular, out, base + v.secondary, at);
    }
}

// What of a vertex the state asks for besides its clip position.
struct Needs {
    bool normal, eye;
};

Needs needs_of(const VertexState& state) {
    const Lighting& lighting = state.lighting;
    Needs needs{lighting.enabled,
                state.varyings.fog >= 0 && state.fog_distance != FogDistance::kGiven &&
                    !(state.fog_eye_z_alone && state.fog_distance != FogDistance::kEyeRadial)};
    if (lighting.enabled) {
        needs.eye = needs.eye || lighting.local_viewer;
        for (int i = 0; i < lighting.light_count; ++i)
            needs.eye = needs.eye || lighting.lights[static_cast<size_t>(i)].positional;
    }
    for (const TextureCoordinates& unit : state.texture) {
        if (!unit.used) continue;
        for (const TexgenMode mode : unit.texgen) {
            needs.normal = needs.normal || mode >= TexgenMode::kSphereMap;
            needs.eye = needs.eye || mode >= TexgenMode::kEyeLinear;
        }
    }
    return needs;
}

// Backwards, as the reference adds where it needs no other coordinate.
F32x16 eye_z_alone(const VertexState& state, const Wide4& position) {
    const float* const m = state.modelview;
    const float row[4] = {m[2], m[6], m[10], m[14]};
    return dot4(row, position);
}

F32x16 attenuated_point_size(const VertexState& state, F32x16 distance) {
    const float* const k = state.point_attenuation;
    const F32x16 sum = F32x16(k[0]) + distance * (F32x16(k[1]) + distance * F32x16(k[2]));
    const F32x16 size = F32x16(state.point_size) * (F32x16(1.0f) / sqrt(abs(sum)));
    return min(max(size, F32x16(state.point_size_min)), F32x16(state.point_size_max));
}

F32x16 fog_distance(const VertexState& state, const VertexInput& input, const ElementBatch& batch,
                    const Wide4& position, const Wide4& eye) {
    if (state.fog_distance == FogDistance::kGiven) return abs(fetch(input, kFogCoordinate, batch).x);
    if (state.fog_distance == FogDistance::kEyeRadial) {
        const Wide3 from_eye{eye.x, eye.y, eye.z};
        return sqrt(dot(from_eye, from_eye));
    }
    const F32x16 z = state.fog_eye_z_alone ? eye_z_alone(state, position) : eye.z;
    return state.fog_distance == FogDistance::kEyePlane ? z : abs(z);
}

void shade_batch(const VertexState& state, const Needs& needs, const VertexInput& input,
                 const ElementBatch& batch, ShadedVertices& out, int at) {
    const raster::Varyings& v = state.varyings;
    const Wide4 position = fetch(input, kPosition, batch);
    store_position(state, transform(state.mvp, position), out, at);

    TexgenSource source{position, position, {0.0f, 0.0f, 0.0f}};
    if (needs.eye) source.eye = transform(state.modelview, position);
    if (needs.normal) source.normal = transform_normal(state, fetch(input, kNormal, batch));
    if (v.color >= 0 || v.secondary >= 0)
        store_colors(state, input, batch, source.eye, source.normal, out, at);
    if (v.fog >= 0) {
        store(fog_distance(state, input, batch, position, source.eye),
              out.column(kFirstVarying + v.fog) + at);
    }
    if (state.point_attenuated) {
        const F32x16 z = needs.eye ? source.eye.z : eye_z_alone(state, position);
        store(attenuated_point_size(state, abs(z)), out.column(kPointSizeColumn) + at);
    }
    for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
        const int first = v.texture[static_cast<size_t>(unit)];
        if (first < 0) continue;
        const Wide4 c = texture_coordinates(state.texture[static_cast<size_t>(unit)],
                                            fetch(input, kTexture0 + unit, batch), source);
        store(c.x, out.column(kFirstVarying + first) + at);
        store(c.y, out.column(kFirstVarying + first + 1) + at);
        if (v.uses_r >> unit & 1) store(c.z, out.column(kFirstVarying + first + 2) + at);
        if (v.projective >> unit & 1) store(c.w, out.column(kFirstVarying + first + 3) + at);
    }
    if (state.edge_flags) {
        const Mask16 set = fetch(input, kEdgeFlag, batch).x != F32x16(0.0f);
        store(select(set, I32x16(1), I32x16(0)), out.integers(kEdgeFlagColumn) + at);
    }
}

void shade_vertices(const VertexState& state, const VertexInput& input, const uint32_t* elements,
                    uint32_t first, int count, ShadedVertices& out) {
    const Needs needs = needs_of(state);
    for (int at = 0; at < count; at += 16) {
        const ElementBatch batch{elements ? elements + at : nullptr, first + static_cast<uint32_t>(at),
                                 std::min(count - at, 16)};
        shade_batch(state, needs, input, batch, out, at);
    }
}

}  // namespace

extern const GeometryTable kGeometryTable;
const GeometryTable kGeometryTable = {shade_vertices, setup_triangles};

}  // namespace terrazzo::TERRAZZO_ISA_NAMESPACE
