#include "app/cli/side_by_side.h"

#include <algorithm>

#include "app/cli/picture.h"
#include "core/base/error.h"
#include "render/eye.h"
#include "render/gl/offscreen_context.h"
#include "render/offscreen_render.h"
#include "render/overlay.h"
#include "render/texture_units.h"

namespace chartflood {

namespace {

constexpr float kLineHeight = 1.5f;  // ems
constexpr int kNarrowest = 64;       // pixels

/// Sizes in pixels.
struct Columns {
  int width = 0;
  float em = 0;
  int strip = 0;  ///< height of the captions
};

Columns columnsOf(const PictureOptions& options, std::size_t count) {
  Columns columns;
  columns.width = options.width / static_cast<int>(count);
  columns.em = std::max(8.0f, static_cast<float>(columns.width) / 26);
  columns.strip = static_cast<int>(columns.em * kLineHeight * (kCaptionLines + 0.4f));
  return columns;
}

/// Lines of text on a plain ground.
Image captionImage(const std::vector<std::string>& lines, int width, int height, float em,
                   const std::string& backend) {
  const auto context = gl::createOffscreenContext(gl::offscreenBackendFromId(backend));
  const gl::CurrentScope current(*context);
  const gl::Framebuffer target(width, height, 1);
  target.bindForDrawing();
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  Overlay overlay;
  const glm::vec2 size(width, height);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    TextStyle style;
    style.size = i == 0 ? 1.15f * em : em;
    style.color = {0.1f, 0.1f, 0.12f, 1};
    style.halo = {1, 1, 1, 0};
    const float y = em * kLineHeight * (static_cast<float>(i) + 0.7f);
    overlay.text({size.x / 2, y}, lines[i], style, TextAlign::Center);
  }
  overlay.draw(size, tileOf({width, height, 0, 0, width, height}), units::kColorMap, 0);
  return readFramebuffer(target);
}

void copyInto(const Image& from, int left, int top, Image& to) {
  for (int y = 0; y < from.height(); ++y) {
    std::copy_n(&from.at(0, y), from.width(), &to.at(left, top + y));
  }
}

}  // namespace

void checkColumns(const PictureOptions& options, std::size_t columns) {
  const Columns c = columnsOf(options, columns);
  if (c.width >= kNarrowest && options.height - c.strip >= kNarrowest) return;
  throw UsageError("--resolution is too small for " + std::to_string(columns) +
                   " pictures side by side: give a larger one.");
}

Image drawSideBySide(std::span<const std::shared_ptr<const Results>> results,
                     std::span<const std::vector<std::string>> captions,
                     const PictureOptions& options, const std::string& backend) {
  checkColumns(options, results.size());
  const Columns columns = columnsOf(options, results.size());
  PictureOptions column = options;
  column.width = columns.width;
  column.height = options.height - columns.strip;
  Image image(options.width, options.height, {255, 255, 255, 255});
  for (std::size_t i = 0; i < results.size(); ++i) {
    const int left = static_cast<int>(i) * column.width;
    copyInto(drawPicture(*results[i], column, backend), left, 0, image);
    copyInto(captionImage(captions[i], column.width, columns.strip, columns.em, backend), left,
             column.height, image);
  }
  return image;
}

}  // namespace chartflood
