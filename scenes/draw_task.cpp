// Stage: child side of the bench and demo commands. Timing covers draw and finish of a frame, nothing else;
// memory is read before any picture is copied out.
#include "draw_task.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "gltf/model.h"
#include "kit/child.h"
#include "kit/object_in_window.h"
#include "kit/offscreen.h"
#include "kit/shared_bytes.h"
#include "study/scenes.h"

namespace terrazzo {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

std::unique_ptr<kit::Drawing> create_drawing(const nlohmann::json& arguments) {
    if (arguments.contains("model"))
        return gltf::create_drawing(gltf::unpack(kit::read_bytes(arguments.at("model").get<std::string>())),
                                    arguments.value("camera", -1));
    const auto name = arguments.at("scene").get<std::string>();
    auto drawing = study::create_scene(name);
    if (!drawing) throw std::runtime_error("no scene is called " + name);
    return drawing;
}

std::string gl_string(const kit::Gl& gl, GLenum name) {
    const auto* text = reinterpret_cast<const char*>(gl.GetString(name));
    return text ? text : "";
}

// One frame, to the object and from there to the window where there is one.
void draw_frame(kit::Drawing& drawing, const kit::Gl& gl, int frame,
                const std::optional<kit::ObjectInWindow>& object) {
    if (object) object->bind();
    drawing.draw(gl, frame);
    if (object) object->show();
    gl.Finish();
}

// Draws for at least the wanted time; returns each frame's seconds.
std::vector<double> time_frames(kit::Drawing& drawing, const kit::Gl& gl, const nlohmann::json& arguments,
                                const std::optional<kit::ObjectInWindow>& object) {
    constexpr std::size_t kFewestFrames = 3;
    const double wanted = arguments.value("seconds", 0.0);
    const bool animate = arguments.value("animate", false);
    int frame = arguments.value("frame", 0);
    std::vector<double> frames;
    if (wanted <= 0) return frames;
    const Clock::time_point start = Clock::now();
    Clock::time_point before = start;
    while (frames.size() < kFewestFrames || seconds_between(start, before) < wanted) {
        if (animate) ++frame;
        draw_frame(drawing, gl, frame, object);
        const Clock::time_point after = Clock::now();
        frames.push_back(seconds_between(before, after));
        before = after;
    }
    return frames;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

nlohmann::json binary(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    return nlohmann::json::binary({bytes, bytes + size});
}

}  // namespace

nlohmann::json draw_task(const nlohmann::json& arguments) {
    const auto drawing = create_drawing(arguments);
    const kit::Library library(arguments.at("library").get<std::string>());
    kit::ContextOptions options;
    options.width = arguments.value("width", study::kWidth);
    options.height = arguments.value("height", study::kHeight);
    const kit::OffscreenContext context(library, options);
    const kit::Gl& gl = library.gl;

    std::optional<kit::ObjectInWindow> object;
    if (const int samples = arguments.value("samples", 0)) object.emplace(gl, options, samples);
    drawing->prepare(gl, options.width, options.height);
    draw_frame(*drawing, gl, arguments.value("frame", 0), object);
    nlohmann::json result{{"first_frame_seconds", kit::seconds_since_start()}};

    const std::vector<double> frames = time_frames(*drawing, gl, arguments, object);
    if (!frames.empty()) {
        double sum = 0;
        for (const double seconds : frames) sum += seconds;
        result["frames"] = frames.size();
        result["median_frame_seconds"] = median(frames);
        result["mean_frame_seconds"] = sum / static_cast<double>(frames.size());
    }
    result["peak_resident_kib"] = kit::peak_resident_kib();
    result["renderer"] = gl_string(gl, GL_RENDERER);
    result["version"] = gl_string(gl, GL_VERSION);
    result["errors"] = nlohmann::json::array();
    for (const GLenum error : context.take_errors()) result["errors"].push_back(kit::error_name(error));
    if (arguments.value("picture", false))
        result["colour"] = binary(context.colour_buffer().data(), context.colour_buffer().size());
    if (arguments.value("planes", false)) {
        const auto depth = context.read_depth();
        const auto stencil = context.read_stencil();
        result["colour"] = binary(context.colour_buffer().data(), context.colour_buffer().size());
        result["depth"] = binary(depth.data(), depth.size() * sizeof depth[0]);
        result["stencil"] = binary(stencil.data(), stencil.size());
    }
    return result;
}

}  // namespace terrazzo
