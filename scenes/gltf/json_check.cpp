// What tinygltf assumes of a document without looking: it cuts integers to 32 bits, takes an offset that is
// negative or no integer for absent, and gives up the whole file for one odd element.
#include "json_check.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace terrazzo::gltf {
namespace {

using nlohmann::json;

// glTF needs six; files with extensions a few more. What comes after walks documents recursively.
constexpr int kDeepestJson = 64;
// A value takes a dozen times its text's memory, and an element of a section much more in tinygltf's model.
constexpr std::size_t kMostValues = 4'000'000;
constexpr std::size_t kMostElements = 250'000;

const std::set<std::string> kWholeNumbers{"bufferView", "buffer",        "byteOffset", "byteLength",
                                          "byteStride", "componentType", "count",      "indices",
                                          "material",   "mode",          "mesh",       "skin",
                                          "camera",     "source",        "sampler",    "index",
                                          "texCoord",   "input",         "output",     "inverseBindMatrices"};
// These may pass 32 bits; tinygltf keeps 64 of them.
const std::set<std::string> kSizes{"byteOffset", "byteLength", "count"};

const std::map<std::string, std::size_t> kNodeNumbers{
    {"matrix", 16}, {"rotation", 4}, {"scale", 3}, {"translation", 3}};

// Lists of references.
const std::map<std::string, const char*> kReferences{
    {"scenes", "nodes"}, {"nodes", "children"}, {"skins", "joints"}};

const std::map<std::string, json> kNeutral{
    {"bufferViews", {{"buffer", 0}, {"byteLength", 0}}},
    {"accessors", {{"componentType", 5126}, {"count", 0}, {"type", "SCALAR"}}},
    {"meshes", json::object()},
    {"nodes", json::object()},
    {"scenes", json::object()},
    {"materials", json::object()},
    {"textures", json::object()},
    {"samplers", json::object()},
    {"skins", {{"joints", json::array()}}},
    {"cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0}, {"znear", 0}}}}}};

// JSON knows no difference between 3 and 3.0, and tinygltf should not see one.
void make_whole(json& value) {
    if (!value.is_number_float()) return;
    const auto number = value.get<double>();
    constexpr double kLargest = std::numeric_limits<std::int32_t>::max();
    if (std::trunc(number) != number || std::abs(number) > kLargest) return;
    if (number < 0) {
        value = static_cast<std::int64_t>(number);
    } else {
        value = static_cast<std::uint64_t>(number);
    }
}

// An integer that tinygltf would cut becomes a floating-point number, which it does not take for one.
void keep_whole(json& value) {
    if (!value.is_number_integer()) return;
    const bool too_large = value.is_number_unsigned()
                               ? value.get<std::uint64_t>() >
                                     static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())
                               : value.get<std::int64_t>() < std::numeric_limits<std::int32_t>::min();
    if (too_large) value = value.get<double>();
}

bool is_whole_from_zero(const std::string& key, const json& value) {
    if (!value.is_number_unsigned()) return false;
    return kSizes.count(key) > 0 || value.get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
}

void bring_into_form(json& value) {
    make_whole(value);
    keep_whole(value);
    if (value.is_structured())
        for (json& element : value) bring_into_form(element);
}

// The first reason why an element cannot be used, or nothing. Brings numbers into form on the way.
std::string fault_in(json& value) {
    if (value.is_array()) {
        for (json& element : value) {
            make_whole(element);
            keep_whole(element);
            if (std::string fault = fault_in(element); !fault.empty()) return fault;
        }
    } else if (value.is_object()) {
        value.erase("extras");
        for (auto& [key, member] : value.items()) {
            make_whole(member);
            if (key == "extensions") {  // which name their members as they like
                bring_into_form(member);
                continue;
            }
            // "indices" is also the name of a sparse accessor's object.
            if (kWholeNumbers.count(key) > 0 && !(key == "indices" && member.is_object())) {
                if (!is_whole_from_zero(key, member)) return key + " is not a whole number from 0";
            } else {
                keep_whole(member);
                if (std::string fault = fault_in(member); !fault.empty()) return fault;
            }
        }
    }
    return {};
}

bool are_numbers(const json& value, std::size_t count) {
    if (!value.is_array() || value.size() != count) return false;
    for (const json& element : value)
        if (!element.is_number()) return false;
    return true;
}

bool are_references(const json& value) {
    if (!value.is_array()) return false;
    for (const json& element : value)
        if (!is_whole_from_zero("", element)) return false;
    return true;
}

bool has_whole(const json& value, const char* key) {
    return value.is_object() && value.contains(key) && is_whole_from_zero(key, value[key]);
}

// tinygltf leaves the numbers of an incomplete sparse part as they lay in memory, and keeps 32 bits of each.
std::string fault_of_sparse(const json& sparse) {
    if (!sparse.is_object() || !sparse.contains("indices") || !sparse.contains("values"))
        return "its sparse part is not complete";
    const json &indices = sparse["indices"], &values = sparse["values"];
    if (!has_whole(sparse, "count") || !has_whole(indices, "bufferView") ||
        !has_whole(indices, "componentType") || !has_whole(values, "bufferView"))
        return "its sparse part is not complete";
    constexpr std::uint64_t kLargest = std::numeric_limits<std::int32_t>::max();
    if (sparse["count"].get<std::uint64_t>() > kLargest || indices.value("byteOffset", 0ULL) > kLargest ||
        values.value("byteOffset", 0ULL) > kLargest)
        return "its sparse part is too large";
    return {};
}

std::string check_element(const std::string& section, json& element) {
    if (!element.is_object()) return "it is not an object";
    if (std::string fault = fault_in(element); !fault.empty()) return fault;
    if (section == "accessors" && element.contains("sparse")) return fault_of_sparse(element["sparse"]);
    if (section == "meshes" && element.contains("primitives") && !element["primitives"].is_array())
        return "primitives is not a list";
    if (const auto found = kReferences.find(section); found != kReferences.end() &&
                                                      element.contains(found->second) &&
                                                      !are_references(element[found->second]))
        return std::string(found->second) + " is not a list of whole numbers from 0";
    if (section == "materials")
        for (const char* part : {"pbrMetallicRoughness", "emissiveTexture"})
            if (element.contains(part) && !element[part].is_object())
                return std::string(part) + " is not an object";
    if (section != "nodes") return {};
    for (const auto& [key, count] : kNodeNumbers)
        if (element.contains(key) && !are_numbers(element[key], count))
            return key + " is not " + std::to_string(count) + " numbers";
    return {};
}

}  // namespace

json parse_document(const std::string& text) {
    json document;
    std::size_t values = 0;
    try {
        document = json::parse(text, [&](int depth, json::parse_event_t, const json&) {
            if (depth > kDeepestJson) refuse("its JSON is nested too deeply");
            if (++values > kMostValues) refuse("its JSON has too many values");
            return true;
        });
    } catch (const json::exception& failure) {
        refuse(std::string("it is not glTF: ") + failure.what());
    }
    if (!document.is_object()) refuse("it is not glTF: its JSON is not an object");
    return document;
}

const std::vector<std::string>& section_names() {
    static const std::vector<std::string> kNames{"bufferViews", "accessors", "meshes", "nodes",    "scenes",
                                                 "materials",   "textures",  "skins",  "samplers", "cameras"};
    return kNames;
}

const json& neutral_element(const std::string& section) {
    return kNeutral.at(section);
}

void check_sections(json& document, Notes& notes) {
    for (const std::string& section : section_names()) {
        if (!document.contains(section)) continue;
        json& elements = document[section];
        if (!elements.is_array()) {
            notes.add(section + " is not a list and is ignored");
            document.erase(section);
            continue;
        }
        if (elements.size() > kMostElements)
            refuse("it has more than " + std::to_string(kMostElements) + " " + section);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const std::string fault = check_element(section, elements[i]);
            if (fault.empty()) continue;
            notes.add(section + "[" + std::to_string(i) + "] is ignored: " + fault);
            elements[i] = neutral_element(section);
        }
    }
}

}  // namespace terrazzo::gltf
