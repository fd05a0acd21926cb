// The numbers of GLX's errors and requests, which X errors name.
#pragma once

// Each of these needs the ones before.
// clang-format off
#include <GL/glx.h>
#include <X11/Xmd.h>
#include <GL/glxmd.h>
#include <GL/glxproto.h>
// clang-format on
