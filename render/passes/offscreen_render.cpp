#include "render/passes/offscreen_render.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/base/interruption.h"

namespace chartflood {

namespace {

constexpr int kLargestSide = 16384;

/// Colour over alpha, rounded; the GL picture carries colour times alpha.
Rgba8 straight(const Rgba8& p) {
  if (p[3] == 255) return p;
  if (p[3] == 0) return {0, 0, 0, 0};
  const unsigned alpha = p[3];
  const auto divide = [&](unsigned c) {
    return static_cast<std::uint8_t>(std::min(255u, (c * 255u + alpha / 2) / alpha));
  };
  return {divide(p[0]), divide(p[1]), divide(p[2]), p[3]};
}

void checkSize(const PictureSize& size) {
  if (size.supersampling != 1 && size.supersampling != 2 && size.supersampling != 4) {
    throw UsageError("The supersampling must be 1, 2 or 4.");
  }
  if (size.width < 1 || size.height < 1 || size.width > kLargestSide ||
      size.height > kLargestSide) {
    throw UsageError("A picture must be between 1 and 16384 pixels wide and high.");
  }
}

}  // namespace

Image readFramebuffer(const gl::Framebuffer& framebuffer) {
  const gl::FramebufferScope keep;
  framebuffer.resolve();
  const int width = framebuffer.width(), height = framebuffer.height();
  std::vector<Rgba8> rows(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    const auto row = rows.begin() + std::ptrdiff_t{height - 1 - y} * width;
    std::transform(row, row + width, &image.at(0, y), straight);
  }
  return image;
}

namespace {

/// The length of equal parts of `whole`, none above `most`; the last may be shorter.
int evenPart(int whole, int most) {
  const int count = (whole + most - 1) / most;
  return (whole + count - 1) / count;
}

/// Puts a picture together from parts that `draw` draws into framebuffers of their size, with
/// widths and letters as large as the supersampling asks for.
template <typename Draw>
Image renderParts(const RenderSettings& settings, const PictureSize& size, Draw&& draw) {
  checkSize(size);
  const int factor = size.supersampling;
  RenderSettings larger = settings;
  larger.pixelScale *= static_cast<float>(factor);
  GLint limit = size.largestPart;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  // Whole blocks of the average must lie inside a part.
  const int most = std::max(1, std::min(size.largestPart, limit) / factor);

  // Of one size, as far as that goes, so that one framebuffer serves them all.
  const int mostWidth = evenPart(size.width, most), mostHeight = evenPart(size.height, most);

  Image image(size.width, size.height);
  gl::Framebuffer target;
  for (int top = 0; top < size.height; top += mostHeight) {
    for (int left = 0; left < size.width; left += mostWidth) {
      throwIfInterrupted();
      const int width = std::min(mostWidth, size.width - left);
      const int height = std::min(mostHeight, size.height - top);
      const PicturePart part{size.width * factor, size.height * factor,
                             left * factor,       (size.height - top - height) * factor,
                             width * factor,      height * factor};
      if (target.width() != part.width || target.height() != part.height) {
        target = gl::Framebuffer(part.width, part.height, size.samples);
      }
      draw(target, larger, part);
      const Image drawn = shrinkImage(readFramebuffer(target), factor);
      for (int y = 0; y < height; ++y) {
        std::copy_n(&drawn.at(0, y), width, &image.at(left, top + y));
      }
    }
  }
  return image;
}

void copyInto(const Image& from, int left, Image& to) {
  for (int y = 0; y < from.height(); ++y) {
    std::copy_n(&from.at(0, y), from.width(), &to.at(left, y));
  }
}

}  // namespace

Image renderImage(Renderer& renderer, const Camera& camera, const RenderSettings& settings,
                  const PictureSize& size) {
  return renderParts(settings, size,
                     [&](const gl::Framebuffer& target, const RenderSettings& larger,
                         const PicturePart& part) { renderer.draw(target, camera, larger, part); });
}

Image renderUvImage(Renderer& renderer, const UvCamera& camera, const RenderSettings& settings,
                    const UvStyle& style, const PictureSize& size) {
  return renderParts(
      settings, size,
      [&](const gl::Framebuffer& target, const RenderSettings& larger, const PicturePart& part) {
        renderer.drawUv(target, camera, larger, style, part);
      });
}

BothWidths widthsOfBoth(const PictureSize& size) {
  const int uv = std::max(1, std::min(size.height, size.width / 2));
  return {std::max(1, size.width - uv), uv};
}

Image renderBothImage(Renderer& renderer, const Camera& camera, const UvCamera& uvCamera,
                      const RenderSettings& settings, const UvStyle& style,
                      const PictureSize& size) {
  checkSize(size);
  const BothWidths widths = widthsOfBoth(size);
  PictureSize part = size;
  Image image(size.width, size.height);
  part.width = widths.scene;
  copyInto(renderImage(renderer, camera, settings, part), 0, image);
  if (widths.scene + widths.uv > size.width) return image;  // one pixel wide
  RenderSettings withoutBar = settings;
  withoutBar.scalarBar = false;
  part.width = widths.uv;
  copyInto(renderUvImage(renderer, uvCamera, withoutBar, style, part), widths.scene, image);
  return image;
}

}  // namespace chartflood
