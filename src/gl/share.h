// Objects that contexts created with a share partner have in common (GL 1.5 §5.4, §3.8.12; glXCreateContext).
//
// Contexts of one group may be current in different threads: every access to the maps holds `mutex`. Objects
// are shared_ptr, so one that is deleted or replaced stays alive for whoever is using it.
#pragma once

#include <GL/gl.h>

#include <map>
#include <memory>
#include <mutex>

#include "gl/buffers.h"
#include "gl/framebuffer_object.h"
#include "gl/name_ranges.h"
#include "gl/texture.h"

namespace terrazzo::gl {

class DisplayList;

struct ShareGroup {
    std::mutex mutex;
    NameRanges list_names;  // in use: made by NewList or set aside by GenLists
    std::map<GLuint, std::shared_ptr<const DisplayList>> lists;  // those that are not empty
    TextureNames textures;
    BufferNames buffers;
    RenderbufferNames renderbuffers;
};

}  // namespace terrazzo::gl
