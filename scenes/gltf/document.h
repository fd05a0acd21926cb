// Stage: models from files, the document. Input: a file's path. Output: tinygltf's model of it with the
// buffers that could be read, and where its images are. Invariant: lists have the lengths that the file gave
// them; what could not be read is empty in its place and has a note; required extensions are there.
#pragma once

#include <tiny_gltf.h>

#include <span>
#include <string>
#include <vector>

#include "container.h"
#include "notes.h"

namespace terrazzo::gltf {

struct ImageSource {
    std::string uri;  // a file beside the model's or a data URI; empty: in a view
    int buffer_view = -1;
};

struct Document {
    tinygltf::Model file;  // has no images, animations or lights
    std::vector<ImageSource> images;
    // Accessors without a view of their own are all zeros (glTF 2.0 §3.6.2.1): they have this one instead.
    int zeros_view = 0;
    std::string folder;
};

// Throws std::runtime_error for what is not glTF 2 or needs an extension that is not there.
Document read_document(const std::string& path, Budget& bytes, Notes& notes);

// The bytes of a data URI or of a file beside the model's. Throws std::runtime_error.
Bytes read_uri(const Document& document, const std::string& uri, Budget& bytes, std::size_t most = SIZE_MAX);

// A buffer view's bytes. Throws std::runtime_error when they are not all in its buffer.
std::span<const unsigned char> bytes_of_view(const tinygltf::Model& file, int view);

}  // namespace terrazzo::gltf
