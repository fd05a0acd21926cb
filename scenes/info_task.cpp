// Stage: child side of the info command: what a library says about itself, and which names it answers for.
#include <map>
#include <sstream>
#include <string>

#include "draw_task.h"
#include "kit/offscreen.h"
#include "kit/shared_bytes.h"

namespace terrazzo {
namespace {

struct Limit {
    const char* name;
    GLenum parameter;
    int count;
};

constexpr Limit kLimits[] = {
    {"GL_MAX_TEXTURE_SIZE", GL_MAX_TEXTURE_SIZE, 1},
    {"GL_MAX_3D_TEXTURE_SIZE", GL_MAX_3D_TEXTURE_SIZE, 1},
    {"GL_MAX_CUBE_MAP_TEXTURE_SIZE", GL_MAX_CUBE_MAP_TEXTURE_SIZE, 1},
    {"GL_MAX_TEXTURE_UNITS", GL_MAX_TEXTURE_UNITS, 1},
    {"GL_MAX_VIEWPORT_DIMS", GL_MAX_VIEWPORT_DIMS, 2},
    {"GL_MAX_LIGHTS", GL_MAX_LIGHTS, 1},
    {"GL_MAX_CLIP_PLANES", GL_MAX_CLIP_PLANES, 1},
    {"GL_MAX_MODELVIEW_STACK_DEPTH", GL_MAX_MODELVIEW_STACK_DEPTH, 1},
    {"GL_MAX_PROJECTION_STACK_DEPTH", GL_MAX_PROJECTION_STACK_DEPTH, 1},
    {"GL_MAX_TEXTURE_STACK_DEPTH", GL_MAX_TEXTURE_STACK_DEPTH, 1},
    {"GL_MAX_ATTRIB_STACK_DEPTH", GL_MAX_ATTRIB_STACK_DEPTH, 1},
    {"GL_MAX_CLIENT_ATTRIB_STACK_DEPTH", GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 1},
    {"GL_MAX_NAME_STACK_DEPTH", GL_MAX_NAME_STACK_DEPTH, 1},
    {"GL_MAX_LIST_NESTING", GL_MAX_LIST_NESTING, 1},
    {"GL_MAX_EVAL_ORDER", GL_MAX_EVAL_ORDER, 1},
    {"GL_MAX_PIXEL_MAP_TABLE", GL_MAX_PIXEL_MAP_TABLE, 1},
    {"GL_MAX_ELEMENTS_VERTICES", GL_MAX_ELEMENTS_VERTICES, 1},
    {"GL_MAX_ELEMENTS_INDICES", GL_MAX_ELEMENTS_INDICES, 1},
    {"GL_SUBPIXEL_BITS", GL_SUBPIXEL_BITS, 1},
    {"GL_ALIASED_POINT_SIZE_RANGE", GL_ALIASED_POINT_SIZE_RANGE, 2},
    {"GL_ALIASED_LINE_WIDTH_RANGE", GL_ALIASED_LINE_WIDTH_RANGE, 2},
    {"GL_SMOOTH_POINT_SIZE_RANGE", GL_SMOOTH_POINT_SIZE_RANGE, 2},
    {"GL_SMOOTH_LINE_WIDTH_RANGE", GL_SMOOTH_LINE_WIDTH_RANGE, 2},
    {"GL_RED_BITS", GL_RED_BITS, 1},
    {"GL_ALPHA_BITS", GL_ALPHA_BITS, 1},
    {"GL_DEPTH_BITS", GL_DEPTH_BITS, 1},
    {"GL_STENCIL_BITS", GL_STENCIL_BITS, 1},
    {"GL_ACCUM_RED_BITS", GL_ACCUM_RED_BITS, 1},
};

std::string text(const GLubyte* string) {
    return string ? reinterpret_cast<const char*>(string) : "";
}

nlohmann::json limits(const kit::OffscreenContext& context) {
    nlohmann::json result = nlohmann::json::array();
    for (const Limit& limit : kLimits) {
        GLfloat values[4] = {};
        context.library().gl.GetFloatv(limit.parameter, values);
        if (!context.take_errors().empty()) continue;  // this library has no such limit
        result.push_back(
            {{"name", limit.name}, {"values", std::vector<float>(values, values + limit.count)}});
    }
    return result;
}

// What OSMesaGetProcAddress says to the names it is asked for.
class Answers {
  public:
    explicit Answers(const kit::Library& library) : m_library(library) {}

    void ask(const nlohmann::json& names) {
        for (const auto& name : names) {
            const auto [place, is_new] = m_known.emplace(name.get<std::string>(), false);
            if (is_new) place->second = m_library.osmesa.GetProcAddress(place->first.c_str()) != nullptr;
        }
    }
    nlohmann::json result() const {
        nlohmann::json missing = nlohmann::json::array();
        for (const auto& [name, is_known] : m_known)
            if (!is_known) missing.push_back(name);
        return {{"asked", m_known.size()}, {"missing", missing}};
    }

  private:
    const kit::Library& m_library;
    std::map<std::string, bool> m_known;
};

}  // namespace

nlohmann::json info_task(const nlohmann::json& arguments) {
    const kit::Library library(arguments.at("library").get<std::string>());
    const kit::OffscreenContext context(library, {});
    const kit::Gl& gl = library.gl;
    const nlohmann::json names =
        nlohmann::json::from_cbor(kit::read_bytes(arguments.at("names").get<std::string>()));
    Answers core(library), extensions(library), exported(library);
    core.ask(names.at("core"));
    exported.ask(names.at("exported"));
    std::istringstream named(text(gl.GetString(GL_EXTENSIONS)));
    for (std::string extension; named >> extension;)
        if (names["extensions"].contains(extension)) extensions.ask(names["extensions"][extension]);
    return {{"vendor", text(gl.GetString(GL_VENDOR))},
            {"renderer", text(gl.GetString(GL_RENDERER))},
            {"version", text(gl.GetString(GL_VERSION))},
            {"extensions", text(gl.GetString(GL_EXTENSIONS))},
            {"limits", limits(context)},
            {"core", core.result()},
            {"of_extensions", extensions.result()},
            {"exported", exported.result()},
            {"not_exported", library.missing}};
}

}  // namespace terrazzo
