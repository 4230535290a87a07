// epoxy asks GLX or EGL which context is current, and neither knows one of OSMesa. So the pointers
// behind epoxy's function names are overwritten while an OSMesa context is current.

#include <dlfcn.h>
#include <epoxy/gl.h>
// After epoxy, which supplies the GL types.
#include <GL/osmesa.h>

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/error.h"
#include "render/gl/offscreen_context.h"

namespace chartflood::gl {

namespace {

struct Slot {
  const char* name;
  void** pointer;
};

const Slot kSlots[] = {
#define X(function) {#function, reinterpret_cast<void**>(&epoxy_##function)},
#include "gl_names.inc"
#undef X
};

/// The functions of the library, loaded once and kept for the life of the process.
struct Library {
  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
  bool complete() const { return create && destroy && makeCurrent && getProcAddress; }
};

template <typename Function>
void loadFunction(void* handle, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(handle, name));
}

Library loadLibrary() {
  Library library;
  void* handle = nullptr;
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
    handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle) break;
  }
  if (!handle) return library;
  loadFunction(handle, "OSMesaCreateContextAttribs", library.create);
  loadFunction(handle, "OSMesaDestroyContext", library.destroy);
  loadFunction(handle, "OSMesaMakeCurrent", library.makeCurrent);
  loadFunction(handle, "OSMesaGetProcAddress", library.getProcAddress);
  return library;
}

const Library& library() {
  static const Library loaded = loadLibrary();
  return loaded;
}

class OsmesaContext final : public Context {
 public:
  OsmesaContext() {
    if (!library().complete()) {
      throw Error("The library OSMesa was not found; install the package libosmesa6.");
    }
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = library().create(attributes, nullptr);
    if (!context_) throw Error("OSMesa gave no OpenGL 3.3 core context.");
  }
  ~OsmesaContext() override {
    if (current_) release();
    library().destroy(context_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void makeCurrent() override {
    if (current_) return;
    if (!library().makeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
      throw Error("The OSMesa context could not be made current.");
    }
    saved_.clear();
    for (const Slot& slot : kSlots) {
      saved_.push_back(*slot.pointer);
      if (const auto function = library().getProcAddress(slot.name)) {
        *slot.pointer = reinterpret_cast<void*>(function);
      }
    }
    current_ = true;
  }

  void release() override {
    if (!current_) return;
    for (std::size_t i = 0; i < saved_.size(); ++i) *kSlots[i].pointer = saved_[i];
    library().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    current_ = false;
  }

  const char* backend() const override { return "osmesa"; }

 private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> pixel_{};  // a surface to be current on; nothing is drawn there
  std::vector<void*> saved_;
  bool current_ = false;
};

}  // namespace

std::unique_ptr<Context> createOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace chartflood::gl
