// Pixels from one target to another, at the same columns, a bin's share at a time.
//
// What is queued must have been drawn. What has one value everywhere is a clear of the other target, no copy.
// Of a multisampled source a pixel's colour is the mean of its samples, its depth the first one's; the other
// target has one sample. Both have the plane that is named: colours of kRgba8, depths of as many bits.
#pragma once

#include "raster/target/target.h"

namespace terrazzo::raster {

struct Copy {
    RowRect from;
    int to_row;   // where the first row goes
    bool turned;  // the others go before it, not after it
};
void copy_rgba8(Target& from, Target& to, const Copy& copy);
void copy_depths(Target& from, Target& to, const Copy& copy);

}  // namespace terrazzo::raster
