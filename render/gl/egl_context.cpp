#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <iterator>
#include <span>
#include <string_view>

#include "core/base/error.h"
#include "render/gl/offscreen_context.h"

namespace chartflood::gl {

namespace {

/// A graphics card that draws without a display: the first of the system's that can be opened
/// (their drivers know this way only). EGL_NO_DISPLAY where there is none; software devices do not
/// count.
EGLDisplay openCard() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_query") ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    return EGL_NO_DISPLAY;
  }
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (!eglQueryDevicesEXT(std::size(devices), devices, &count)) return EGL_NO_DISPLAY;
  for (const EGLDeviceEXT device : std::span(devices, static_cast<std::size_t>(count))) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    if (extensions != nullptr &&
        std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos) {
      continue;
    }
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  return EGL_NO_DISPLAY;
}

EGLDisplay openSoftware() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    throw Error("EGL cannot draw without a display here: it finds no graphics card, and "
                "EGL_MESA_platform_surfaceless is missing.");
  }
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    throw Error("EGL could not be started; install the packages libegl-mesa0 and libgl1-mesa-dri.");
  }
  return display;
}

/// The display is opened once and never closed: closing unloads the driver under other contexts.
EGLDisplay openDisplay() {
  if (!epoxy_has_egl()) throw Error("The library EGL was not found; install the package libegl1.");
  const EGLDisplay card = openCard();
  return card != EGL_NO_DISPLAY ? card : openSoftware();
}

EGLDisplay display() {
  static const EGLDisplay opened = openDisplay();
  return opened;
}

class EglContext final : public Context {
 public:
  EglContext() {
    const EGLint configAttributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                       EGL_PBUFFER_BIT, EGL_NONE};
    const EGLint contextAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                        3,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        3,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) ||
        !eglChooseConfig(display(), configAttributes, &config, 1, &count) || count == 0) {
      throw Error("EGL offers no OpenGL here.");
    }
    context_ = eglCreateContext(display(), config, EGL_NO_CONTEXT, contextAttributes);
    if (context_ == EGL_NO_CONTEXT) throw Error("EGL gave no OpenGL 3.3 core context.");
  }
  ~EglContext() override {
    if (current_) release();
    eglDestroyContext(display(), context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void makeCurrent() override {
    if (current_) return;
    if (!eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      throw Error("The EGL context could not be made current; another one was not released.");
    }
    current_ = true;
  }
  void release() override {
    if (!current_) return;
    eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    current_ = false;
  }
  const char* backend() const override { return "egl"; }

 private:
  EGLContext context_ = EGL_NO_CONTEXT;
  bool current_ = false;
};

}  // namespace

std::unique_ptr<Context> createEglContext() { return std::make_unique<EglContext>(); }

}  // namespace chartflood::gl
