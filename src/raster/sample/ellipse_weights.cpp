// The table of ellipse_weights.h, computed by the compiler. The reference's was printed with six digits
// (doc/reference.md §4), so this one is rounded to them.
#include "raster/sample/ellipse_weights.h"

namespace terrazzo::raster {

namespace {

// e^-x for 0 <= x <= 2: Taylor's series of e^(-x/4), whose 20 terms leave nothing that a double could hold.
constexpr double exp_of_negative(double x) {
    double term = 1, sum = 1;
    for (int n = 1; n <= 20; ++n) {
        term *= -x / (4 * n);
        sum += term;
    }
    return sum * sum * sum * sum;
}

constexpr EllipseWeights make_weights() {
    EllipseWeights weights{};
    for (int i = 0; i < kEllipseWeightCount; ++i) {
        const float share = static_cast<float>(i) / (kEllipseWeightCount - 1);
        const float weight = static_cast<float>(exp_of_negative(2.0 * static_cast<double>(share)));
        const auto digits = static_cast<int>(static_cast<double>(weight) * 1e6 + 0.5);
        weights.of_distance[i] = static_cast<float>(digits / 1e6);
    }
    return weights;
}

}  // namespace

constinit const EllipseWeights kEllipseWeights = make_weights();

}  // namespace terrazzo::raster
