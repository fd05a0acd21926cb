// The attribute list of OSMesaCreateContextAttribs.
#pragma once

#include <optional>

#include "gl/config.h"

namespace terrazzo::osmesa {

struct ContextAttributes {
    int format;
    gl::Config config;
};

// Empty when the list has an unknown attribute or a value that is out of range, or wants what is not there: a
// core profile, or a version above ours. `list` is (attribute, value) pairs ended by 0; null stands for an
// empty list.
std::optional<ContextAttributes> parse_attributes(const int* list);

}  // namespace terrazzo::osmesa
