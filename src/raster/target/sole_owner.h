// Whether a shared object may be changed in place.
//
// Contexts of several threads hold references to images and buffers' stores. The last but one lets go of its
// reference in its own thread; what it has read before must not be overtaken by what is written after.
#pragma once

#include <memory>

namespace terrazzo::raster {

// Whether nobody else holds the object, and all that others have done with it is over. Nobody may be able to
// take a new reference meanwhile.
template <typename Object>
bool is_sole_owner(const std::shared_ptr<Object>& object) {
    if (object.use_count() != 1) return false;
    // use_count() orders nothing. To take a reference does, after all that were given back.
    const std::shared_ptr<Object> order = object;
    return true;
}

}  // namespace terrazzo::raster
