#pragma once
/// Pictures of any size from the renderer, as the window draws them.

#include "render/camera.h"
#include "render/gl/framebuffer.h"
#include "render/image.h"
#include "render/render_settings.h"
#include "render/renderer.h"

namespace chartflood {

struct PictureSize {
  int width = 1920, height = 1080;
  /// 1, 2 or 4: drawn so many times larger and averaged.
  int supersampling = 1;
  /// Samples a pixel (clamped to the driver's); 1 for measuring.
  int samples = 4;
  /// Pictures larger than this are drawn in parts.
  int largestPart = 2048;
};

/// Draws one picture; line widths and letters keep their size in its pixels for any supersampling.
/// \throws UsageError when the size or the supersampling cannot be.
Image renderImage(Renderer& renderer, const Camera& camera, const RenderSettings& settings,
                  const PictureSize& size);

/// Reads a drawn framebuffer back with straight alpha, rows from the top.
Image readFramebuffer(const gl::Framebuffer& framebuffer);

}  // namespace chartflood
