// GetString (GL 1.5 §6.1.11). The version is that of the dispatch table: it never promises more than is
// there.
#include "gl/strings.h"

#include <string>

#include "gl/context.h"
#include "gl/generated/commands.h"
#include "gl/generated/dispatch.h"
#include "pipeline/schedule/workers.h"
#include "raster/kernel_table.h"

namespace terrazzo::gl {

const char* vendor_string() {
    return "Terrazzo";
}

// Users measure and report with this string: it says what ran.
const char* renderer_string() {
    static const std::string text = [] {
        const int threads = pipeline::thread_count();
        return std::string("Terrazzo (") + simd::isa_name(raster::kernels().isa) + ", " +
               std::to_string(threads) + (threads == 1 ? " thread)" : " threads)");
    }();
    return text.c_str();
}

namespace {

const char* version() {
    static const std::string text = std::string(kGlVersion) + " Terrazzo " TERRAZZO_VERSION;
    return text.c_str();
}

const char* find_string(GLenum name) {
    switch (name) {
        case GL_VENDOR:
            return vendor_string();
        case GL_RENDERER:
            return renderer_string();
        case GL_VERSION:
            return version();
        case GL_EXTENSIONS:
            return kGlExtensions;
    }
    return nullptr;
}

}  // namespace

const GLubyte* get_string(Context& ctx, GLenum name) {
    const char* text = find_string(name);
    if (!text) record_error(ctx, GL_INVALID_ENUM, "no such string");
    return reinterpret_cast<const GLubyte*>(text);
}

}  // namespace terrazzo::gl
