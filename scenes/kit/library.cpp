// Stage: client side, loading a GL library. Input: a path. Output: filled function tables.
// Uses dlsym, as programs linked with -lOSMesa do; OSMesaGetProcAddress is one more function to test, and for
// what is not exported.
#include "library.h"

#include <dlfcn.h>

#include <cstring>
#include <stdexcept>

namespace terrazzo::kit {
namespace {

template <typename Function>
void load(void* handle, const char* name, Function& function) {
    void* address = dlsym(handle, name);
    if (!address) throw std::runtime_error(std::string("the library does not export ") + name);
    std::memcpy(&function, &address, sizeof address);
}

void* open_library(const std::string& path) {
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle) throw std::runtime_error(dlerror());
    return handle;
}

}  // namespace

Library::Library(const std::string& path) : m_handle(open_library(path)) {
    load(m_handle, "OSMesaCreateContext", osmesa.CreateContext);
    load(m_handle, "OSMesaCreateContextExt", osmesa.CreateContextExt);
    load(m_handle, "OSMesaCreateContextAttribs", osmesa.CreateContextAttribs);
    load(m_handle, "OSMesaDestroyContext", osmesa.DestroyContext);
    load(m_handle, "OSMesaMakeCurrent", osmesa.MakeCurrent);
    load(m_handle, "OSMesaGetCurrentContext", osmesa.GetCurrentContext);
    load(m_handle, "OSMesaPixelStore", osmesa.PixelStore);
    load(m_handle, "OSMesaGetIntegerv", osmesa.GetIntegerv);
    load(m_handle, "OSMesaGetDepthBuffer", osmesa.GetDepthBuffer);
    load(m_handle, "OSMesaGetColorBuffer", osmesa.GetColorBuffer);
    load(m_handle, "OSMesaGetProcAddress", osmesa.GetProcAddress);
    load(m_handle, "OSMesaColorClamp", osmesa.ColorClamp);
    load(m_handle, "OSMesaPostprocess", osmesa.Postprocess);
    for (const GlCommand& command : kGlCommands) {
        void* address = dlsym(m_handle, command.name);
        // Mesa's library does not export the commands of every extension.
        if (!address) address = reinterpret_cast<void*>(osmesa.GetProcAddress(command.name));
        if (!address) missing.emplace_back(command.name);
        std::memcpy(reinterpret_cast<char*>(&gl) + command.offset, &address, sizeof address);
    }
}

bool Library::exports(const char* symbol) const {
    return dlsym(m_handle, symbol) != nullptr;
}

}  // namespace terrazzo::kit
