// Stage: models from files, a document before tinygltf sees it. Input: JSON text. Output: a document whose
// sections are lists of objects, whose references, counts and offsets are whole numbers from 0 that tinygltf
// reads without cutting them, and whose nodes' numbers have the lengths that glTF gives them.
// Invariant: an element that is not so becomes a neutral one in its place, and a note says which and why.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "notes.h"

namespace terrazzo::gltf {

// Throws std::runtime_error for text that is not JSON, not an object or nested too deeply.
nlohmann::json parse_document(const std::string& text);

void check_sections(nlohmann::json& document, Notes& notes);

// The sections that check_sections has lists of, in tinygltf's order.
const std::vector<std::string>& section_names();
// An element of a section that stands for nothing.
const nlohmann::json& neutral_element(const std::string& section);

}  // namespace terrazzo::gltf
