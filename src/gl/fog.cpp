// Fog parameters (GL 1.5 §3.10, NV_fog_distance).
#include "gl/fog.h"

#include "gl/change.h"
#include "gl/generated/commands.h"

namespace terrazzo::gl {

void fogfv(Context& ctx, GLenum pname, const GLfloat* params) {
    FogState& fog = ctx.fog;
    switch (pname) {
        case GL_FOG_MODE:
            if (*params != GL_LINEAR && *params != GL_EXP && *params != GL_EXP2) {
                return record_error(ctx, GL_INVALID_ENUM, "no such fog mode");
            }
            return change(ctx, Dirty::kFragment, fog.mode, *params);
        case GL_FOG_DENSITY:
            if (!(*params >= 0)) return record_error(ctx, GL_INVALID_VALUE, "the density is negative");
            return change(ctx, Dirty::kFragment, fog.density, *params);
        case GL_FOG_START:
            return change(ctx, Dirty::kFragment, fog.start, *params);
        case GL_FOG_END:
            return change(ctx, Dirty::kFragment, fog.end, *params);
        case GL_FOG_INDEX:
            return change(ctx, Dirty::kFragment, fog.index, *params);
        case GL_FOG_COORDINATE_SOURCE:
            if (*params != GL_FRAGMENT_DEPTH && *params != GL_FOG_COORDINATE) {
                return record_error(ctx, GL_INVALID_ENUM, "no such source of fog coordinates");
            }
            return change(ctx, Dirty::kFragment, fog.coordinate_source, *params);
        case GL_FOG_DISTANCE_MODE_NV:
            if (*params != GL_EYE_RADIAL_NV && *params != GL_EYE_PLANE &&
                *params != GL_EYE_PLANE_ABSOLUTE_NV) {
                return record_error(ctx, GL_INVALID_ENUM, "no such distance of fog");
            }
            return change(ctx, Dirty::kFragment, fog.distance_mode, *params);
        case GL_FOG_COLOR:
            return change(ctx, Dirty::kFragment, fog.color,
                          std::array{params[0], params[1], params[2], params[3]});
    }
    record_error(ctx, GL_INVALID_ENUM, "no such fog parameter");
}

}  // namespace terrazzo::gl
