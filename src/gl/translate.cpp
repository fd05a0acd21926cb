// GL enumerants in the pipeline's terms; see translate.h.
#include "gl/translate.h"

namespace terrazzo::gl {

using raster::BlendFactor;

raster::StencilOp translate_stencil_op(GLenum op) {
    switch (op) {
        case GL_ZERO:
            return raster::StencilOp::kZero;
        case GL_REPLACE:
            return raster::StencilOp::kReplace;
        case GL_INCR:
            return raster::StencilOp::kIncrement;
        case GL_DECR:
            return raster::StencilOp::kDecrement;
        case GL_INVERT:
            return raster::StencilOp::kInvert;
        case GL_INCR_WRAP:
            return raster::StencilOp::kIncrementWrap;
        case GL_DECR_WRAP:
            return raster::StencilOp::kDecrementWrap;
    }
    return raster::StencilOp::kKeep;
}

BlendFactor translate_blend_factor(GLenum factor) {
    switch (factor) {
        case GL_ONE:
            return BlendFactor::kOne;
        case GL_SRC_COLOR:
            return BlendFactor::kSourceColor;
        case GL_ONE_MINUS_SRC_COLOR:
            return BlendFactor::kOneMinusSourceColor;
        case GL_DST_COLOR:
            return BlendFactor::kDestinationColor;
        case GL_ONE_MINUS_DST_COLOR:
            return BlendFactor::kOneMinusDestinationColor;
        case GL_SRC_ALPHA:
            return BlendFactor::kSourceAlpha;
        case GL_ONE_MINUS_SRC_ALPHA:
            return BlendFactor::kOneMinusSourceAlpha;
        case GL_DST_ALPHA:
            return BlendFactor::kDestinationAlpha;
        case GL_ONE_MINUS_DST_ALPHA:
            return BlendFactor::kOneMinusDestinationAlpha;
        case GL_CONSTANT_COLOR:
            return BlendFactor::kConstantColor;
        case GL_ONE_MINUS_CONSTANT_COLOR:
            return BlendFactor::kOneMinusConstantColor;
        case GL_CONSTANT_ALPHA:
            return BlendFactor::kConstantAlpha;
        case GL_ONE_MINUS_CONSTANT_ALPHA:
            return BlendFactor::kOneMinusConstantAlpha;
        case GL_SRC_ALPHA_SATURATE:
            return BlendFactor::kSourceAlphaSaturate;
    }
    return BlendFactor::kZero;
}

raster::BlendEquation translate_blend_equation(GLenum equation) {
    switch (equation) {
        case GL_FUNC_SUBTRACT:
            return raster::BlendEquation::kSubtract;
        case GL_FUNC_REVERSE_SUBTRACT:
            return raster::BlendEquation::kReverseSubtract;
        case GL_MIN:
            return raster::BlendEquation::kMin;
        case GL_MAX:
            return raster::BlendEquation::kMax;
    }
    return raster::BlendEquation::kAdd;
}

raster::LogicOp translate_logic_op(GLenum op) {
    // Truth tables for GL_CLEAR to GL_SET: bit 2s + d is the result for source bit s and destination bit d.
    static constexpr raster::LogicOp kTables[16] = {0b0000, 0b1000, 0b0100, 0b1100, 0b0010, 0b1010,
                                                    0b0110, 0b1110, 0b0001, 0b1001, 0b0101, 0b1101,
                                                    0b0011, 0b1011, 0b0111, 0b1111};
    return kTables[(op - GL_CLEAR) & 15];
}

raster::EnvMode translate_env_mode(GLenum mode) {
    switch (mode) {
        case GL_REPLACE:
            return raster::EnvMode::kReplace;
        case GL_DECAL:
            return raster::EnvMode::kDecal;
        case GL_BLEND:
            return raster::EnvMode::kBlend;
        case GL_ADD:
            return raster::EnvMode::kAdd;
        case GL_COMBINE:
            return raster::EnvMode::kCombine;
    }
    return raster::EnvMode::kModulate;
}

raster::CombineFunction translate_combine_function(GLenum function) {
    using raster::CombineFunction;
    switch (function) {
        case GL_REPLACE:
            return CombineFunction::kReplace;
        case GL_ADD:
            return CombineFunction::kAdd;
        case GL_ADD_SIGNED:
            return CombineFunction::kAddSigned;
        case GL_INTERPOLATE:
            return CombineFunction::kInterpolate;
        case GL_SUBTRACT:
            return CombineFunction::kSubtract;
        case GL_DOT3_RGB:
        case GL_DOT3_RGB_EXT:
            return CombineFunction::kDot3Rgb;
        case GL_DOT3_RGBA:
        case GL_DOT3_RGBA_EXT:
            return CombineFunction::kDot3Rgba;
        case GL_MODULATE_ADD_ATI:
            return CombineFunction::kModulateAdd;
        case GL_MODULATE_SIGNED_ADD_ATI:
            return CombineFunction::kModulateSignedAdd;
        case GL_MODULATE_SUBTRACT_ATI:
            return CombineFunction::kModulateSubtract;
    }
    return CombineFunction::kModulate;
}

raster::Wrap translate_wrap(GLenum wrap) {
    switch (wrap) {
        case GL_CLAMP:
            return raster::Wrap::kClamp;
        case GL_CLAMP_TO_EDGE:
            return raster::Wrap::kClampToEdge;
        case GL_CLAMP_TO_BORDER:
            return raster::Wrap::kClampToBorder;
        case GL_MIRRORED_REPEAT:
            return raster::Wrap::kMirroredRepeat;
    }
    return raster::Wrap::kRepeat;
}

raster::BaseFormat translate_depth_mode(GLenum mode) {
    switch (mode) {
        case GL_INTENSITY:
            return raster::BaseFormat::kIntensity;
        case GL_ALPHA:
            return raster::BaseFormat::kAlpha;
    }
    return raster::BaseFormat::kLuminance;
}

pipeline::TexgenMode translate_texgen_mode(GLenum mode) {
    switch (mode) {
        case GL_OBJECT_LINEAR:
            return pipeline::TexgenMode::kObjectLinear;
        case GL_SPHERE_MAP:
            return pipeline::TexgenMode::kSphereMap;
        case GL_REFLECTION_MAP:
            return pipeline::TexgenMode::kReflectionMap;
        case GL_NORMAL_MAP:
            return pipeline::TexgenMode::kNormalMap;
    }
    return pipeline::TexgenMode::kEyeLinear;
}

pipeline::FillMode translate_fill_mode(GLenum mode) {
    switch (mode) {
        case GL_POINT:
            return pipeline::FillMode::kPoint;
        case GL_LINE:
            return pipeline::FillMode::kLine;
    }
    return pipeline::FillMode::kFill;
}

pipeline::ComponentType translate_type(GLenum type) {
    switch (type) {
        case GL_BYTE:
            return pipeline::ComponentType::kInt8;
        case GL_UNSIGNED_BYTE:
            return pipeline::ComponentType::kUint8;
        case GL_SHORT:
            return pipeline::ComponentType::kInt16;
        case GL_UNSIGNED_SHORT:
            return pipeline::ComponentType::kUint16;
        case GL_INT:
            return pipeline::ComponentType::kInt32;
        case GL_UNSIGNED_INT:
            return pipeline::ComponentType::kUint32;
        case GL_DOUBLE:
            return pipeline::ComponentType::kFloat64;
    }
    return pipeline::ComponentType::kFloat32;
}

}  // namespace terrazzo::gl
