// Hints (GL 1.5 §5.6).
#include "gl/hints.h"

#include "gl/context.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {
namespace {

GLenum* find_hint(HintState& hints, GLenum target) {
    switch (target) {
        case GL_PERSPECTIVE_CORRECTION_HINT:
            return &hints.perspective_correction;
        case GL_POINT_SMOOTH_HINT:
            return &hints.point_smooth;
        case GL_LINE_SMOOTH_HINT:
            return &hints.line_smooth;
        case GL_POLYGON_SMOOTH_HINT:
            return &hints.polygon_smooth;
        case GL_FOG_HINT:
            return &hints.fog;
        case GL_GENERATE_MIPMAP_HINT:
            return &hints.generate_mipmap;
        case GL_TEXTURE_COMPRESSION_HINT:
            return &hints.texture_compression;
    }
    return nullptr;
}

}  // namespace

void hint(Context& ctx, GLenum target, GLenum mode) {
    GLenum* found = find_hint(ctx.hints, target);
    if (!found) return record_error(ctx, GL_INVALID_ENUM, "no such hint");
    if (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE) {
        return record_error(ctx, GL_INVALID_ENUM, "mode is not GL_FASTEST, GL_NICEST or GL_DONT_CARE");
    }
    *found = mode;
}

}  // namespace terrazzo::gl
