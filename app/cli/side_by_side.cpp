#include "app/cli/side_by_side.h"

#include <algorithm>

#include "app/cli/picture.h"
#include "core/base/error.h"
#include "render/gl/offscreen_context.h"
#include "render/passes/offscreen_render.h"
#include "render/passes/overlay.h"
#include "render/passes/texture_units.h"
#include "render/scene/eye.h"

namespace chartflood {

namespace {

constexpr float kLineHeight = 1.5f;  // ems
constexpr int kNarrowest = 64;       // pixels

/// Sizes in pixels.
struct Grid {
  int width = 0, height = 0;  ///< of one picture
  float em = 0;
  int strip = 0;  ///< height of the captions
};

Grid gridOf(const Invocation& call) {
  const int rows = std::max(1, static_cast<int>(call.compareRows.size()));
  Grid grid;
  grid.width = call.picture.width / static_cast<int>(call.compare.size());
  grid.em = std::max(8.0f, static_cast<float>(grid.width) / 26);
  grid.strip = static_cast<int>(grid.em * kLineHeight * (kCaptionLines + 0.4f));
  grid.height = (call.picture.height - grid.strip) / rows;
  return grid;
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

void checkGrid(const Invocation& call) {
  const Grid grid = gridOf(call);
  if (grid.width >= kNarrowest && grid.height >= kNarrowest) return;
  const std::size_t pictures =
      call.compare.size() * std::max<std::size_t>(1, call.compareRows.size());
  throw UsageError("--resolution is too small for " + std::to_string(pictures) +
                   " pictures side by side: give a larger one.");
}

Image drawSideBySide(std::span<const std::shared_ptr<const Results>> results,
                     std::span<const std::vector<std::string>> captions, const Invocation& call) {
  checkGrid(call);
  const Grid grid = gridOf(call);
  std::vector<ColorMode> rows = call.compareRows;
  if (rows.empty()) rows.push_back(call.picture.settings.colorMode);
  PictureOptions one = call.picture;
  one.width = grid.width;
  one.height = grid.height;
  Image image(call.picture.width, call.picture.height, {255, 255, 255, 255});
  for (std::size_t i = 0; i < results.size(); ++i) {
    const int left = static_cast<int>(i) * grid.width;
    int top = 0;
    for (const ColorMode mode : rows) {
      one.settings.colorMode = mode;
      copyInto(drawPicture(*results[i], one, call.renderingBackend), left, top, image);
      top += grid.height;
    }
    copyInto(captionImage(captions[i], grid.width, grid.strip, grid.em, call.renderingBackend),
             left, top, image);
  }
  return image;
}

}  // namespace chartflood
