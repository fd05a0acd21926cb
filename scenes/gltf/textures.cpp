// Samplers, images and KHR_texture_transform.
#include "textures.h"

#include <algorithm>
#include <cmath>

#include "images.h"

namespace terrazzo::gltf {
namespace {

constexpr int kLargestSide = 8192;  // llvmpipe's limit; ours is no lower

int wrap_mode(int mode) {
    return mode == GL_CLAMP_TO_EDGE || mode == GL_MIRRORED_REPEAT ? mode : GL_REPEAT;
}

bool is_mipmap_filter(int filter) {
    return filter >= GL_NEAREST_MIPMAP_NEAREST && filter <= GL_LINEAR_MIPMAP_LINEAR;
}

void set_sampler(Texture& texture, const tinygltf::Model& file, int sampler_index) {
    texture.min_filter = GL_LINEAR_MIPMAP_LINEAR;
    if (sampler_index < 0) return;
    const tinygltf::Sampler& sampler = at(file.samplers, sampler_index, "sampler");
    texture.wrap_s = wrap_mode(sampler.wrapS);
    texture.wrap_t = wrap_mode(sampler.wrapT);
    if (sampler.magFilter == GL_NEAREST) texture.mag_filter = GL_NEAREST;
    if (sampler.minFilter == GL_NEAREST || sampler.minFilter == GL_LINEAR ||
        is_mipmap_filter(sampler.minFilter))
        texture.min_filter = sampler.minFilter;
}

void multiply(Level& level, const Colour& factor) {
    for (std::size_t i = 0; i < level.rgba.size(); ++i) {
        const float value = static_cast<float>(level.rgba[i]) * factor[i % 4];
        level.rgba[i] = static_cast<std::uint8_t>(std::clamp(value, 0.0F, 255.0F) + 0.5F);
    }
}

std::string name_of(int texture) {
    return "textures[" + std::to_string(texture) + "]";
}

}  // namespace

Level Textures::image_of(int index) {
    const tinygltf::Texture& texture = at(m_document.file.textures, index, "texture");
    if (texture.source < 0) refuse("it has no image");
    const ImageSource& source = at(m_document.images, texture.source, "image");
    if (!source.uri.empty()) return decode_image(read_uri(m_document, source.uri, m_bytes), m_pixels);
    if (source.buffer_view < 0) refuse("its image has neither a URI nor a buffer view");
    return decode_image(bytes_of_view(m_document.file, source.buffer_view), m_pixels);
}

Texture Textures::make(int index, bool opaque, const Colour& factor) {
    Level image = image_of(index);
    if (image.width > kLargestSide || image.height > kLargestSide)
        m_notes.add(name_of(index) + " is reduced: no side of a texture may have more than " +
                    std::to_string(kLargestSide) + " pixels");
    if (opaque)
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    if (factor != Colour{1, 1, 1, 1}) multiply(image, factor);
    Texture texture;
    set_sampler(texture, m_document.file, at(m_document.file.textures, index, "texture").sampler);
    texture.levels.push_back(reduced_to(std::move(image), kLargestSide));
    if (is_mipmap_filter(texture.min_filter)) add_smaller_levels(texture.levels);
    return texture;
}

int Textures::find(int index, bool opaque, const Colour& factor) {
    if (index < 0) return -1;
    const bool is_there = index < static_cast<int>(m_document.file.textures.size());
    Key key(opaque, factor, -2, index);  // no image has this number
    if (is_there) {
        const tinygltf::Texture& texture = m_document.file.textures[static_cast<std::size_t>(index)];
        key = Key(opaque, factor, texture.source, texture.sampler);
    }
    if (const auto known = m_known.find(key); known != m_known.end()) return known->second;
    int place = -1;
    try {
        m_textures.push_back(make(index, opaque, factor));
        place = static_cast<int>(m_textures.size()) - 1;
    } catch (const std::exception& failure) {
        m_notes.add(name_of(index) + " is left out: " + failure.what());
    }
    return m_known[key] = place;
}

int Textures::plain(const Colour& colour) {
    Level level{1, 1, {255, 255, 255, 255}};
    multiply(level, colour);
    Texture texture;
    texture.levels.push_back(std::move(level));
    m_textures.push_back(std::move(texture));
    return static_cast<int>(m_textures.size()) - 1;
}

Colour Textures::mean(int index) {
    if (const auto known = m_means.find(index); known != m_means.end()) return known->second;
    Colour mean{1, 1, 1, 1};
    try {
        const Level level = image_of(index);
        double sums[4] = {};
        for (std::size_t i = 0; i < level.rgba.size(); ++i) sums[i % 4] += level.rgba[i];
        for (std::size_t c = 0; c < 4; ++c)
            mean[c] = static_cast<float>(sums[c] * 4 / 255 / static_cast<double>(level.rgba.size()));
    } catch (const std::exception& failure) {
        m_notes.add(name_of(index) + " is left out: " + failure.what());
    }
    return m_means[index] = mean;
}

double number_in(const tinygltf::Value& object, const char* name, double otherwise) {
    if (!object.IsObject() || !object.Has(name) || !object.Get(name).IsNumber()) return otherwise;
    return object.Get(name).GetNumberAsDouble();
}

std::vector<double> numbers_in(const tinygltf::Value& object, const char* name,
                               std::vector<double> otherwise) {
    if (!object.IsObject() || !object.Has(name)) return otherwise;
    const tinygltf::Value& list = object.Get(name);
    if (!list.IsArray() || list.ArrayLen() != otherwise.size()) return otherwise;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < otherwise.size(); ++i) {
        const tinygltf::Value& number = list.Get(i);
        if (!number.IsNumber()) return otherwise;
        numbers.push_back(number.GetNumberAsDouble());
    }
    return numbers;
}

TexturePlace place_of(int set, const tinygltf::ExtensionMap& extensions) {
    TexturePlace place{set, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    const auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end()) return place;
    const tinygltf::Value& transform = found->second;
    const std::vector<double> offset = numbers_in(transform, "offset", {0, 0});
    const std::vector<double> scale = numbers_in(transform, "scale", {1, 1});
    const double rotation = number_in(transform, "rotation", 0);
    const double sine = std::sin(rotation), cosine = std::cos(rotation);
    const double override_set = number_in(transform, "texCoord", set);
    place.set = override_set >= 0 && override_set < 1e6 ? static_cast<int>(override_set) : set;
    // Scaled, then turned counter-clockwise as one sees it with t downwards, then shifted.
    place.matrix[0] = static_cast<float>(cosine * scale[0]);
    place.matrix[1] = static_cast<float>(-sine * scale[0]);
    place.matrix[4] = static_cast<float>(sine * scale[1]);
    place.matrix[5] = static_cast<float>(cosine * scale[1]);
    place.matrix[12] = static_cast<float>(offset[0]);
    place.matrix[13] = static_cast<float>(offset[1]);
    return place;
}

}  // namespace terrazzo::gltf
