// Fences (EGL 1.5 §3.8.1, EGL_KHR_fence_sync, EGL_KHR_wait_sync) and images, of which there are none.
//
// Drawing is done by the thread that asks for it: a fence has been passed when what was queued before it is
// drawn, which making it sees to.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <exception>

#include "frontends/egl/display.h"
#include "gl/generated/commands.h"

namespace egl = terrazzo::egl;
namespace gl = terrazzo::gl;

namespace {

bool is_sync(egl::Display& display, EGLSync sync) {
    const auto guard = egl::lock();
    return display.syncs.contains(sync);
}

template <class Value>
EGLSync create(EGLDisplay handle, EGLenum type, const Value* attributes, EGLint wrong_type) try {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_NO_SYNC;
    if (type != EGL_SYNC_FENCE) return egl::fail(wrong_type);
    if (attributes && *attributes != EGL_NONE) return egl::fail(EGL_BAD_ATTRIBUTE);
    const auto context = egl::current_context();
    if (!context || context->display != handle) return egl::fail(EGL_BAD_MATCH);
    gl::finish(*context->gl);
    auto sync = std::make_shared<egl::Sync>();
    const auto guard = egl::lock();
    const EGLSync made = sync.get();
    display->syncs.emplace(made, std::move(sync));
    egl::set_error(EGL_SUCCESS);
    return made;
} catch (const std::exception&) {
    return egl::fail(EGL_BAD_ALLOC);
}

template <class Value>
EGLBoolean query(EGLDisplay handle, EGLSync sync, EGLint attribute, Value* value) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    if (!is_sync(*display, sync) || !value) return egl::fail(EGL_BAD_PARAMETER);
    egl::set_error(EGL_SUCCESS);
    switch (attribute) {
        case EGL_SYNC_TYPE:
            *value = EGL_SYNC_FENCE;
            return EGL_TRUE;
        case EGL_SYNC_STATUS:
            *value = EGL_SIGNALED;
            return EGL_TRUE;
        case EGL_SYNC_CONDITION:
            *value = EGL_SYNC_PRIOR_COMMANDS_COMPLETE;
            return EGL_TRUE;
    }
    return egl::fail(EGL_BAD_ATTRIBUTE);
}

}  // namespace

EGLSync eglCreateSync(EGLDisplay display, EGLenum type, const EGLAttrib* attributes) {
    return create(display, type, attributes, EGL_BAD_PARAMETER);
}

EGLSyncKHR eglCreateSyncKHR(EGLDisplay display, EGLenum type, const EGLint* attributes) {
    return create(display, type, attributes, EGL_BAD_ATTRIBUTE);
}

EGLBoolean eglDestroySync(EGLDisplay handle, EGLSync sync) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    const auto guard = egl::lock();
    if (display->syncs.erase(sync) == 0) return egl::fail(EGL_BAD_PARAMETER);
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLBoolean eglDestroySyncKHR(EGLDisplay display, EGLSyncKHR sync) {
    return eglDestroySync(display, sync);
}

EGLint eglClientWaitSync(EGLDisplay handle, EGLSync sync, EGLint, EGLTime) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    if (!is_sync(*display, sync)) return static_cast<EGLBoolean>(egl::fail(EGL_BAD_PARAMETER));
    egl::set_error(EGL_SUCCESS);
    return EGL_CONDITION_SATISFIED;
}

EGLint eglClientWaitSyncKHR(EGLDisplay display, EGLSyncKHR sync, EGLint flags, EGLTimeKHR timeout) {
    return eglClientWaitSync(display, sync, flags, timeout);
}

EGLBoolean eglWaitSync(EGLDisplay handle, EGLSync sync, EGLint flags) {
    egl::Display* const display = egl::initialized_display(handle);
    if (!display) return EGL_FALSE;
    if (!egl::current_context()) return egl::fail(EGL_BAD_MATCH);
    if (!is_sync(*display, sync) || flags != 0) return egl::fail(EGL_BAD_PARAMETER);
    egl::set_error(EGL_SUCCESS);
    return EGL_TRUE;
}

EGLint eglWaitSyncKHR(EGLDisplay display, EGLSyncKHR sync, EGLint flags) {
    return static_cast<EGLint>(eglWaitSync(display, sync, flags));
}

EGLBoolean eglGetSyncAttrib(EGLDisplay display, EGLSync sync, EGLint attribute, EGLAttrib* value) {
    return query(display, sync, attribute, value);
}

EGLBoolean eglGetSyncAttribKHR(EGLDisplay display, EGLSyncKHR sync, EGLint attribute, EGLint* value) {
    return query(display, sync, attribute, value);
}

// No target of EGL 1.5 is ours: they are OpenGL ES's textures and render buffers, whose images another API
// would draw to.
EGLImage eglCreateImage(EGLDisplay handle, EGLContext, EGLenum, EGLClientBuffer, const EGLAttrib*) {
    if (!egl::initialized_display(handle)) return EGL_NO_IMAGE;
    return egl::fail(EGL_BAD_PARAMETER);
}

EGLBoolean eglDestroyImage(EGLDisplay handle, EGLImage) {
    if (!egl::initialized_display(handle)) return EGL_FALSE;
    return egl::fail(EGL_BAD_PARAMETER);
}
