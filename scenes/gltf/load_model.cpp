// Stage: models from files. Files come from anywhere: every accessor, index and node reference is checked
// before use.
#include "load_model.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace terrazzo::gltf {
namespace {

using Matrix = std::array<double, 16>;  // column-major

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
// Files can nest their nodes without end.
constexpr int kDeepestNode = 64;

[[noreturn]] void refuse(const std::string& reason) {
    throw std::runtime_error("model: " + reason);
}

template <typename T>
const T& at(const std::vector<T>& list, int index, const char* what) {
    if (index < 0 || static_cast<std::size_t>(index) >= list.size()) refuse(std::string("no such ") + what);
    return list[static_cast<std::size_t>(index)];
}

// --- images
// -------------------------------------------------------------------------------------------------------

const char* name_by_content(const unsigned char* bytes, int size) {
    return size > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8 ? "image.jpg" : "image.png";
}

bool decode_image(tinygltf::Image* image, const int, std::string* error, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
    OIIO::Filesystem::IOMemReader reader(const_cast<unsigned char*>(bytes), static_cast<std::size_t>(size));
    const auto input = OIIO::ImageInput::open(name_by_content(bytes, size), nullptr, &reader);
    if (!input) {
        *error += OIIO::geterror();
        return false;
    }
    const OIIO::ImageSpec spec = input->spec();
    std::vector<unsigned char> source(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, source.data())) {
        *error += input->geterror();
        return false;
    }
    const std::size_t channels = static_cast<std::size_t>(spec.nchannels);
    image->image.resize(source.size() / channels * 4);
    for (std::size_t i = 0; i < source.size() / channels; ++i) {
        const unsigned char* from = &source[i * channels];
        unsigned char* to = &image->image[i * 4];
        for (std::size_t c = 0; c < 3; ++c) to[c] = from[channels >= 3 ? c : 0];
        to[3] = channels == 4 ? from[3] : channels == 2 ? from[1] : 255;
    }
    image->width = spec.width;
    image->height = spec.height;
    image->component = 4;
    image->bits = 8;
    image->pixel_type = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    return true;
}

void add_smaller_levels(Texture& texture) {
    const Level first = texture.levels.front();
    const OIIO::ImageSpec spec(first.width, first.height, 4, OIIO::TypeDesc::UINT8);
    const OIIO::ImageBuf full(spec, const_cast<std::uint8_t*>(first.rgba.data()));
    for (int w = first.width, h = first.height; w > 1 || h > 1;) {
        w = std::max(1, w / 2);
        h = std::max(1, h / 2);
        const OIIO::ImageBuf small =
            OIIO::ImageBufAlgo::resize(full, "box", 0, OIIO::ROI(0, w, 0, h, 0, 1, 0, 4));
        Level level{w, h, std::vector<std::uint8_t>(static_cast<std::size_t>(w) * h * 4)};
        if (!small.get_pixels(small.roi(), OIIO::TypeDesc::UINT8, level.rgba.data()))
            refuse(small.geterror());
        texture.levels.push_back(std::move(level));
    }
}

int wrap_mode(int gltf_mode) {
    return gltf_mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE ? GL_CLAMP_TO_EDGE : GL_REPEAT;
}

Texture make_texture(const tinygltf::Model& file, const tinygltf::Texture& source) {
    const tinygltf::Image& image = at(file.images, source.source, "image");
    if (image.width <= 0 || image.height <= 0 || image.component != 4) refuse("an image could not be read");
    Texture texture;
    texture.levels.push_back({image.width, image.height, image.image});
    texture.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    if (source.sampler >= 0) {
        const tinygltf::Sampler& sampler = at(file.samplers, source.sampler, "sampler");
        texture.wrap_s = wrap_mode(sampler.wrapS);
        texture.wrap_t = wrap_mode(sampler.wrapT);
        if (sampler.magFilter == GL_NEAREST) texture.mag_filter = GL_NEAREST;
        if (sampler.minFilter >= GL_NEAREST) texture.min_filter = sampler.minFilter;
    }
    if (texture.min_filter != GL_NEAREST && texture.min_filter != GL_LINEAR) add_smaller_levels(texture);
    return texture;
}

// --- materials
// ----------------------------------------------------------------------------------------------------

// Metals lose their diffuse part to a coloured highlight; a rough surface has a wide, weak one. Chosen by
// eye: fixed function lighting has no physical model to match.
Material make_material(const tinygltf::Model& file, const tinygltf::Material& source) {
    const tinygltf::PbrMetallicRoughness& surface = source.pbrMetallicRoughness;
    Material material;
    const auto metal = static_cast<float>(surface.metallicFactor);
    const auto smooth = 1 - static_cast<float>(surface.roughnessFactor);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto base = static_cast<float>(surface.baseColorFactor.at(i));
        material.diffuse[i] = base * (1 - 0.4F * metal);
        material.specular[i] = (0.15F + 0.6F * smooth) * (metal * base + (1 - metal) * 0.6F);
        // tinygltf leaves the list empty when the file says nothing.
        if (source.emissiveFactor.size() == 3)
            material.emission[i] = static_cast<float>(source.emissiveFactor[i]);
    }
    material.diffuse[3] = static_cast<float>(surface.baseColorFactor.at(3));
    material.shininess = std::clamp(4 + 110 * smooth * smooth, 1.0F, 128.0F);
    material.texture = surface.baseColorTexture.index;
    if (material.texture >= static_cast<int>(file.textures.size())) refuse("no such texture");
    material.double_sided = source.doubleSided;
    material.blended = source.alphaMode == "BLEND";
    if (source.alphaMode == "MASK") material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
    return material;
}

// --- accessors
// ----------------------------------------------------------------------------------------------------

struct Elements {
    const unsigned char* data = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;
    int components = 0;
    int type = 0;
    bool normalized = false;
};

Elements elements_of(const tinygltf::Model& file, int accessor_index) {
    const tinygltf::Accessor& accessor = at(file.accessors, accessor_index, "accessor");
    if (accessor.sparse.isSparse) refuse("sparse accessors are not supported");
    const tinygltf::BufferView& view = at(file.bufferViews, accessor.bufferView, "buffer view");
    const tinygltf::Buffer& buffer = at(file.buffers, view.buffer, "buffer");
    const int stride = accessor.ByteStride(view);
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    if (stride <= 0 || components <= 0 || size <= 0) refuse("an accessor of unknown type");
    const std::size_t offset = view.byteOffset + accessor.byteOffset;
    const std::size_t element = static_cast<std::size_t>(components) * static_cast<std::size_t>(size);
    // Checked without sums that could overflow.
    if (offset > buffer.data.size() || accessor.count == 0) refuse("an accessor outside its buffer");
    const std::size_t room = buffer.data.size() - offset;
    if (room < element || (room - element) / static_cast<std::size_t>(stride) < accessor.count - 1)
        refuse("an accessor outside its buffer");
    return {buffer.data.data() + offset, accessor.count,     static_cast<std::size_t>(stride), components,
            accessor.componentType,      accessor.normalized};
}

template <typename T>
T value_at(const unsigned char* data) {
    T value;
    std::memcpy(&value, data, sizeof value);
    return value;
}

float float_at(const Elements& elements, const unsigned char* data, int component) {
    const auto scaled = [&](auto value) {
        using T = decltype(value);
        return elements.normalized
                   ? static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max())
                   : static_cast<float>(value);
    };
    switch (elements.type) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return value_at<float>(data + 4 * component);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return scaled(value_at<std::uint8_t>(data + component));
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return scaled(value_at<std::int8_t>(data + component));
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return scaled(value_at<std::uint16_t>(data + 2 * component));
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return scaled(value_at<std::int16_t>(data + 2 * component));
        default:
            refuse("a vertex attribute of unknown type");
    }
}

// Exactly `components` floats an element; a missing fourth is 1.
std::vector<float> floats_of(const tinygltf::Model& file, int accessor, int components) {
    const Elements elements = elements_of(file, accessor);
    std::vector<float> values;
    values.reserve(elements.count * static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < elements.count; ++i)
        for (int c = 0; c < components; ++c) {
            const float value =
                c < elements.components ? float_at(elements, elements.data + i * elements.stride, c) : 1;
            if (!std::isfinite(value)) refuse("a vertex attribute is not finite");
            values.push_back(value);
        }
    return values;
}

std::vector<std::uint32_t> indices_of(const tinygltf::Model& file, int accessor, std::size_t vertices) {
    std::vector<std::uint32_t> indices;
    if (accessor < 0) {
        for (std::size_t i = 0; i < vertices; ++i) indices.push_back(static_cast<std::uint32_t>(i));
        return indices;
    }
    const Elements elements = elements_of(file, accessor);
    for (std::size_t i = 0; i < elements.count; ++i) {
        const unsigned char* data = elements.data + i * elements.stride;
        switch (elements.type) {
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                indices.push_back(*data);
                break;
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                indices.push_back(value_at<std::uint16_t>(data));
                break;
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                indices.push_back(value_at<std::uint32_t>(data));
                break;
            default:
                refuse("indices of unknown type");
        }
        if (indices.back() >= vertices) refuse("an index beyond the vertices");
    }
    return indices;
}

// --- geometry
// -----------------------------------------------------------------------------------------------------

template <std::size_t Size>
std::vector<float> unindexed(const std::vector<float>& values, const std::vector<std::uint32_t>& indices) {
    std::vector<float> result;
    if (values.empty()) return result;
    for (const std::uint32_t index : indices)
        result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(index * Size),
                      values.begin() + static_cast<std::ptrdiff_t>(index * Size + Size));
    return result;
}

// glTF 2.0 §3.7.2.1: triangles without normals are flat.
void add_flat_normals(Part& part) {
    part.positions = unindexed<3>(part.positions, part.indices);
    part.textures = unindexed<2>(part.textures, part.indices);
    part.colours = unindexed<4>(part.colours, part.indices);
    for (std::size_t i = 0; i < part.indices.size(); ++i) part.indices[i] = static_cast<std::uint32_t>(i);
    part.normals.assign(part.positions.size(), 0);
    for (std::size_t i = 0; i + 9 <= part.positions.size(); i += 9) {
        const float* p = &part.positions[i];
        const float a[] = {p[3] - p[0], p[4] - p[1], p[5] - p[2]};
        const float b[] = {p[6] - p[0], p[7] - p[1], p[8] - p[2]};
        const float n[] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (std::size_t k = 0; k < 9; ++k) part.normals[i + k] = length > 0 ? n[k % 3] / length : 0;
    }
}

int attribute(const tinygltf::Primitive& primitive, const char* name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

Part make_part(const tinygltf::Model& file, const tinygltf::Primitive& primitive, const Matrix& matrix) {
    Part part;
    // glTF's modes are OpenGL's; -1 is the default.
    part.mode = primitive.mode < 0 ? GL_TRIANGLES : primitive.mode;
    if (part.mode > GL_TRIANGLE_FAN) refuse("a primitive of unknown mode");
    part.positions = floats_of(file, attribute(primitive, "POSITION"), 3);
    const std::size_t vertices = part.positions.size() / 3;
    part.indices = indices_of(file, primitive.indices, vertices);
    const auto optional = [&](const char* name, int components) {
        const int accessor = attribute(primitive, name);
        std::vector<float> values =
            accessor < 0 ? std::vector<float>() : floats_of(file, accessor, components);
        if (!values.empty() && values.size() != vertices * static_cast<std::size_t>(components))
            refuse("attributes of different lengths");
        return values;
    };
    part.normals = optional("NORMAL", 3);
    part.textures = optional("TEXCOORD_0", 2);
    part.colours = optional("COLOR_0", 4);
    if (part.normals.empty() && part.mode == GL_TRIANGLES) add_flat_normals(part);
    // One past the file's own materials is the default material.
    part.material = primitive.material < 0 ? static_cast<int>(file.materials.size()) : primitive.material;
    if (part.material > static_cast<int>(file.materials.size())) refuse("no such material");
    for (std::size_t i = 0; i < 16; ++i) part.matrix[i] = static_cast<float>(matrix[i]);
    const double determinant = matrix[0] * (matrix[5] * matrix[10] - matrix[6] * matrix[9]) -
                               matrix[4] * (matrix[1] * matrix[10] - matrix[2] * matrix[9]) +
                               matrix[8] * (matrix[1] * matrix[6] - matrix[2] * matrix[5]);
    part.mirrored = determinant < 0;
    return part;
}

// --- nodes
// --------------------------------------------------------------------------------------------------------

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix result{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k)
                result[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
    return result;
}

Matrix rotation_and_scale(const tinygltf::Node& node) {
    double x = 0, y = 0, z = 0, w = 1, s[3] = {1, 1, 1};
    if (node.rotation.size() == 4)
        x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
    if (node.scale.size() == 3) std::copy(node.scale.begin(), node.scale.end(), s);
    return {(1 - 2 * (y * y + z * z)) * s[0],
            2 * (x * y + w * z) * s[0],
            2 * (x * z - w * y) * s[0],
            0,
            2 * (x * y - w * z) * s[1],
            (1 - 2 * (x * x + z * z)) * s[1],
            2 * (y * z + w * x) * s[1],
            0,
            2 * (x * z + w * y) * s[2],
            2 * (y * z - w * x) * s[2],
            (1 - 2 * (x * x + y * y)) * s[2],
            0,
            0,
            0,
            0,
            1};
}

Matrix matrix_of(const tinygltf::Node& node) {
    Matrix matrix = kIdentity;
    if (node.matrix.size() == 16) {
        std::copy(node.matrix.begin(), node.matrix.end(), matrix.begin());
        return matrix;
    }
    matrix = rotation_and_scale(node);
    if (node.translation.size() == 3)
        std::copy(node.translation.begin(), node.translation.end(), matrix.begin() + 12);
    return matrix;
}

void add_node(const tinygltf::Model& file, int index, const Matrix& parent, int depth, Model& model) {
    if (depth > kDeepestNode) refuse("nodes nest too deeply");
    const tinygltf::Node& node = at(file.nodes, index, "node");
    const Matrix matrix = product(parent, matrix_of(node));
    if (node.mesh >= 0)
        for (const tinygltf::Primitive& primitive : at(file.meshes, node.mesh, "mesh").primitives)
            model.parts.push_back(make_part(file, primitive, matrix));
    for (const int child : node.children) add_node(file, child, matrix, depth + 1, model);
}

// The default scene's roots; without scenes, every node that is nobody's child.
std::vector<int> root_nodes(const tinygltf::Model& file) {
    if (!file.scenes.empty()) return at(file.scenes, std::max(file.defaultScene, 0), "scene").nodes;
    std::vector<bool> is_child(file.nodes.size(), false);
    for (const tinygltf::Node& node : file.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
                is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

void find_bounds(Model& model) {
    float low[3] = {1e30F, 1e30F, 1e30F}, high[3] = {-1e30F, -1e30F, -1e30F};
    for (const Part& part : model.parts)
        for (std::size_t i = 0; i + 3 <= part.positions.size(); i += 3)
            for (std::size_t row = 0; row < 3; ++row) {
                const float* p = &part.positions[i];
                const float* m = part.matrix;
                const float value = m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row];
                low[row] = std::min(low[row], value);
                high[row] = std::max(high[row], value);
            }
    float squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        model.centre[axis] = (low[axis] + high[axis]) / 2;
        squared += (high[axis] - low[axis]) * (high[axis] - low[axis]) / 4;
    }
    model.radius = std::sqrt(squared);
    if (!(model.radius > 0) || !std::isfinite(model.radius)) refuse("nothing to see");
}

tinygltf::Model read_file(const std::string& path) {
    tinygltf::TinyGLTF loader;
    tinygltf::Model file;
    std::string error, warning;
    loader.SetImageLoader(decode_image, nullptr);
    const bool binary = path.size() > 4 && path.compare(path.size() - 4, 4, ".glb") == 0;
    const bool read = binary ? loader.LoadBinaryFromFile(&file, &error, &warning, path)
                             : loader.LoadASCIIFromFile(&file, &error, &warning, path);
    if (!read) refuse(path + ": " + error);
    return file;
}

}  // namespace

Model load_model(const std::string& path) {
    const tinygltf::Model file = read_file(path);
    Model model;
    for (const tinygltf::Texture& texture : file.textures)
        model.textures.push_back(make_texture(file, texture));
    for (const tinygltf::Material& material : file.materials)
        model.materials.push_back(make_material(file, material));
    model.materials.push_back(make_material(file, tinygltf::Material()));
    for (const int root : root_nodes(file)) add_node(file, root, kIdentity, 0, model);
    find_bounds(model);
    return model;
}

}  // namespace terrazzo::gltf
