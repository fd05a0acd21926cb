// Everything that can be queried of a context, as text: one line a variable and query type, floats in
// hexadecimal so that every bit shows. Two libraries in the same state give equal dumps.
#pragma once

#include <string>
#include <vector>

#include "kit/library.h"

namespace terrazzo::test {

std::vector<std::string> dump_state(const kit::Gl& gl);

// That of every texture unit, light and plane as well, and what textures, pixel maps and evaluators hold.
std::vector<std::string> dump_everything(const kit::Gl& gl);

// The lines of `after` that `before`, another dump, does not have.
std::vector<std::string> changed(const std::vector<std::string>& before,
                                 const std::vector<std::string>& after);

}  // namespace terrazzo::test
