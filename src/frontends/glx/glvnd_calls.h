// Calls of GLX extensions in a process where several vendors may share the work (libglvnd's vendor ABI).
//
// libglvnd knows the functions of GLX 1.4. For an extension's function it asks a vendor for a stub that finds
// out from the arguments which vendor is meant (it may be another than us) and calls that vendor's function.
#pragma once

#include <GL/glx.h>
#include <glvnd/libglxabi.h>

namespace terrazzo::glx {

// libglvnd's functions; set once, before any stub can be called.
extern const __GLXapiExports* glvnd;

// What among the arguments tells the vendor.
enum class Owner { kScreen, kDrawable, kConfig, kContext, kVisual, kCurrent };

// What the function makes, which libglvnd has to be told.
enum class Makes { kNothing, kContext, kDrawable };

template <Owner kOwner, typename First, typename Second, typename... Rest>
__GLXvendorInfo* find_vendor(First display, Second second, Rest...) {
    if constexpr (kOwner == Owner::kScreen) return glvnd->getDynDispatch(display, second);
    if constexpr (kOwner == Owner::kDrawable) return glvnd->vendorFromDrawable(display, second);
    if constexpr (kOwner == Owner::kConfig) return glvnd->vendorFromFBConfig(display, second);
    if constexpr (kOwner == Owner::kContext) return glvnd->vendorFromContext(second);
    if constexpr (kOwner == Owner::kVisual)
        return second ? glvnd->getDynDispatch(display, second->screen) : nullptr;
    return glvnd->getCurrentDynDispatch();
}

template <Owner kOwner, typename... Only>
__GLXvendorInfo* find_vendor(Only... only) {
    if constexpr (kOwner == Owner::kContext) return glvnd->vendorFromContext(only...);
    return glvnd->getCurrentDynDispatch();
}

template <Makes kMakes, typename Made, typename... Rest>
void remember(__GLXvendorInfo* vendor, Made made, Display* display, Rest...) {
    if (!made) return;
    if constexpr (kMakes == Makes::kContext) glvnd->addVendorContextMapping(display, made, vendor);
    if constexpr (kMakes == Makes::kDrawable) glvnd->addVendorDrawableMapping(display, made, vendor);
}

template <auto kFunction, Owner kOwner, Makes kMakes>
struct VendorCall;

template <typename Result, typename... Arguments, Result (*kFunction)(Arguments...), Owner kOwner,
          Makes kMakes>
struct VendorCall<kFunction, kOwner, kMakes> {
    static inline int index = -1;

    static Result call(Arguments... arguments) {
        __GLXvendorInfo* const vendor = find_vendor<kOwner>(arguments...);
        const auto function =
            vendor ? reinterpret_cast<Result (*)(Arguments...)>(glvnd->fetchDispatchEntry(vendor, index))
                   : nullptr;
        if (!function) return Result();
        if constexpr (kMakes == Makes::kNothing) {
            return function(arguments...);
        } else {
            const Result made = function(arguments...);
            remember<kMakes>(vendor, made, arguments...);
            return made;
        }
    }
};

}  // namespace terrazzo::glx
