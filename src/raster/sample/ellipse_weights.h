// The weights of anisotropic filtering (pixel/anisotropic.h): a Gaussian over the squared distance from the
// centre of a footprint, which is 0 there and 1023 at its border.
#pragma once

namespace terrazzo::raster {

inline constexpr int kEllipseWeightCount = 1024;

struct EllipseWeights {
    float of_distance[kEllipseWeightCount];
};
extern const EllipseWeights kEllipseWeights;

}  // namespace terrazzo::raster
