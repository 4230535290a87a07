#pragma once
/// Pictures of any size from the renderer, as the window draws them.

#include "render/gl/framebuffer.h"
#include "render/passes/renderer.h"
#include "render/scene/camera.h"
#include "render/scene/image.h"
#include "render/scene/render_settings.h"

namespace chartflood {

struct PictureSize {
  int width = 1920, height = 1080;
  /// 1, 2 or 4: drawn so many times larger and averaged.
  int supersampling = 1;
  /// Samples a pixel (clamped to the driver's); 1 for measuring.
  int samples = 4;
  /// Pictures larger than this are drawn in parts: software drivers take some 40 bytes for each of
  /// their pixels.
  int largestPart = 1024;
};

/// Draws one picture; line widths and letters keep their size in its pixels for any supersampling.
/// \throws UsageError when the size or the supersampling cannot be, Interrupted; so do those below
Image renderImage(Renderer& renderer, const Camera& camera, const RenderSettings& settings,
                  const PictureSize& size);

/// The same of the texture. UvCamera::exact() in a square picture without `style.frame` gives what
/// lies over a texture image pixel by pixel.
Image renderUvImage(Renderer& renderer, const UvCamera& camera, const RenderSettings& settings,
                    const UvStyle& style, const PictureSize& size);

/// Widths of the model's and the texture's part of a picture that shows both side by side: a square
/// for the texture where there is room for one, else half of the width for each. A camera that
/// shall show the whole model is framed with the aspect widths.scene / size.height.
struct BothWidths {
  int scene = 0, uv = 0;
};
BothWidths widthsOfBoth(const PictureSize& size);

/// Model on the left, texture on the right; the scalar bar stands with the model.
Image renderBothImage(Renderer& renderer, const Camera& camera, const UvCamera& uvCamera,
                      const RenderSettings& settings, const UvStyle& style,
                      const PictureSize& size);

/// Reads a drawn framebuffer back with straight alpha, rows from the top.
Image readFramebuffer(const gl::Framebuffer& framebuffer);

}  // namespace chartflood
