// Trials of the fragment side.
#include "colors/trial.h"
namespace terrazzo::test {
std::vector<Trial> fragment_trials() {
    return {};
}
}  // namespace terrazzo::test
