// glXUseXFont: an X font's characters as display lists of bitmaps (GLX 1.4 §3.4).
//
// The server draws each character into a one-bit pixmap, which is read back. Only its ink is kept: the
// bitmap's origin and advance are those of the character's metrics.
#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "frontends/glx/display.h"
#include "frontends/glx/own_pixels.h"
#include "frontends/glx/protocol.h"

namespace glx = terrazzo::glx;

namespace {

struct FreeFont {
    void operator()(XFontStruct* font) const { XFreeFontInfo(nullptr, font, 1); }
};
struct FreeImage {
    void operator()(XImage* image) const { XDestroyImage(image); }
};

// What the font says of a character; all zero for one that it does not have.
XCharStruct metrics(const XFontStruct& font, unsigned code) {
    const unsigned row = code >> 8, column = code & 0xff;
    const bool there = row >= font.min_byte1 && row <= font.max_byte1 && column >= font.min_char_or_byte2 &&
                       column <= font.max_char_or_byte2;
    if (!there) return {};
    if (!font.per_char) return font.max_bounds;
    const unsigned columns = font.max_char_or_byte2 - font.min_char_or_byte2 + 1;
    return font.per_char[(row - font.min_byte1) * columns + column - font.min_char_or_byte2];
}

class FontReader {
  public:
    FontReader(Display* display, const XFontStruct& font, Font id) : m_display(display) {
        m_width = std::max(font.max_bounds.rbearing - std::min<int>(font.min_bounds.lbearing, 0), 1);
        m_height = std::max(font.max_bounds.ascent + font.max_bounds.descent, 1);
        m_pixmap = XCreatePixmap(display, DefaultRootWindow(display), static_cast<unsigned>(m_width),
                                 static_cast<unsigned>(m_height), 1);
        XGCValues values{};
        values.font = id;
        values.foreground = 1;
        values.background = 0;
        m_gc = XCreateGC(display, m_pixmap, GCFont | GCForeground | GCBackground, &values);
    }
    ~FontReader() {
        XFreeGC(m_display, m_gc);
        XFreePixmap(m_display, m_pixmap);
    }
    FontReader(const FontReader&) = delete;
    FontReader& operator=(const FontReader&) = delete;

    // The character's ink, bottom row first, most significant bit leftmost, rows of whole bytes.
    std::vector<std::uint8_t> read(unsigned code, const XCharStruct& metrics) {
        const int width = metrics.rbearing - metrics.lbearing, height = metrics.ascent + metrics.descent;
        XSetForeground(m_display, m_gc, 0);
        XFillRectangle(m_display, m_pixmap, m_gc, 0, 0, static_cast<unsigned>(m_width),
                       static_cast<unsigned>(m_height));
        XSetForeground(m_display, m_gc, 1);
        const XChar2b character{static_cast<unsigned char>(code >> 8), static_cast<unsigned char>(code)};
        XDrawString16(m_display, m_pixmap, m_gc, -metrics.lbearing, metrics.ascent, &character, 1);
        const std::unique_ptr<XImage, FreeImage> image(
            XGetImage(m_display, m_pixmap, 0, 0, static_cast<unsigned>(std::min(width, m_width)),
                      static_cast<unsigned>(std::min(height, m_height)), 1, XYPixmap));
        const int row_bytes = (width + 7) / 8;
        std::vector<std::uint8_t> bits(static_cast<std::size_t>(row_bytes * height));
        for (int y = 0; image && y < image->height; ++y) {
            for (int x = 0; x < image->width; ++x) {
                if (XGetPixel(image.get(), x, y))
                    bits[static_cast<std::size_t>((height - 1 - y) * row_bytes + x / 8)] |=
                        static_cast<std::uint8_t>(0x80 >> x % 8);
            }
        }
        return bits;
    }

  private:
    Display* m_display;
    int m_width, m_height;
    Pixmap m_pixmap;
    GC m_gc;
};

void define_list(FontReader& reader, unsigned code, const XCharStruct& metrics, GLuint list) {
    const int width = metrics.rbearing - metrics.lbearing, height = metrics.ascent + metrics.descent;
    glNewList(list, GL_COMPILE);
    if (width > 0 && height > 0) {
        const auto bits = reader.read(code, metrics);
        glBitmap(width, height, static_cast<GLfloat>(-metrics.lbearing),
                 static_cast<GLfloat>(metrics.descent), metrics.width, 0, bits.data());
    } else {
        glBitmap(0, 0, 0, 0, metrics.width, 0, nullptr);
    }
    glEndList();
}

}  // namespace

void glXUseXFont(Font font, int first, int count, int list_base) try {
    const auto context = glx::current_context();
    Display* const display = context ? context->display->display.load() : nullptr;
    if (!display || count <= 0) return;
    const std::unique_ptr<XFontStruct, FreeFont> known(XQueryFont(display, font));
    if (!known) return glx::send_error(display, BadFont, false, font, X_GLXUseXFont);
    FontReader reader(display, *known, font);
    const glx::OwnPixels own(*context->gl);
    for (int i = 0; i < count; ++i) {
        const auto code = static_cast<unsigned>(first + i);
        define_list(reader, code, metrics(*known, code), static_cast<GLuint>(list_base + i));
    }
} catch (const std::bad_alloc&) {
    if (const auto context = glx::current_context(); context && context->display->display)
        glx::send_error(context->display->display, BadAlloc, false, font, X_GLXUseXFont);
}
