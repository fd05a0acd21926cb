// Stage: client side, loading a GL library.
// Input: the path of a libOSMesa. Output: the GL 1.0-1.5 function table and the OSMesa functions of that
// library. Invariant: one process loads one library; two of them share symbols (libglapi, LLVM) and global
// state, which is why comparisons run each library in its own child (child.h).
#pragma once

#include <string>
#include <vector>

#include "gl_table.h"
// osmesa.h declares its functions in terms of gl.h's macros.
#include <GL/osmesa.h>

namespace terrazzo::kit {

struct Osmesa {
    decltype(&::OSMesaCreateContext) CreateContext;
    decltype(&::OSMesaCreateContextExt) CreateContextExt;
    decltype(&::OSMesaCreateContextAttribs) CreateContextAttribs;
    decltype(&::OSMesaDestroyContext) DestroyContext;
    decltype(&::OSMesaMakeCurrent) MakeCurrent;
    decltype(&::OSMesaGetCurrentContext) GetCurrentContext;
    decltype(&::OSMesaPixelStore) PixelStore;
    decltype(&::OSMesaGetIntegerv) GetIntegerv;
    decltype(&::OSMesaGetDepthBuffer) GetDepthBuffer;
    decltype(&::OSMesaGetColorBuffer) GetColorBuffer;
    decltype(&::OSMesaGetProcAddress) GetProcAddress;
    decltype(&::OSMesaColorClamp) ColorClamp;
    decltype(&::OSMesaPostprocess) Postprocess;
};

// Stays loaded until the process ends: drivers keep threads and exit handlers that outlive a dlclose.
class Library {
  public:
    // Throws std::runtime_error when the file cannot be loaded or lacks an OSMesa function.
    explicit Library(const std::string& path);

    Gl gl{};
    Osmesa osmesa{};
    // GL commands that the library does not export; their members of `gl` are null.
    std::vector<std::string> missing;

    bool exports(const char* symbol) const;

  private:
    void* m_handle;
};

}  // namespace terrazzo::kit
