// From GL state to the pipeline's: the one place where GL's terms become DrawState. Each part is remade only
// when the state it is made from has changed.
#include "gl/validate.h"

#include <algorithm>
#include <cmath>

#include "gl/context.h"
#include "gl/draw.h"
#include "gl/limits.h"
#include "gl/share.h"
#include "gl/translate.h"
#include "pipeline/schedule/statistics.h"

namespace terrazzo::gl {
namespace {

using pipeline::bit;

// GL 1.5 §3.2.1: whether fragments have a coverage for each sample.
bool multisamples(const Context& ctx) {
    return ctx.rasterization.multisample.enabled && ctx.surface.format.samples > 1;
}

bool is_dirty(const Context& ctx, Dirty what) {
    return (ctx.dirty & static_cast<unsigned>(what)) != 0;
}

float unit(GLfloat value) {
    return std::clamp(value, 0.0f, 1.0f);
}

// doc/reference.md §1: y counts as the target's rows do, downwards in a window.
void make_viewport(const Context& ctx, pipeline::VertexState& out) {
    const ViewportState& v = ctx.framebuffer.viewport;
    const float half_width = 0.5f * static_cast<float>(v.width),
                half_height = 0.5f * static_cast<float>(v.height);
    out.viewport_scale[0] = half_width;
    out.viewport_translate[0] = half_width + static_cast<float>(v.x);
    const TransformState& transform = ctx.matrix.transform;
    out.viewport_scale[1] = transform.clip_origin == GL_UPPER_LEFT ? -half_height : half_height;
    out.viewport_translate[1] = half_height + static_cast<float>(v.y);
    if (ctx.surface.format.rows == raster::RowOrder::kTopFirst) {
        out.viewport_scale[1] = -out.viewport_scale[1];
        out.viewport_translate[1] = static_cast<float>(ctx.surface.height) - out.viewport_translate[1];
    }
    const DepthMapping depth = depth_mapping(v, transform.clip_depth_mode);
    out.viewport_scale[2] = depth.scale;
    out.viewport_translate[2] = depth.translate;
    out.zero_to_one = transform.clip_depth_mode == GL_ZERO_TO_ONE;
}

void make_transform(Context& ctx, pipeline::VertexState& out) {
    StackMatrix& modelview = ctx.matrix.modelview.top();
    StackMatrix& projection = ctx.matrix.projection.top();
    settle(modelview);
    settle(projection);
    const Matrix4 mvp = model_view_projection(projection, modelview);
    std::copy_n(mvp.m, 16, out.mvp);
    std::copy_n(modelview.value.m, 16, out.modelview);
    out.affine = mvp.m[3] == 0 && mvp.m[7] == 0 && mvp.m[11] == 0 && mvp.m[15] == 1;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            out.normal_matrix[row + 3 * column] = modelview.inverse.at(column, row);

    const TransformState& transform = ctx.matrix.transform;
    out.clips_depth = !transform.depth_clamp;
    out.clip_plane_mask = 0;
    for (int p = 0; p < kMaxClipPlanes; ++p) {
        const ClipPlane& plane = transform.clip_planes[static_cast<std::size_t>(p)];
        if (!plane.enabled) continue;
        out.clip_plane_mask |= 1u << p;
        transform_row(out.clip_planes[p], plane.eye_plane.data(), projection.inverse);
    }
    make_viewport(ctx, out);
}

float point_size_within(const PointState& point, float size) {
    return std::min(std::min(std::max(size, point.min_size), point.max_size), kMaxPointSize);
}

void make_point_sizes(const PointState& point, pipeline::VertexState& out) {
    out.point_attenuated = point.attenuated();
    out.point_size = point.size;
    out.point_size_min = std::min(point.min_size, kMaxPointSize);
    out.point_size_max = std::min(point.max_size, kMaxPointSize);
    std::copy_n(point.attenuation.data(), 3, out.point_attenuation);
}

void make_raster(const Context& ctx, pipeline::RasterState& out) {
    scissor_box(ctx, out);
    const PolygonState& polygon = ctx.rasterization.polygon;
    out.flat = ctx.lighting.shade_model == GL_FLAT;
    out.cull_front = polygon.cull_enabled && polygon.cull_face != GL_BACK;
    out.cull_back = polygon.cull_enabled && polygon.cull_face != GL_FRONT;
    out.front_is_clockwise =
        (polygon.front_face == GL_CW) != (ctx.matrix.transform.clip_origin == GL_UPPER_LEFT);
    out.fill[0] = translate_fill_mode(polygon.front_mode);
    out.fill[1] = translate_fill_mode(polygon.back_mode);
    // Sides that are culled do not make a draw one of lines or points.
    if (out.cull_front) out.fill[0] = out.fill[1];
    if (out.cull_back) out.fill[1] = out.fill[0];
    out.polygon_stipple = polygon.stipple_enabled;
    out.offset_fill = polygon.offset_fill;
    out.offset_line = polygon.offset_line;
    out.offset_point = polygon.offset_point;
    out.offset_factor = polygon.offset_factor;
    // Twice the smallest step of the depth format, as the reference has it (GL 1.5 §3.5.5 leaves r to us).
    const double range = ctx.surface.format.depth_bits == 16 ? 65535.0 : 16777215.0;
    out.offset_units = static_cast<float>(polygon.offset_units * (1.0 / range) * 2);
    const LineState& line = ctx.rasterization.line;
    out.line_width = std::clamp(line.width, kMinLineWidth, kMaxLineWidth);
    // Multisampling smooths all alike (GL 1.5 §3.3.3, §3.4.4).
    out.multisample = multisamples(ctx);
    out.line_smooth = line.smooth && !out.multisample;
    out.line_stipple = line.stipple_enabled && line.stipple_pattern != 0xffff;
    out.line_stipple_factor = line.stipple_factor;
    out.line_stipple_pattern = line.stipple_pattern;
    const PointState& point = ctx.rasterization.point;
    out.point_size = point_size_within(point, point.size);
    out.point_smooth = point.smooth && !point.sprite && !out.multisample;
    out.point_sprite = point.sprite;
    out.sprite_units = point.sprite ? point.coord_replace : 0;
}

// The texture a unit samples, null where texturing is off or the textures incomplete: as in the reference,
// the next enabled target takes the place of one whose texture is.
const TextureObject* sampled_texture(const TextureUnit& unit, TextureCompleteness& levels) {
    for (std::size_t target = kTextureTargetCount; target-- > 0;) {
        if (!unit.enabled[target]) continue;
        const TextureObject* const object = unit.bound[target].get();
        if (object == nullptr) continue;
        levels = completeness(*object);
        if (levels.complete) return object;
    }
    return nullptr;
}

void set_filters(const TextureParameters& p, raster::Sampler& out) {
    using raster::Filter, raster::MipFilter;
    const bool linear = p.min_filter == GL_LINEAR || p.min_filter == GL_LINEAR_MIPMAP_NEAREST ||
                        p.min_filter == GL_LINEAR_MIPMAP_LINEAR;
    out.min_filter = linear ? Filter::kLinear : Filter::kNearest;
    out.mag_filter = p.mag_filter == GL_LINEAR ? Filter::kLinear : Filter::kNearest;
    out.mip_filter = p.min_filter == GL_NEAREST || p.min_filter == GL_LINEAR ? MipFilter::kNone
                     : p.min_filter == GL_NEAREST_MIPMAP_NEAREST || p.min_filter == GL_LINEAR_MIPMAP_NEAREST
                         ? MipFilter::kNearest
                         : MipFilter::kLinear;
}

// `sampled`: one bit for each unit that samples a texture. The texel of another is zero, as in the reference.
raster::CombineSource combine_source(GLenum source, unsigned own_unit, unsigned sampled) {
    using raster::CombineSource;
    switch (source) {
        case GL_PRIMARY_COLOR:
            return CombineSource::kPrimary;
        case GL_PREVIOUS:
            return CombineSource::kPrevious;
        case GL_CONSTANT:
            return CombineSource::kConstant;
        case GL_ZERO:
            return CombineSource::kZero;
        case GL_ONE:
            return CombineSource::kOne;
    }
    const unsigned unit = source == GL_TEXTURE ? own_unit : source - GL_TEXTURE0;
    return sampled >> unit & 1 ? static_cast<CombineSource>(unit) : CombineSource::kZero;
}

raster::CombineHalf make_combine_half(const CombineHalf& half, unsigned unit, unsigned sampled) {
    raster::CombineHalf out;
    out.function = translate_combine_function(half.function);
    for (std::size_t i = 0; i < 3; ++i) {
        const GLenum operand = half.operands[i];
        out.arguments[i] = {combine_source(half.sources[i], unit, sampled),
                            operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA,
                            operand == GL_ONE_MINUS_SRC_COLOR || operand == GL_ONE_MINUS_SRC_ALPHA};
    }
    out.scale = half.scale;
    return out;
}

void make_combiner(const TextureEnv& env, unsigned sampled, raster::TextureStage& out) {
    out.rgb = make_combine_half(env.rgb, out.unit, sampled);
    out.alpha = make_combine_half(env.alpha, out.unit, sampled);
    // EXT_texture_env_dot3 does not scale what it makes.
    if (env.rgb.function == GL_DOT3_RGB_EXT) out.rgb.scale = 1;
    if (env.rgb.function == GL_DOT3_RGBA_EXT) out.rgb.scale = out.alpha.scale = 1;
}

// GL 1.5 §3.8.8 bounds the sum; the reference each, in steps of its own. NaN is as good as 0.
float quantized_bias(GLfloat bias) {
    if (!(bias == bias)) return 0;
    return std::round(std::clamp(bias, -kMaxTextureLodBias, kMaxTextureLodBias) * 256) / 256;
}

raster::MipLevel mip_level(const raster::TextureImage& image) {
    raster::MipLevel level{nullptr, image.width, image.height, image.pitch, image.depth, image.slice()};
    if (image.tiles()) {
        level.texels = image.tiles()->bin(0);
        level.bins_across = (image.width + raster::kBinSize - 1) / raster::kBinSize;
    } else {
        level.texels = image.first_texel();
    }
    return level;
}

raster::Sampler make_sampler(const TextureUnit& unit_state, const TextureObject& object, int face,
                             const TextureCompleteness& levels,
                             std::vector<std::shared_ptr<const void>>& images) {
    raster::Sampler sampler;
    const TextureParameters& p = object.parameters;
    set_filters(p, sampler);
    sampler.dimensions = object.target == GL_TEXTURE_1D ? 1 : object.target == GL_TEXTURE_3D ? 3 : 2;
    sampler.wrap_s = translate_wrap(p.wrap_s);
    sampler.wrap_t = translate_wrap(p.wrap_t);
    sampler.wrap_r = translate_wrap(p.wrap_r);
    // Clamped coordinates pick border texels only where neighbours are mixed. Faces of cube maps end at their
    // edges, whatever the wrap mode.
    const bool nearest =
        sampler.min_filter == raster::Filter::kNearest && sampler.mag_filter == raster::Filter::kNearest;
    const bool is_face = object.target == GL_TEXTURE_CUBE_MAP;
    for (raster::Wrap* const wrap : {&sampler.wrap_s, &sampler.wrap_t, &sampler.wrap_r})
        if (is_face || (nearest && *wrap == raster::Wrap::kClamp)) *wrap = raster::Wrap::kClampToEdge;
    sampler.in_floats =
        is_face && sampler.mip_filter != raster::MipFilter::kNone && sampler.min_filter != sampler.mag_filter;
    // The reference cuts off the degree's fraction, and crashes on 1D textures.
    sampler.anisotropic = p.max_anisotropy >= 2 && sampler.dimensions > 1;
    sampler.lod_bias = quantized_bias(p.lod_bias) + quantized_bias(unit_state.env.lod_bias);
    sampler.min_lod = p.min_lod;
    sampler.max_lod = p.max_lod;
    sampler.level_count = static_cast<std::uint8_t>(levels.last - levels.base + 1);
    for (int level = levels.base; level <= levels.last; ++level) {
        const auto& image = object.face(face)[static_cast<std::size_t>(level)].image;
        sampler.levels[static_cast<std::size_t>(level - levels.base)] = mip_level(*image);
        images.push_back(image.shared());
    }
    const TextureLevel& base = object.face(face)[static_cast<std::size_t>(levels.base)];
    sampler.storage = base.image->storage;
    std::ranges::copy(as_texel(base.image->base_format, p.border_color), sampler.border_color);
    if (sampler.storage == raster::TexelStorage::kDepth) {
        sampler.depth_mode = translate_depth_mode(p.depth_mode);
        sampler.depth_bits = base.format->bits[0];
        // Directions use r up: depths of cube maps are not compared.
        sampler.compares = !is_face && p.compare_mode == GL_COMPARE_R_TO_TEXTURE;
        sampler.compare_func = translate_compare(p.compare_func);
    }
    return sampler;
}

raster::TextureStage make_stage(int unit_number, const TextureUnit& unit_state, const TextureObject& object,
                                const TextureCompleteness& levels, pipeline::FragmentBlock& block) {
    raster::TextureStage stage;
    stage.unit = static_cast<std::uint8_t>(unit_number);
    stage.mode = translate_env_mode(unit_state.env.mode);
    std::transform(unit_state.env.color.begin(), unit_state.env.color.end(), stage.env_color, unit);
    stage.sampler = make_sampler(unit_state, object, 0, levels, block.images);
    if (object.target == GL_TEXTURE_CUBE_MAP) {
        auto faces = std::make_unique<pipeline::FragmentBlock::CubeFaces>();
        for (int face = 0; face < kCubeFaces; ++face)
            (*faces)[static_cast<std::size_t>(face)] =
                make_sampler(unit_state, object, face, levels, block.images);
        stage.sampler.faces = faces->data();
        block.cubes.push_back(std::move(faces));
    }
    const raster::TextureImage& base = *object.levels[static_cast<std::size_t>(levels.base)].image;
    stage.base_format =
        base.storage == raster::TexelStorage::kDepth ? stage.sampler.depth_mode : base.base_format;
    return stage;
}

bool is_identity(const Matrix4& m) {
    const Matrix4 i = identity();
    return std::equal(m.m, m.m + 16, i.m);
}

}  // namespace

void make_texture_coordinates(Context& ctx, int number, pipeline::TextureCoordinates& out) {
    const TextureUnit& state = ctx.texture.units[static_cast<std::size_t>(number)];
    const StackMatrix& matrix = ctx.matrix.texture[static_cast<std::size_t>(number)].top();
    out.used = true;
    out.has_matrix = !is_identity(matrix.value);
    std::copy_n(matrix.value.m, 16, out.matrix);
    for (std::size_t c = 0; c < 4; ++c) {
        const TexgenCoordinate& texgen = state.texgen.coordinates[c];
        out.texgen[c] = texgen.enabled ? translate_texgen_mode(texgen.mode) : pipeline::TexgenMode::kOff;
        const auto& plane = texgen.mode == GL_OBJECT_LINEAR ? texgen.object_plane : texgen.eye_plane;
        std::copy_n(plane.data(), 4, out.planes[c]);
    }
}

namespace {

// Whether q may be other than 1 in the coordinates of unit `number`.
bool may_project(const pipeline::TextureCoordinates& coordinates, int number,
                 const pipeline::VertexInput& input) {
    const float* const m = coordinates.matrix;
    const bool projects = m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1;
    return projects || coordinates.texgen[3] != pipeline::TexgenMode::kOff ||
           !has_fourth_one(input, pipeline::kTexture0 + number);
}

// One bit for each unit of those in use whose coordinates may_project.
unsigned projective_units(const pipeline::VertexState& vertex, const pipeline::VertexInput& input) {
    unsigned units = 0;
    for (int u = 0; u < kMaxTextureUnits; ++u) {
        const auto& coordinates = vertex.texture[static_cast<std::size_t>(u)];
        if (coordinates.used && may_project(coordinates, u, input)) units |= 1u << u;
    }
    return units;
}

raster::BlendKind blend_kind(const BlendState& b, bool eight_bits) {
    const bool adds = b.equation_rgb == GL_FUNC_ADD && b.equation_alpha == GL_FUNC_ADD;
    const auto factors = [&](GLenum source, GLenum destination) {
        return b.source_rgb == source && b.source_alpha == source && b.destination_rgb == destination &&
               b.destination_alpha == destination;
    };
    if (adds && factors(GL_ONE, GL_ZERO)) return raster::BlendKind::kNone;
    if (adds && eight_bits && factors(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)) return raster::BlendKind::kAlpha;
    if (adds && eight_bits && factors(GL_ONE, GL_ONE)) return raster::BlendKind::kAdditive;
    return raster::BlendKind::kGeneral;
}

raster::StencilFace make_stencil_face(const StencilFace& face) {
    return {translate_compare(face.func),
            static_cast<std::uint8_t>(std::clamp(face.reference, 0, 255)),
            static_cast<std::uint8_t>(face.value_mask),
            static_cast<std::uint8_t>(face.write_mask),
            translate_stencil_op(face.fail),
            translate_stencil_op(face.depth_fail),
            translate_stencil_op(face.depth_pass)};
}

void make_tests(const Context& ctx, raster::FragmentState& out) {
    const FragmentOpsState& ops = ctx.fragment_ops;
    const raster::TargetFormat& target = ctx.surface.format;
    raster::FragmentKey& key = out.key;
    key.depth_test = ops.depth.test_enabled && target.depth_bits != 0;
    key.depth_write = key.depth_test && ops.depth.write_mask;
    key.depth_func = translate_compare(ops.depth.func);
    out.depth_bits = static_cast<std::uint8_t>(target.depth_bits);
    key.stencil_test = ops.stencil.enabled && target.stencil_bits != 0;
    out.stencil[0] = make_stencil_face(ops.stencil.front);
    out.stencil[1] = make_stencil_face(ops.stencil.back_in_use());
    const AlphaTestState& alpha = ops.color.alpha_test;
    key.alpha_func = alpha.enabled ? translate_compare(alpha.func) : raster::Compare::kAlways;
    out.alpha_reference = alpha.reference;
}

// GL 1.5 §4.1.3. Which samples a coverage value keeps is left to us: the first ones, as in the reference.
void make_multisample(const Context& ctx, raster::FragmentState& out) {
    out.multisample = multisamples(ctx);
    if (!out.multisample) return;
    const MultisampleState& state = ctx.rasterization.multisample;
    raster::FragmentKey& key = out.key;
    key.alpha_to_coverage = state.alpha_to_coverage;
    key.alpha_to_one = state.alpha_to_one;
    if (!state.coverage) return;
    const auto kept = static_cast<unsigned>(state.coverage_value * raster::kMaxSamples);
    const unsigned mask = (1u << kept) - 1;
    key.sample_mask = static_cast<std::uint8_t>((state.coverage_invert ? ~mask : mask) & 0xf);
}

void make_blending(const Context& ctx, raster::FragmentState& out) {
    const ColorBufferState& color = ctx.fragment_ops.color;
    const raster::TargetFormat& target = ctx.surface.format;
    raster::FragmentKey& key = out.key;
    key.color_format = target.color;
    out.has_destination_alpha = target.has_alpha;
    key.color_mask = 0;
    for (std::size_t c = 0; c < 4; ++c) key.color_mask |= static_cast<std::uint8_t>(color.write_mask[c] << c);
    if (!draws_colors(ctx)) key.color_mask = 0;
    const bool integers = target.color != raster::ColorFormat::kRgba32F;
    key.logic_op = color.logic_op.color_enabled && integers && color.logic_op.op != GL_COPY;
    out.logic_op = translate_logic_op(color.logic_op.op);
    const BlendState& b = color.blend;
    // A logic op takes the place of blending (GL 1.5 §4.1.9).
    key.blend = b.enabled && !color.logic_op.color_enabled
                    ? blend_kind(b, target.color == raster::ColorFormat::kRgba8)
                    : raster::BlendKind::kNone;
    out.blend_source_rgb = translate_blend_factor(b.source_rgb);
    out.blend_source_alpha = translate_blend_factor(b.source_alpha);
    out.blend_destination_rgb = translate_blend_factor(b.destination_rgb);
    out.blend_destination_alpha = translate_blend_factor(b.destination_alpha);
    out.blend_equation_rgb = translate_blend_equation(b.equation_rgb);
    out.blend_equation_alpha = translate_blend_equation(b.equation_alpha);
    std::copy_n(b.color.data(), 4, out.blend_color);
}

pipeline::FogDistance fog_distance(const FogState& fog) {
    using pipeline::FogDistance;
    if (fog.coordinate_source == GL_FOG_COORDINATE) return FogDistance::kGiven;
    if (fog.distance_mode == GL_EYE_RADIAL_NV) return FogDistance::kEyeRadial;
    return fog.distance_mode == GL_EYE_PLANE ? FogDistance::kEyePlane : FogDistance::kEyePlaneAbsolute;
}

void make_fog(const Context& ctx, raster::FragmentState& out) {
    const FogState& fog = ctx.fog;
    out.key.fog = !fog.enabled            ? raster::FogMode::kNone
                  : fog.mode == GL_LINEAR ? raster::FogMode::kLinear
                  : fog.mode == GL_EXP    ? raster::FogMode::kExp
                                          : raster::FogMode::kExp2;
    std::transform(fog.color.begin(), fog.color.end(), out.fog_color, unit);
    // The reference's roundings (doc/reference.md §4).
    if (fog.mode == GL_LINEAR) {
        out.fog_scale = fog.end == fog.start ? 1.0f : -1.0f / (fog.end - fog.start);
        out.fog_bias = fog.end * -out.fog_scale;
    } else {
        constexpr double kLog2E = 1.4426950408889634, kSqrtLog2E = 1.201122408786449815;
        out.fog_scale = static_cast<float>(fog.density * (fog.mode == GL_EXP ? kLog2E : kSqrtLog2E));
    }
}

// `used_units`, and those of them that look at r or divide by q: one bit each.
raster::Varyings lay_out_varyings(const raster::FragmentKey& key, bool secondary_varies, unsigned used_units,
                                  unsigned units_with_r, unsigned projective_units) {
    raster::Varyings v;
    int next = 0;
    const auto take = [&](int planes) {
        const int first = next;
        next += planes;
        return static_cast<std::int8_t>(first);
    };
    if (key.interpolated_color) v.color = take(4);
    if (key.separate_specular && secondary_varies) v.secondary = take(3);
    if (key.fog != raster::FogMode::kNone) v.fog = take(1);
    for (std::size_t u = 0; u < kMaxTextureUnits; ++u)
        if (used_units >> u & 1)
            v.texture[u] = take(projective_units >> u & 1 ? 4 : units_with_r >> u & 1 ? 3 : 2);
    v.projective = static_cast<std::uint8_t>(projective_units);
    v.uses_r = static_cast<std::uint8_t>(units_with_r | projective_units);
    v.count = static_cast<std::uint8_t>(next);
    return v;
}

bool adds_secondary_color(const Context& ctx) {
    const bool separate = ctx.lighting.model.color_control == GL_SEPARATE_SPECULAR_COLOR;
    return ctx.fog.color_sum || (ctx.lighting.enabled && separate);
}

bool secondary_varies(const Context& ctx, const pipeline::VertexInput& input) {
    return ctx.lighting.enabled || (input.streamed & bit(pipeline::kSecondaryColor));
}

// What of the key depends on more than the state that make_fragment reads.
void key_of_vertices(const Context& ctx, const pipeline::VertexInput& input, raster::FragmentKey& key) {
    const pipeline::VertexState& vertex = ctx.drawing.state.vertex;
    // The point of a raster position is no stream: it is no reason to change a key.
    const bool w_is_one =
        (input.streamed & bit(pipeline::kPosition)) && has_fourth_one(input, pipeline::kPosition);
    key.perspective = !(vertex.affine && w_is_one);
    key.interpolated_color = ctx.lighting.enabled || (input.streamed & bit(pipeline::kColor));
    // Without perspective a constant plane is as good.
    key.separate_specular = adds_secondary_color(ctx);
    const bool varies = key.interpolated_color || (key.separate_specular && secondary_varies(ctx, input));
    key.flat_color = key.perspective && varies && ctx.lighting.shade_model == GL_FLAT;
}

// Whether the fragment state of the last draw serves this one too: programs that move from object to object
// or from material to material need no other.
bool fragment_still_fits(const Context& ctx, const pipeline::VertexInput& input) {
    constexpr unsigned kApartFromKey =
        static_cast<unsigned>(Dirty::kTransform) | static_cast<unsigned>(Dirty::kLighting);
    const Drawing& drawing = ctx.drawing;
    if (!drawing.state.fragment || (ctx.dirty & ~kApartFromKey)) return false;
    raster::FragmentKey key = drawing.state.fragment->fill.key;
    key_of_vertices(ctx, input, key);
    return key == drawing.state.fragment->fill.key &&
           drawing.constant_color == input.constants[pipeline::kColor] &&
           drawing.constant_secondary == input.constants[pipeline::kSecondaryColor] &&
           secondary_varies(ctx, input) == drawing.secondary_varies &&
           drawing.projective == projective_units(drawing.state.vertex, input);
}

// Gives the block a stage for each unit that samples a texture; returns these units, a bit each.
unsigned add_texture_stages(Context& ctx, pipeline::FragmentBlock& block) {
    unsigned used = 0;
    const std::lock_guard lock(ctx.shared->mutex);
    for (int u = 0; u < kMaxTextureUnits; ++u) {
        const TextureUnit& unit_state = ctx.texture.units[static_cast<std::size_t>(u)];
        TextureCompleteness levels;
        const TextureObject* const object = sampled_texture(unit_state, levels);
        if (object == nullptr) continue;
        block.stages.push_back(make_stage(u, unit_state, *object, levels, block));
        used |= 1u << u;
    }
    for (raster::TextureStage& stage : block.stages) {
        if (stage.mode == raster::EnvMode::kCombine)
            make_combiner(ctx.texture.units[stage.unit].env, used, stage);
    }
    return used;
}

// The units whose textures have a third coordinate, a bit each.
unsigned units_with_r(const std::vector<raster::TextureStage>& stages) {
    unsigned units = 0;
    for (const raster::TextureStage& stage : stages) {
        const raster::Sampler& sampler = stage.sampler;
        if (sampler.dimensions == 3 || sampler.faces || sampler.compares) units |= 1u << stage.unit;
    }
    return units;
}

// For statistics and for the occlusion query that is going on.
void count_samples(const Context& ctx, pipeline::FragmentBlock& block) {
    block.fill.key.counts_samples = ctx.queries.active || pipeline::statistics.enabled;
    if (!ctx.queries.active) return;
    block.fill.samples_passed = &ctx.queries.active->counter->samples;
    block.images.push_back(ctx.queries.active->counter);
}

// What reaches beyond 0..1 is cut off there in any case. The depths of bitmaps and pixel rectangles are the
// raster position's, which was clamped when it was set: the reference's way.
void clamp_depths(const Context& ctx, raster::FragmentState& state) {
    const ViewportState& viewport = ctx.framebuffer.viewport;
    const auto [low, high] = std::minmax(viewport.near_depth, viewport.far_depth);
    state.key.depth_clamp = ctx.matrix.transform.depth_clamp && state.key.depth_test && (low > 0 || high < 1);
    state.depth_range[0] = static_cast<float>(low);
    state.depth_range[1] = static_cast<float>(high);
}

void make_fragment(Context& ctx, const pipeline::VertexInput& input) {
    pipeline::DrawState& draw = ctx.drawing.state;
    auto block = std::make_shared<pipeline::FragmentBlock>();
    raster::FragmentState& state = block->fill;
    make_tests(ctx, state);
    make_multisample(ctx, state);
    make_blending(ctx, state);
    make_fog(ctx, state);
    raster::FragmentKey& key = state.key;
    count_samples(ctx, *block);
    const PolygonState& polygon = ctx.rasterization.polygon;
    // Lines and points of polygons carry theirs in their vertices.
    key.depth_offset =
        key.depth_test && polygon.offset_fill && (polygon.offset_factor != 0 || polygon.offset_units != 0);
    clamp_depths(ctx, state);
    key.polygon_stipple = polygon.stipple_enabled;
    if (key.polygon_stipple) {
        block->polygon_stipple.assign(ctx.rasterization.polygon_stipple.rows.begin(),
                                      ctx.rasterization.polygon_stipple.rows.end());
        state.target_height_for_stipple =
            ctx.surface.format.rows == raster::RowOrder::kTopFirst ? ctx.surface.height : 0;
    }
    key_of_vertices(ctx, input, key);
    const auto& color = input.constants[pipeline::kColor];
    std::transform(color.begin(), color.end(), state.constant_color, unit);

    const unsigned used = add_texture_stages(ctx, *block);
    for (int u = 0; u < kMaxTextureUnits; ++u) {
        pipeline::TextureCoordinates& coordinates = draw.vertex.texture[static_cast<std::size_t>(u)];
        coordinates.used = (used >> u & 1) != 0;
        if (coordinates.used) make_texture_coordinates(ctx, u, coordinates);
    }
    const unsigned projective = ctx.drawing.projective = projective_units(draw.vertex, input);
    key.textured = used != 0;
    const auto& secondary = input.constants[pipeline::kSecondaryColor];
    std::transform(secondary.begin(), secondary.begin() + 3, state.constant_secondary, unit);
    state.varyings =
        lay_out_varyings(key, secondary_varies(ctx, input), used, units_with_r(block->stages), projective);
    block->complete(draw.raster.line_smooth, draw.raster.point_smooth);
    draw.vertex.varyings = state.varyings;
    draw.fragment = std::move(block);
}

// Whether the pixels of an image reach the buffer as they are, if they pass the tests.
bool shows_image(const raster::FragmentState& state) {
    const raster::FragmentKey& key = state.key;
    return key.color_format == raster::ColorFormat::kRgba8 && key.color_mask == 0xf &&
           key.blend == raster::BlendKind::kNone && !key.logic_op && !key.separate_specular &&
           key.fog == raster::FogMode::kNone && key.alpha_func == raster::Compare::kAlways &&
           !key.alpha_to_coverage && !key.alpha_to_one && !key.textured;
}

// GL 3.0 §4.3.1: of what happens to fragments, pixels of depth and stencil undergo only the scissor test.
std::shared_ptr<const pipeline::FragmentBlock> make_depth_image_fragment(const Context& ctx) {
    auto block = std::make_shared<pipeline::FragmentBlock>();
    make_tests(ctx, block->fill);
    make_blending(ctx, block->fill);
    raster::FragmentKey& key = block->fill.key;
    key.image = raster::PixelImage::kDepth;
    key.perspective = key.interpolated_color = key.stencil_test = key.logic_op = false;
    key.blend = raster::BlendKind::kNone;
    key.alpha_func = raster::Compare::kAlways;
    key.color_mask = 0;
    key.depth_test = true;
    key.depth_func = raster::Compare::kAlways;
    key.depth_write = ctx.fragment_ops.depth.write_mask;
    block->complete(false, false);
    return block;
}

}  // namespace

std::shared_ptr<const pipeline::FragmentBlock> make_raster_fragment(Context& ctx, raster::PixelImage image,
                                                                    bool past_tests) {
    if (past_tests && image == raster::PixelImage::kDepth) return make_depth_image_fragment(ctx);
    auto block = std::make_shared<pipeline::FragmentBlock>();
    raster::FragmentState& state = block->fill;
    make_tests(ctx, state);
    make_multisample(ctx, state);
    make_blending(ctx, state);
    make_fog(ctx, state);
    count_samples(ctx, *block);
    raster::FragmentKey& key = state.key;
    key.perspective = key.interpolated_color = false;
    key.separate_specular = adds_secondary_color(ctx);
    std::copy_n(ctx.raster_position.color.data(), 4, state.constant_color);
    const unsigned used = add_texture_stages(ctx, *block);
    unsigned projective = 0;
    for (std::size_t u = 0; u < kMaxTextureUnits; ++u)
        if ((used >> u & 1) && ctx.raster_position.texture_coordinates[u][3] != 1) projective |= 1u << u;
    key.textured = used != 0;
    key.image =
        image == raster::PixelImage::kRgba8 && shows_image(state) ? raster::PixelImage::kVerbatim : image;
    if (image == raster::PixelImage::kStencil) key.stencil_test = true;
    state.varyings = lay_out_varyings(key, true, used, units_with_r(block->stages), projective);
    block->complete(false, false);
    return block;
}

void scissor_box(const Context& ctx, pipeline::RasterState& out) {
    const Surface& target = ctx.surface;
    const ScissorState& scissor = ctx.fragment_ops.scissor;
    // 64-bit sums: a scissor box may reach far outside.
    std::int64_t x0 = 0, y0 = 0, x1 = target.width, y1 = target.height;
    if (scissor.enabled) {
        x0 = std::max<std::int64_t>(x0, scissor.x);
        y0 = std::max<std::int64_t>(y0, scissor.y);
        x1 = std::min(x1, std::int64_t{scissor.x} + scissor.width);
        y1 = std::min(y1, std::int64_t{scissor.y} + scissor.height);
        x1 = std::max(x0, x1);
        y1 = std::max(y0, y1);
    }
    out.row0_is_top = target.format.rows == raster::RowOrder::kTopFirst;
    out.x0 = static_cast<int>(std::min<std::int64_t>(x0, target.width));
    out.x1 = static_cast<int>(std::min<std::int64_t>(x1, target.width));
    const raster::RowRange rows = target.rows(y0, y1);
    out.y0 = static_cast<int>(std::clamp<std::int64_t>(rows.first, 0, target.height));
    out.y1 = static_cast<int>(std::clamp<std::int64_t>(rows.end, 0, target.height));
}

void validate(Context& ctx, const pipeline::VertexInput& input) {
    Drawing& drawing = ctx.drawing;
    pipeline::VertexState& vertex = drawing.state.vertex;
    if (is_dirty(ctx, Dirty::kTransform) || is_dirty(ctx, Dirty::kFramebuffer)) make_transform(ctx, vertex);
    constexpr unsigned kRasterInputs =
        static_cast<unsigned>(Dirty::kRasterization) | static_cast<unsigned>(Dirty::kFragment) |
        static_cast<unsigned>(Dirty::kLighting) | static_cast<unsigned>(Dirty::kFramebuffer);
    if (ctx.dirty & kRasterInputs) make_raster(ctx, drawing.state.raster);
    vertex.snap_origin = drawing.state.raster.multisample ? 0.0f : 0.5f;
    if (is_dirty(ctx, Dirty::kRasterization)) make_point_sizes(ctx.rasterization.point, vertex);

    const bool all_filled = drawing.state.raster.fill[0] == pipeline::FillMode::kFill &&
                            drawing.state.raster.fill[1] == pipeline::FillMode::kFill;
    vertex.edge_flags = !all_filled;
    vertex.fog_distance = fog_distance(ctx.fog);
    if (is_dirty(ctx, Dirty::kTransform)) {
        for (int u = 0; u < kMaxTextureUnits; ++u) {
            auto& coordinates = vertex.texture[static_cast<std::size_t>(u)];
            if (coordinates.used) make_texture_coordinates(ctx, u, coordinates);
        }
    }
    const bool new_fragment = !fragment_still_fits(ctx, input);
    if (new_fragment) {
        make_fragment(ctx, input);
        drawing.constant_color = input.constants[pipeline::kColor];
        drawing.constant_secondary = input.constants[pipeline::kSecondaryColor];
        drawing.secondary_varies = secondary_varies(ctx, input);
    }
    if (new_fragment || ctx.dirty != 0 || drawing.streamed != input.streamed) {
        drawing.streamed = input.streamed;
        make_lighting(ctx, input, vertex);
        if (++drawing.lighting_made == 0) drawing.lighting_made = 1;
    }
    ctx.dirty = 0;
}

}  // namespace terrazzo::gl
