// The GL context: one plain struct per chapter of the specification, each defined in that chapter's header.
//
// Commands are free functions `gl::foo_bar(Context&, ...)`, one file per chapter, called by generated thunks
// (tools/generate.py). A command checks its arguments, records an error with `record_error` and returns
// without side effect when one is wrong; otherwise it announces the change with `begin_change` and stores the
// value in GL's own terms (GLenum, GLfloat). Only validate.cpp translates these into the enum classes of
// src/pipeline.
//
// Threads: a context is current in at most one thread. Objects that contexts share live in ShareGroup.
#pragma once

#include <memory>

#include "gl/arrays.h"
#include "gl/attrib.h"
#include "gl/config.h"
#include "gl/current.h"
#include "gl/draw.h"
#include "gl/error.h"
#include "gl/evaluators.h"
#include "gl/fog.h"
#include "gl/fragment_ops.h"
#include "gl/framebuffer.h"
#include "gl/framebuffer_object.h"
#include "gl/hints.h"
#include "gl/lighting.h"
#include "gl/lists.h"
#include "gl/matrix.h"
#include "gl/pixels.h"
#include "gl/queries.h"
#include "gl/raster_position.h"
#include "gl/rasterization.h"
#include "gl/render_mode.h"
#include "gl/surface.h"
#include "gl/texture.h"
#include "gl/vertex.h"
#include "pipeline/geometry/renderer.h"

namespace terrazzo::gl {

// What of the derived state must be made anew before the next draw.
enum class Dirty : unsigned {
    kNothing = 0,              // what vertices are made of before they are queued
    kTransform = 1u << 0,      // matrices, viewport, depth range, user clip planes
    kLighting = 1u << 1,       // lights, materials, shade model, normalisation
    kTexture = 1u << 2,        // bindings, parameters, images, environment, texgen
    kRasterization = 1u << 3,  // points, lines, polygons, culling, offset, stipples
    kFragment = 1u << 4,       // fog, tests, blending, masks, scissor
    kFramebuffer = 1u << 5,    // the render target itself
    kAll = ~0u,
};

// Objects that contexts created with a share partner have in common. Every access to the maps holds `mutex`.
struct ShareGroup;

struct Context {
    Config config;  // what the front end asked for; constant
    std::shared_ptr<ShareGroup> shared;
    Surface surface;
    pipeline::Renderer renderer;

    DispatchState dispatch;
    ErrorState error;
    VertexState vertex;
    RasterPosition raster_position;
    RenderModeState render_mode;
    EvaluatorState evaluators;
    ArrayState arrays;
    MatrixState matrix;
    LightingState lighting;
    RasterizationState rasterization;
    TextureState texture;
    FogState fog;
    FragmentOpsState fragment_ops;
    FramebufferState framebuffer;
    FramebufferBindings framebuffers;
    PixelState pixels;
    QueryState queries;
    HintState hints;
    ListState lists;
    AttribState attrib;
    Drawing drawing;

    unsigned dirty = static_cast<unsigned>(Dirty::kAll);
};

// Called by a command before it changes state that queued vertices were specified under: hands those vertices
// to the pipeline with the old state, then marks what the change makes stale.
void begin_change(Context& ctx, Dirty what);

// A context with the default state of GL 1.5 chapter 6 that shares objects with `share_partner` unless it is
// null.
std::unique_ptr<Context> create_context(const Config& config, Context* share_partner);

}  // namespace terrazzo::gl
