// The numbers of GLX's errors and requests, which X errors name.
#pragma once

#include <GL/glx.h>

#include <X11/Xmd.h>

#include <GL/glxmd.h>

#include <GL/glxproto.h>
