// GL enumerants in the pipeline's terms. Commands have checked their arguments, so every value here is a
// legal one.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include "pipeline/geometry/renderer.h"
#include "pipeline/geometry/vertex_input.h"
#include "raster/fragment_state.h"

namespace terrazzo::gl {

inline raster::Compare translate_compare(GLenum func) {
    return static_cast<raster::Compare>(func - GL_NEVER);
}
static_assert(GL_ALWAYS - GL_NEVER == static_cast<int>(raster::Compare::kAlways));

inline pipeline::PrimitiveMode translate_mode(GLenum mode) {
    return static_cast<pipeline::PrimitiveMode>(mode);
}
static_assert(GL_POLYGON == static_cast<int>(pipeline::PrimitiveMode::kPolygon));

raster::StencilOp translate_stencil_op(GLenum op);
raster::BlendFactor translate_blend_factor(GLenum factor);
raster::BlendEquation translate_blend_equation(GLenum equation);
raster::LogicOp translate_logic_op(GLenum op);
raster::EnvMode translate_env_mode(GLenum mode);
raster::CombineFunction translate_combine_function(GLenum function);
raster::Wrap translate_wrap(GLenum wrap);
raster::BaseFormat translate_depth_mode(GLenum mode);
pipeline::TexgenMode translate_texgen_mode(GLenum mode);
pipeline::FillMode translate_fill_mode(GLenum mode);
pipeline::ComponentType translate_type(GLenum type);

}  // namespace terrazzo::gl
