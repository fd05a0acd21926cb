// What the tests of GLX and EGL draw with GL, and read back.
#pragma once

#include <GL/gl.h>

#include "x_window.h"

namespace terrazzo::test {

inline constexpr Pixel kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255}, kBlack{0, 0, 0};

inline void clear_to(const Pixel& color) {
    glClearColor(static_cast<float>(color[0]) / 255.0f, static_cast<float>(color[1]) / 255.0f,
                 static_cast<float>(color[2]) / 255.0f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

inline Pixel read(int x, int y) {
    GLubyte bytes[4] = {};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    return {bytes[0], bytes[1], bytes[2]};
}

// A red triangle over the lower left half of the viewport, on black.
inline void draw_diagonal() {
    clear_to(kBlack);
    glColor3f(1, 0, 0);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(-1, 1);
    glEnd();
}

}  // namespace terrazzo::test
