// An X window for tests of GLX and EGL, and what is on the screen in it.
#pragma once

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#undef None
#undef Bool
#undef Status
#undef Success

#include <array>
#include <cstdint>

namespace terrazzo::test {

using Pixel = std::array<int, 3>;  // red, green, blue: 0-255

class XWindow {
  public:
    // A mapped window at (0, 0) with this visual; waits until it is on the screen.
    XWindow(Display* display, const XVisualInfo& visual, int width, int height) : m_display(display) {
        XSetWindowAttributes attributes{};
        attributes.colormap = XCreateColormap(display, RootWindow(display, visual.screen), visual.visual, AllocNone);
        attributes.event_mask = StructureNotifyMask;
        attributes.override_redirect = 1;
        m_window = XCreateWindow(display, RootWindow(display, visual.screen), 0, 0, static_cast<unsigned>(width),
                                 static_cast<unsigned>(height), 0, visual.depth, InputOutput, visual.visual,
                                 CWColormap | CWEventMask | CWBorderPixel | CWOverrideRedirect, &attributes);
        m_colormap = attributes.colormap;
        XMapWindow(display, m_window);
        wait_for(MapNotify);
    }
    ~XWindow() {
        if (!m_display) return;
        XDestroyWindow(m_display, m_window);
        XFreeColormap(m_display, m_colormap);
        XSync(m_display, 0);
    }
    XWindow(const XWindow&) = delete;
    XWindow& operator=(const XWindow&) = delete;

    Window id() const { return m_window; }
    // The display is closed: its window is gone with it.
    void forget() { m_display = nullptr; }

    void resize(int width, int height) {
        XResizeWindow(m_display, m_window, static_cast<unsigned>(width), static_cast<unsigned>(height));
        wait_for(ConfigureNotify);
    }

    // What the server has there, (0, 0) at the top left.
    Pixel pixel(int x, int y) const {
        XSync(m_display, 0);
        XImage* const image = XGetImage(m_display, m_window, x, y, 1, 1, ~0ul, ZPixmap);
        const unsigned long value = XGetPixel(image, 0, 0);
        const auto part = [&](unsigned long mask) {
            const unsigned long lowest = mask & ~(mask - 1);
            return static_cast<int>((value & mask) / lowest * 255 / (mask / lowest));
        };
        const Pixel out{part(image->red_mask), part(image->green_mask), part(image->blue_mask)};
        XDestroyImage(image);
        return out;
    }

  private:
    void wait_for(int type) {
        XEvent event;
        do XWindowEvent(m_display, m_window, StructureNotifyMask, &event);
        while (event.type != type);
    }

    Display* m_display;
    Window m_window;
    Colormap m_colormap;
};

}  // namespace terrazzo::test
