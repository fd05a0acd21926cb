// One image (one mip level) of a texture, in the form the sampler reads.
//
// Input: rows that src/gl has converted and quantised. Output: texels expanded to RGBA as sampling sees them
// (GL 1.5 table 3.20: alpha [0,0,0,A], luminance [L,L,L,1], intensity [I,I,I,I], ...), row 0 first (t = 0).
// What was drawn to a depth texture may stay where it was drawn: the image then has the tiles of a target's
// plane (target.h), the sampler reads those, and rows are made of them when somebody asks for texels.
//
// Invariant: an image that a queued draw refers to never changes. Whoever writes to one asks
// `LevelImage::writable` for it, which clones an image that somebody else holds too; so the pixels are
// immutable as soon as they are shared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "raster/target/formats.h"
#include "raster/target/plane.h"
#include "raster/target/sole_owner.h"
#include "raster/target/zeroed_memory.h"

namespace terrazzo::raster {

constexpr size_t bytes_per_texel(TexelStorage storage) {
    return storage == TexelStorage::kRgba32F ? 16 : 4;
}

struct TextureImage {
    // Vector loads of the sampler may start this many bytes before the first texel and end this many after
    // the last.
    static constexpr size_t kPaddingBytes = 64;

    // An image of zeros; null when memory is short.
    struct Size {
        int width = 1, height = 1, depth = 1;  // texels of the image proper, without border
        int border_x = 0;                      // 0 or 1 texel on either side; 1D images have none in y
        int border_y = 0;
        int border_z = 0;
    };
    static std::shared_ptr<TextureImage> create(const Size& size, TexelStorage storage,
                                                BaseFormat base_format);

    // A private copy of the same texels, or of zeros in their place; null when memory is short.
    std::shared_ptr<TextureImage> clone(bool with_texels = true) const;

    // The texel (x, y, z) with the border outside: x from -border_x to width + border_x - 1, y and z
    // likewise. Texel (0, 0) and with it every row of a power-of-two image without border is aligned to 64
    // bytes as far as its width allows.
    const uint8_t* rgba8(int x, int y, int z = 0) const { return m_texels + 4 * index(x, y, z); }
    uint8_t* rgba8(int x, int y, int z = 0) { return m_texels + 4 * index(x, y, z); }
    const float* rgba32f(int x, int y, int z = 0) const {
        return reinterpret_cast<const float*>(m_texels) + 4 * index(x, y, z);
    }
    float* rgba32f(int x, int y, int z = 0) {
        return reinterpret_cast<float*>(m_texels) + 4 * index(x, y, z);
    }
    const uint32_t* depths(int x, int y) const {
        make_rows();
        return reinterpret_cast<const uint32_t*>(m_texels) + index(x, y, 0);
    }
    uint32_t* depths(int x, int y) {
        make_rows();
        return reinterpret_cast<uint32_t*>(m_texels) + index(x, y, 0);
    }
    // Stencil values beside depths; null as long as all are 0 and nothing has called make_stencils(), which
    // throws std::bad_alloc.
    const uint8_t* stencils(int x, int y) const {
        return m_stencils.empty() ? nullptr : m_stencils.data() + index(x, y, 0);
    }
    uint8_t* stencils(int x, int y) {
        return m_stencils.empty() ? nullptr : m_stencils.data() + index(x, y, 0);
    }
    bool has_stencils() const { return !m_stencils.empty(); }
    void make_stencils() {
        m_stencils.resize(static_cast<size_t>(pitch) * static_cast<size_t>(stored_height()));
    }
    // The depths as they were drawn, which the sampler reads in place of rows: a bin of them after the other,
    // as many to a row as the width takes. Null where there are none.
    const std::shared_ptr<PlanePixels>& tiles() const { return m_tiles; }
    // Takes what was drawn, which nobody will write to any more, in place of rows: of an image without
    // border, of the plane's size and bits.
    void show_tiles(std::shared_ptr<PlanePixels> tiles);
    std::shared_ptr<PlanePixels> take_tiles() { return std::exchange(m_tiles, nullptr); }

    // The texel (0, 0, 0), whatever its storage, of an image that has no tiles.
    const void* first_texel() const {
        return m_texels + bytes_per_texel(storage) * static_cast<size_t>(index(0, 0, 0));
    }

    int stored_width() const { return width + 2 * border_x; }
    int stored_height() const { return height + 2 * border_y; }
    int stored_depth() const { return depth + 2 * border_z; }
    int slice() const {
        return pitch * stored_height();
    }  // texels from one image of a 3D texture to the next

    // What no texture holds any more and queued draws still do, in all contexts: frames are drawn when it is
    // much.
    static size_t abandoned_bytes();
    void abandon();

    // Rows that are to be written: nothing else holds the texels any more.
    void keep_rows_alone() {
        make_rows();
        m_tiles.reset();
    }

    TextureImage() = default;
    ~TextureImage();
    TextureImage(const TextureImage&) = delete;
    TextureImage& operator=(const TextureImage&) = delete;

    int width = 0;
    int height = 0;
    int depth = 1;
    int border_x = 0;
    int border_y = 0;
    int border_z = 0;
    int pitch = 0;  // texels from one row to the next
    TexelStorage storage = TexelStorage::kRgba8;
    BaseFormat base_format = BaseFormat::kRgba;

    // Names the texels: another number after each change of them, in no two images the same.
    uint64_t content() const { return m_content; }
    void content_changes();

  private:
    ptrdiff_t index(int x, int y, int z) const {
        return static_cast<ptrdiff_t>(z + border_z) * slice() + static_cast<ptrdiff_t>(y + border_y) * pitch +
               (x + border_x);
    }
    size_t size_in_bytes() const {
        return static_cast<size_t>(pitch) * static_cast<size_t>(stored_height()) *
               static_cast<size_t>(stored_depth()) * bytes_per_texel(storage);
    }

    // Makes the rows hold what the tiles do; whoever asks has the textures' lock.
    void make_rows() const {
        if (m_rows_are_old) copy_tiles_to_rows();
    }
    void copy_tiles_to_rows() const;

    ZeroedMemory m_memory;
    std::shared_ptr<PlanePixels> m_tiles;
    mutable bool m_rows_are_old = false;
    bool m_gave_rows_back = false;
    uint8_t* m_texels = nullptr;  // the first stored texel, 64-byte aligned, inside m_memory
    std::vector<uint8_t> m_stencils;
    bool m_abandoned = false;
    uint64_t m_content = 0;
};

// A texture level's hold of its image, the only one besides those of queued draws.
class LevelImage {
  public:
    LevelImage() = default;
    LevelImage(std::nullptr_t) {}
    LevelImage(std::shared_ptr<TextureImage> image) : m_image(std::move(image)) {}
    LevelImage(LevelImage&&) = default;
    LevelImage& operator=(LevelImage&& other) noexcept {
        let_go();
        m_image = std::move(other.m_image);
        return *this;
    }
    ~LevelImage() { let_go(); }

    explicit operator bool() const { return m_image != nullptr; }
    TextureImage* operator->() const { return m_image.get(); }
    TextureImage& operator*() const { return *m_image; }
    const std::shared_ptr<TextureImage>& shared() const { return m_image; }
    bool in_use() const { return m_image && !is_sole_owner(m_image); }

    // The image to write to: a copy in its place where it is in use. Null, and nothing is changed, when
    // memory is short.
    TextureImage* writable();
    // The image to change without its texels, which stay where they are; otherwise the same.
    TextureImage* writable_beside_texels();
    // The image to give new tiles in place of all texels; otherwise the same. What it had may be gone.
    TextureImage* replaceable();

  private:
    TextureImage* in_place_of_used(bool with_texels);

    void let_go() {
        if (in_use()) m_image->abandon();
    }

    std::shared_ptr<TextureImage> m_image;
};

}  // namespace terrazzo::raster
