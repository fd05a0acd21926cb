// Stage: piglit-lite, comparing what two libraries drew. Colour through OpenImageIO, whatever the buffer's
// type; depth and stencil as integers.
#include "compare.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pixels.h"

namespace terrazzo::piglit {
namespace {

double share(std::size_t count, std::size_t all) {
    return all ? static_cast<double>(count) / static_cast<double>(all) : 0;
}

void require_share(Comparison& result, const char* what, std::size_t count, double allowed) {
    if (share(count, result.pixels) > allowed)
        result.problems.push_back(fmt::format("{}: {} pixels ({:.4f} %), allowed {:.4f} %", what, count,
                                              100 * share(count, result.pixels), 100 * allowed));
}

bool same_colours(const Drawing& ours, const Drawing& theirs) {
    return ours.format == theirs.format && ours.colour == theirs.colour;
}

void compare_colour(const Scene& scene, const Drawing& ours, const Drawing& theirs, Comparison& result) {
    if (same_colours(ours, theirs)) return;  // as most are: no need for pictures
    const OIIO::ImageBuf a = colour_picture(scene, ours), b = colour_picture(scene, theirs);
    // Half of a further step of 1/255 keeps rounding in float out of the decision.
    const auto threshold = static_cast<float>((scene.tolerance.colour_steps + 0.5) / 255);
    const auto figures = OIIO::ImageBufAlgo::compare(a, b, threshold, threshold);
    result.differing = figures.nfail;
    result.largest_difference = figures.maxerror * 255;
    result.mean_difference = figures.meanerror * 255;
    result.coverage = coverage_difference(scene, a, b, threshold);
    require_share(result, "colour differs", result.differing, scene.tolerance.differing_share);
    require_share(result, "coverage differs", result.coverage, scene.tolerance.coverage_share);
}

void compare_depth(const Scene& scene, const Drawing& ours, const Drawing& theirs, Comparison& result) {
    if (ours.depth.size() != theirs.depth.size()) {
        result.problems.emplace_back("one library has a depth buffer, the other none");
        return;
    }
    for (std::size_t i = 0; i < ours.depth.size(); ++i) {
        const std::uint32_t a = ours.depth[i], b = theirs.depth[i];
        const std::uint32_t difference = a > b ? a - b : b - a;
        result.largest_depth_difference = std::max(result.largest_depth_difference, difference);
        if (difference > scene.tolerance.depth_steps) ++result.depth_differing;
    }
    require_share(result, "depth differs", result.depth_differing, scene.tolerance.depth_share);
}

void compare_stencil(const Scene& scene, const Drawing& ours, const Drawing& theirs, Comparison& result) {
    if (ours.stencil.size() != theirs.stencil.size()) {
        result.problems.emplace_back("one library has a stencil buffer, the other none");
        return;
    }
    for (std::size_t i = 0; i < ours.stencil.size(); ++i)
        if (ours.stencil[i] != theirs.stencil[i]) ++result.stencil_differing;
    require_share(result, "stencil differs", result.stencil_differing, scene.tolerance.stencil_share);
}

void compare_values(const Drawing& ours, const Drawing& theirs, Comparison& result) {
    constexpr std::size_t kMostProblems = 12;
    if (ours.values.size() != theirs.values.size()) {
        result.problems.push_back(
            fmt::format("{} values noted instead of {}", ours.values.size(), theirs.values.size()));
        return;
    }
    std::size_t problems = 0;
    for (std::size_t i = 0; i < ours.values.size(); ++i) {
        const auto& [name, value, tolerance] = ours.values[i];
        const double expected = theirs.values[i].value;
        const bool equal =
            std::abs(value - expected) <= tolerance || (std::isnan(value) && std::isnan(expected));
        if (equal && name == theirs.values[i].name) continue;
        if (++problems <= kMostProblems)
            result.problems.push_back(fmt::format("{} is {:.9g} instead of {:.9g}", name, value, expected));
    }
    if (problems > kMostProblems)
        result.problems.push_back(fmt::format("... and {} more values", problems - kMostProblems));
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text.empty() ? "none" : text;
}

class Hash {  // FNV-1a, 64 bits
  public:
    void add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const std::uint8_t*>(data);
        for (std::size_t i = 0; i < size; ++i) m_state = (m_state ^ bytes[i]) * 0x100000001b3U;
    }
    std::uint64_t state() const { return m_state; }

  private:
    std::uint64_t m_state = 0xcbf29ce484222325U;
};

}  // namespace

Drawing drawing_of(const kit::ChildReport& report) {
    Drawing drawing;
    if (!report.finished()) {
        drawing.failure = report.message;
        if (!report.output.empty()) drawing.failure += "; it printed: " + report.output.substr(0, 2000);
        return drawing;
    }
    const nlohmann::json& result = report.result;
    drawing.renderer = result["renderer"].get<std::string>();
    drawing.format = result["format"].get<GLenum>();
    drawing.colour = result["colour"].get_binary();
    const std::vector<std::uint8_t>& depth = result["depth"].get_binary();
    drawing.depth.resize(depth.size() / sizeof(std::uint32_t));
    std::ranges::copy(depth, reinterpret_cast<std::uint8_t*>(drawing.depth.data()));
    drawing.stencil = result["stencil"].get_binary();
    drawing.errors = result["errors"].get<std::vector<std::string>>();
    for (const auto& value : result["values"])
        drawing.values.push_back(
            {value[0].get<std::string>(), value[1].get<double>(), value[2].get<double>()});
    return drawing;
}

std::uint64_t hash_of(const Drawing& drawing) {
    Hash hash;
    hash.add(drawing.colour.data(), drawing.colour.size());
    hash.add(drawing.depth.data(), drawing.depth.size() * sizeof(std::uint32_t));
    hash.add(drawing.stencil.data(), drawing.stencil.size());
    for (const std::string& error : drawing.errors) hash.add(error.data(), error.size());
    for (const NotedValue& noted : drawing.values) hash.add(&noted.value, sizeof noted.value);
    return hash.state();
}

Comparison compare(const Scene& scene, const Drawing& ours, const Drawing& theirs) {
    Comparison result;
    if (!ours.drawn()) result.problems.push_back(ours.failure);
    if (!theirs.drawn()) result.problems.push_back("the reference failed: " + theirs.failure);
    if (!result.problems.empty()) return result;
    result.pixels = static_cast<std::size_t>(scene.context.width) * scene.context.height;
    compare_colour(scene, ours, theirs, result);
    compare_depth(scene, ours, theirs, result);
    compare_stencil(scene, ours, theirs, result);
    compare_values(ours, theirs, result);
    if (ours.errors != theirs.errors)
        result.problems.push_back("GL errors: " + joined(ours.errors) + " instead of " +
                                  joined(theirs.errors));
    else if (!ours.errors.empty())
        result.problems.push_back("the scene leaves GL errors: " + joined(ours.errors));
    if (scene.draws_nothing_visible) return result;
    const bool theirs_is_blank = is_blank(scene, theirs);
    if (theirs_is_blank) result.problems.emplace_back("the reference's picture is blank");
    if (same_colours(ours, theirs) ? theirs_is_blank : is_blank(scene, ours))
        result.problems.emplace_back("the picture is blank");
    return result;
}

}  // namespace terrazzo::piglit
