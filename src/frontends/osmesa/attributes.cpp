// The attribute list of OSMesaCreateContextAttribs; see attributes.h.
#include "frontends/osmesa/attributes.h"

#include <GL/osmesa.h>

#include <utility>

#include "frontends/osmesa/formats.h"
#include "gl/debug_log.h"
#include "gl/generated/dispatch.h"

namespace terrazzo::osmesa {
namespace {

struct Request {
    int format = OSMESA_RGBA;
    int depth_bits = 0;
    int stencil_bits = 0;
    int accum_bits = 0;
    int profile = OSMESA_COMPAT_PROFILE;
    int major = 1;
    int minor = 0;
};

bool set_at_least(int& field, int value, int lowest) {
    field = value;
    return value >= lowest;
}

bool apply(Request& request, int attribute, int value) {
    switch (attribute) {
        case OSMESA_FORMAT:
            return request.format = value, is_format(value);
        case OSMESA_DEPTH_BITS:
            return set_at_least(request.depth_bits, value, 0);
        case OSMESA_STENCIL_BITS:
            return set_at_least(request.stencil_bits, value, 0);
        case OSMESA_ACCUM_BITS:
            return set_at_least(request.accum_bits, value, 0);
        case OSMESA_PROFILE:
            request.profile = value;
            return value == OSMESA_CORE_PROFILE || value == OSMESA_COMPAT_PROFILE;
        case OSMESA_CONTEXT_MAJOR_VERSION:
            return set_at_least(request.major, value, 1);
        case OSMESA_CONTEXT_MINOR_VERSION:
            return set_at_least(request.minor, value, 0);
        default:
            return false;
    }
}

// Mesa's choice: depth joins stencil in 24 + 8 bits; fewer than 16 bits alone are no depth buffer at all.
gl::Config config_for(const Request& request) {
    gl::Config config;
    const bool stencil = request.stencil_bits > 0;
    const int depth = request.depth_bits;
    if (stencil) {
        config.depth_bits = depth > 0 ? 24 : 0;
    } else {
        config.depth_bits = depth >= 24 ? 24 : depth >= 16 ? 16 : 0;
    }
    config.stencil_bits = stencil ? 8 : 0;
    config.accum_bits = request.accum_bits > 0 ? 16 : 0;
    return config;
}

}  // namespace

std::optional<ContextAttributes> parse_attributes(const int* list) {
    constexpr const char* command = "OSMesaCreateContextAttribs";
    Request request;
    for (; list && list[0] != 0; list += 2) {
        if (!apply(request, list[0], list[1])) {
            gl::debug_log(command, "unknown attribute or value out of range");
            return std::nullopt;
        }
    }
    const auto wanted = std::pair(request.major, request.minor);
    if (request.profile == OSMESA_CORE_PROFILE ||
        wanted > std::pair(gl::kGlMajorVersion, gl::kGlMinorVersion)) {
        gl::debug_log(command, "this profile or version is not offered");
        return std::nullopt;
    }
    return ContextAttributes{request.format, config_for(request)};
}

}  // namespace terrazzo::osmesa
