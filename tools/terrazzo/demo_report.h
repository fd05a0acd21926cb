// Stage: the demo's page and contact sheet.
// Input: per scene the two pictures and the measurements, and the programs. Output: HTML text and a picture.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include <optional>
#include <string>
#include <vector>

#include "demo_programs.h"
#include "rounds.h"

namespace terrazzo {

struct DemoScene {
    std::string name;
    std::string description;
    // Empty when the library failed; then there is a failure in words.
    std::optional<OIIO::ImageBuf> ours;
    std::optional<OIIO::ImageBuf> theirs;
    std::vector<std::string> failures;
    std::size_t pixels_off = 0;  // by more than one step of 255
    double largest_difference = 0;
    bench::SceneResult speed;

    // Of two pictures.
    bool agrees() const {
        const OIIO::ImageSpec& size = ours->spec();
        return static_cast<double>(pixels_off) <=
               (1 - kAgreeingShare) * static_cast<double>(size.image_pixels());
    }
};

inline constexpr const char* kOurs = "Terrazzo";
inline constexpr const char* kTheirs = "OSMesa";

std::string demo_page(const std::vector<DemoScene>& scenes, const std::vector<int>& threads,
                      const DemoPrograms& programs);
// Two of them a row: ours, theirs, difference.
OIIO::ImageBuf demo_contact_sheet(const std::vector<DemoScene>& scenes, const DemoPrograms& programs);

}  // namespace terrazzo
