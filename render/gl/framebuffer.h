#pragma once
/// Where everything is drawn: colour and depth of one size, smoothed by several samples if wished.

#include <cstdint>

#include "render/gl/objects.h"

namespace chartflood::gl {

/// RGBA8 colour with straight alpha, 24-bit depth. Drawing goes to `draw()`, reading and showing to
/// `texture()` after `resolve()`.
class Framebuffer {
 public:
  Framebuffer() = default;
  /// Sizes in pixels, at least 1. `samples` is clamped to what the driver offers; 1 is no
  /// smoothing. \throws Error when the driver refuses the size.
  Framebuffer(int width, int height, int samples);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

  /// Directs drawing here and sets the viewport to the whole.
  void bindForDrawing() const;
  /// Merges the samples into the texture and leaves it bound for reading.
  void resolve() const;
  /// The finished picture, after resolve(): GL_RGBA8, bottom row first, linear filtering.
  GLuint texture() const { return resolvedColor_.id(); }
  /// Number of the last bindForDrawing(); no other framebuffer of the process has the same.
  std::uint32_t drawing() const { return drawing_; }
  /// Name of the object that is drawn into.
  GLuint drawId() const { return draw_.id(); }

 private:
  int width_ = 0, height_ = 0, samples_ = 1;
  mutable bool merged_ = false;  ///< nothing was drawn since the samples were merged
  mutable std::uint32_t drawing_ = 0;
  FramebufferObject draw_, resolved_;
  Renderbuffer color_, depth_;
  Texture resolvedColor_;
};

/// Keeps the caller's framebuffer and viewport over a scope that draws elsewhere.
class FramebufferScope {
 public:
  FramebufferScope();
  ~FramebufferScope();
  FramebufferScope(const FramebufferScope&) = delete;
  FramebufferScope& operator=(const FramebufferScope&) = delete;

 private:
  GLint draw_ = 0, read_ = 0;
  GLint viewport_[4] = {0, 0, 0, 0};
};

}  // namespace chartflood::gl
