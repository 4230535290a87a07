#pragma once
/// A GL 3.3 core context that can be made current and let go again.

namespace chartflood::gl {

/// Whoever switches contexts releases the old one before making another current: neither EGL nor
/// GLX notices otherwise that calls go elsewhere. A context lives on the thread that made it.
class Context {
 public:
  virtual ~Context() = default;
  /// Directs GL calls of this thread here. Cheap when it is current already.
  /// \throws Error when the system refuses.
  virtual void makeCurrent() = 0;
  /// Lets go of the context; no GL call may follow until one is current again.
  virtual void release() = 0;
  /// "osmesa", "egl" or "window".
  virtual const char* backend() const = 0;
};

/// Makes a context current for a scope.
class CurrentScope {
 public:
  explicit CurrentScope(Context& context) : context_(context) { context_.makeCurrent(); }
  ~CurrentScope() { context_.release(); }
  CurrentScope(const CurrentScope&) = delete;
  CurrentScope& operator=(const CurrentScope&) = delete;

 private:
  Context& context_;
};

}  // namespace chartflood::gl
