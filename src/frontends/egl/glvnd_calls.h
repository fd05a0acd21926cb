// Calls of EGL extensions in a process where several vendors may share the work (libglvnd's vendor ABI).
#pragma once

#include <EGL/egl.h>
#include <glvnd/libeglabi.h>

namespace terrazzo::egl {

// libglvnd's functions; set once, before any stub can be called.
extern const __EGLapiExports* glvnd;

// What the first argument is, from which libglvnd knows the vendor.
enum class Owner { kDisplay, kDevice };

template <auto kFunction, Owner kOwner>
struct VendorCall;

template <typename Result, typename First, typename... Rest, Result (*kFunction)(First, Rest...),
          Owner kOwner>
struct VendorCall<kFunction, kOwner> {
    static inline int index = -1;

    static Result call(First owner, Rest... rest) {
        glvnd->threadInit();
        __EGLvendorInfo* const vendor = kOwner == Owner::kDisplay ? glvnd->getVendorFromDisplay(owner)
                                                                  : glvnd->getVendorFromDevice(owner);
        constexpr EGLint kNobodys = kOwner == Owner::kDisplay ? EGL_BAD_DISPLAY : EGL_BAD_DEVICE_EXT;
        if (!vendor) {
            glvnd->setEGLError(kNobodys);
            return Result();
        }
        glvnd->setLastVendor(vendor);
        const auto function =
            reinterpret_cast<Result (*)(First, Rest...)>(glvnd->fetchDispatchEntry(vendor, index));
        if (function) return function(owner, rest...);
        glvnd->setEGLError(kNobodys);
        return Result();
    }
};

}  // namespace terrazzo::egl
