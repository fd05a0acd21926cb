// Stage: piglit-lite, telling people and machines what was found.
#pragma once

#include <string>
#include <vector>

#include "runner.h"

namespace terrazzo::piglit {

// One self-contained page: per scene both pictures, their difference magnified, figures and softpipe's.
std::string html_report(const Options& options, const std::vector<SceneReport>& reports);
// A test suite a chapter, a test case a scene.
std::string junit_report(const std::vector<SceneReport>& reports);

}  // namespace terrazzo::piglit
