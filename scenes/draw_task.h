// Stage: child side of the bench and demo commands: draws one scene with one library.
// Input: JSON {library, scene, model (a file of packed bytes; then scene is only its name), width, height,
// frame, camera (of the model; -1: where all of it is seen), seconds, animate, samples (of a pixel), picture,
// planes}. Output: JSON {renderer, version, first_frame_seconds, frames, median_frame_seconds,
// mean_frame_seconds, peak_resident_kib, errors} and, when asked for, the binary planes colour (RGBA8; with
// picture it alone), depth (u32 steps), stencil. Invariant: every frame ends with glFinish, as an OSMesa
// client must to see its buffer.
#pragma once

#include <nlohmann/json.hpp>

namespace terrazzo {

nlohmann::json draw_task(const nlohmann::json& arguments);

// JSON {library, names (a file, packed: {core: [name...], extensions: {extension: [name...]}, exported: [name...]})}:
// strings, limits, and for how many of each it was asked and which OSMesaGetProcAddress answers NULL for. Of extensions
// only those count that GL_EXTENSIONS names.
nlohmann::json info_task(const nlohmann::json& arguments);

}  // namespace terrazzo
