// glTF 2.0 §3.6.2: base values or zeros, then a sparse accessor's replacements.
#include "accessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace terrazzo::gltf {
namespace {

template <typename T>
T value_at(const unsigned char* data) {
    T value;
    std::memcpy(&value, data, sizeof value);
    return value;
}

// glTF 2.0 §3.11: c / max, and for signed types no less than -1.
template <typename T>
float scaled(const unsigned char* data, bool normalized) {
    const auto value = static_cast<float>(value_at<T>(data));
    return normalized ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0F) : value;
}

float float_at(const unsigned char* data, int type, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return value_at<float>(data);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return scaled<std::uint8_t>(data, normalized);
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return scaled<std::int8_t>(data, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return scaled<std::uint16_t>(data, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return scaled<std::int16_t>(data, normalized);
        default:
            refuse("a vertex attribute has components of an unknown type");
    }
}

std::uint32_t integer_at(const unsigned char* data, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return *data;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return value_at<std::uint16_t>(data);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return value_at<std::uint32_t>(data);
        default:
            refuse("indices have an unknown type");
    }
}

std::size_t component_size(int type) {
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type));
    if (size <= 0) refuse("an accessor has components of an unknown type");
    return static_cast<std::size_t>(size);
}

// Where elements lie; `stride` 0: one behind the other.
struct Elements {
    const unsigned char* data;
    std::size_t stride;
};

Elements elements_in(const tinygltf::Model& file, int view, std::size_t offset, std::size_t count,
                     std::size_t element, std::size_t stride) {
    const std::span<const unsigned char> bytes = bytes_of_view(file, view);
    if (stride == 0) stride = element;
    if (offset > bytes.size()) refuse("an accessor is not within its buffer view");
    const std::size_t room = bytes.size() - offset;
    if (count > 0 && (room < element || (room - element) / stride < count - 1))
        refuse("an accessor is not within its buffer view");
    return {bytes.data() + offset, stride};
}

int components_of(const tinygltf::Accessor& accessor) {
    return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
}

}  // namespace

const tinygltf::Accessor& Accessors::find(int index) const {
    const tinygltf::Accessor& accessor = at(m_document.file.accessors, index, "accessor");
    if (accessor.count == 0) refuse("an accessor has no elements");
    if (accessor.count > m_longest) refuse("an accessor has more elements than --max-vertices allows");
    return accessor;
}

template <typename T, typename Convert>
std::vector<T> Accessors::read(int index, int components, Convert convert) const {
    const tinygltf::Model& file = m_document.file;
    const tinygltf::Accessor& accessor = find(index);
    m_elements.spend(accessor.count);
    if (accessor.sparse.isSparse) m_elements.spend(static_cast<std::size_t>(accessor.sparse.count));
    if (components_of(accessor) != components) refuse("an accessor has another type than its use asks for");
    const auto width = static_cast<std::size_t>(components);
    const std::size_t size = component_size(accessor.componentType), element = size * width;
    std::vector<T> values;
    const auto copy = [&](const unsigned char* from, T* to) {
        for (std::size_t c = 0; c < width; ++c)
            to[c] = convert(from + c * size, accessor.componentType, accessor.normalized);
    };
    if (accessor.bufferView == m_document.zeros_view) {
        values.resize(accessor.count * width);
    } else {
        const std::size_t stride = at(file.bufferViews, accessor.bufferView, "buffer view").byteStride;
        const Elements from =
            elements_in(file, accessor.bufferView, accessor.byteOffset, accessor.count, element, stride);
        values.resize(accessor.count * width);
        for (std::size_t i = 0; i < accessor.count; ++i)
            copy(from.data + i * from.stride, &values[i * width]);
    }
    if (!accessor.sparse.isSparse) return values;
    const auto& sparse = accessor.sparse;
    const auto count = static_cast<std::size_t>(sparse.count);
    const std::size_t index_size = component_size(sparse.indices.componentType);
    const Elements places =
        elements_in(file, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                    count, index_size, 0);
    const Elements replacements =
        elements_in(file, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
                    element, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = integer_at(places.data + i * places.stride, sparse.indices.componentType);
        if (place >= accessor.count) refuse("a sparse accessor replaces an element that it does not have");
        copy(replacements.data + i * replacements.stride, &values[place * width]);
    }
    return values;
}

std::vector<float> Accessors::floats(int accessor, int components) const {
    std::vector<float> values = read<float>(accessor, components, float_at);
    for (const float value : values)
        if (!std::isfinite(value)) refuse("a value is not finite");
    return values;
}

std::vector<float> Accessors::colours(int accessor) const {
    if (components_of(find(accessor)) == 4) return floats(accessor, 4);
    const std::vector<float> opaque = floats(accessor, 3);
    std::vector<float> values;
    values.reserve(opaque.size() / 3 * 4);
    for (std::size_t i = 0; i < opaque.size(); i += 3)
        values.insert(values.end(), {opaque[i], opaque[i + 1], opaque[i + 2], 1});
    return values;
}

std::vector<std::uint32_t> Accessors::integers(int accessor, int components) const {
    return read<std::uint32_t>(accessor, components, [](const unsigned char* data, int type, bool) {
        return integer_at(data, type);
    });
}

}  // namespace terrazzo::gltf
