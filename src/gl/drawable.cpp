// Which pixels stand for which buffer of a drawable. A double-buffered one begins with its back buffer alone:
// most programs never touch the front.
#include "gl/drawable.h"

namespace terrazzo::gl {

void Drawable::allocate(int width, int height, const raster::TargetFormat& format) {
    if (m_target && m_target->width() == width && m_target->height() == height &&
        m_target->format() == format)
        return;
    m_target = std::make_shared<raster::Target>(width, height, format);
    m_has_front = false;
    m_selected = is_double_buffered() ? ColorBuffer::kBack : ColorBuffer::kFront;
}

void Drawable::select(ColorBuffer buffer) {
    if (!is_double_buffered() || !m_target || buffer == m_selected) return;
    m_target->exchange_color();
    m_selected = buffer;
    if (buffer == ColorBuffer::kFront && !m_has_front) {
        m_has_front = true;
        load_front();
    }
}

void Drawable::swap_pixels() {
    if (!is_double_buffered() || !m_target || !m_has_front) return;
    m_target->exchange_color();
}

}  // namespace terrazzo::gl
