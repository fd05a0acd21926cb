// The orders of components in client pixels (GL 1.5 table 3.6), and the ways between them and R, G, B, A.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <bit>

#include "gl/channels.h"

namespace terrazzo::gl {

// How the components of a client pixel follow one another in memory.
enum class Order {
    kRed,
    kGreen,
    kBlue,
    kAlpha,
    kRgb,
    kBgr,
    kRgba,
    kBgra,
    kAbgr,
    kArgb,
    kLuminance,
    kLuminanceAlpha
};

inline Order order_of(GLenum format) {
    switch (format) {
        case GL_RED:
            return Order::kRed;
        case GL_GREEN:
            return Order::kGreen;
        case GL_BLUE:
            return Order::kBlue;
        case GL_ALPHA:
            return Order::kAlpha;
        case GL_RGB:
            return Order::kRgb;
        case GL_BGR:
            return Order::kBgr;
        case GL_BGRA:
            return Order::kBgra;
        case GL_ABGR_EXT:
            return Order::kAbgr;
        case GL_LUMINANCE:
            return Order::kLuminance;
        case GL_LUMINANCE_ALPHA:
            return Order::kLuminanceAlpha;
        default:
            return Order::kRgba;
    }
}

inline Order reversed(Order order) {
    switch (order) {
        case Order::kRgba:
            return Order::kAbgr;
        case Order::kAbgr:
            return Order::kRgba;
        default:
            return Order::kArgb;  // of BGRA, the only other with a packed type of four bytes
    }
}

template <typename T>
void components_to_rgba(const T* components, Order order, T one, int count, T* rgba) {
    switch (order) {
        case Order::kRed:
            return spread<1, Channels{0, kZero, kZero, kOne}>(components, one, count, rgba);
        case Order::kGreen:
            return spread<1, Channels{kZero, 0, kZero, kOne}>(components, one, count, rgba);
        case Order::kBlue:
            return spread<1, Channels{kZero, kZero, 0, kOne}>(components, one, count, rgba);
        case Order::kAlpha:
            return spread<1, Channels{kZero, kZero, kZero, 0}>(components, one, count, rgba);
        case Order::kRgb:
            return spread<3, Channels{0, 1, 2, kOne}>(components, one, count, rgba);
        case Order::kBgr:
            return spread<3, Channels{2, 1, 0, kOne}>(components, one, count, rgba);
        case Order::kRgba:
            std::copy_n(components, 4 * count, rgba);
            return;
        case Order::kBgra:
            return spread<4, Channels{2, 1, 0, 3}>(components, one, count, rgba);
        case Order::kAbgr:
            return spread<4, Channels{3, 2, 1, 0}>(components, one, count, rgba);
        case Order::kArgb:
            return spread<4, Channels{1, 2, 3, 0}>(components, one, count, rgba);
        case Order::kLuminance:
            return spread<1, Channels{0, 0, 0, kOne}>(components, one, count, rgba);
        case Order::kLuminanceAlpha:
            return spread<2, Channels{0, 0, 0, 1}>(components, one, count, rgba);
    }
}

template <typename T>
void rgba_to_components(const T* rgba, Order order, int count, T* components) {
    switch (order) {
        case Order::kRed:
        case Order::kLuminance:
            return gather<1, Channels{0}>(rgba, count, components);
        case Order::kGreen:
            return gather<1, Channels{1}>(rgba, count, components);
        case Order::kBlue:
            return gather<1, Channels{2}>(rgba, count, components);
        case Order::kAlpha:
            return gather<1, Channels{3}>(rgba, count, components);
        case Order::kRgb:
            return gather<3, Channels{0, 1, 2}>(rgba, count, components);
        case Order::kBgr:
            return gather<3, Channels{2, 1, 0}>(rgba, count, components);
        case Order::kRgba:
            std::copy_n(rgba, 4 * count, components);
            return;
        case Order::kBgra:
            return gather<4, Channels{2, 1, 0, 3}>(rgba, count, components);
        case Order::kAbgr:
            return gather<4, Channels{3, 2, 1, 0}>(rgba, count, components);
        case Order::kArgb:
            return gather<4, Channels{3, 0, 1, 2}>(rgba, count, components);
        case Order::kLuminanceAlpha:
            return gather<2, Channels{0, 3}>(rgba, count, components);
    }
}

// Whether pixels of this type are plain bytes, and in which order they lie then. Packed types of four bytes
// are.
inline bool are_bytes(GLenum format, GLenum type, bool swap_bytes, Order& order) {
    order = order_of(format);
    if (type == GL_UNSIGNED_BYTE) return true;
    if (type != GL_UNSIGNED_INT_8_8_8_8 && type != GL_UNSIGNED_INT_8_8_8_8_REV) return false;
    const bool first_lowest = (type == GL_UNSIGNED_INT_8_8_8_8_REV) != swap_bytes;
    if (first_lowest != (std::endian::native == std::endian::little)) order = reversed(order);
    return true;
}

}  // namespace terrazzo::gl
