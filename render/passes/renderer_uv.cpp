// Pictures of the texture: the charts laid flat.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "render/passes/renderer.h"
#include "render/passes/renderer_colors.h"
#include "render/passes/texture_units.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

constexpr glm::vec4 kWhite(0.98f, 0.98f, 0.97f, 1);

/// Distance of the grid's lines: round numbers that stand at least 64 pixels apart.
double gridStep(double pixelsPerUnit) {
  double step = 1;
  for (double decade = 1; decade > 1e-7; decade /= 10) {
    for (const double factor : {1.0, 0.5, 0.25}) {
      if (decade * factor * pixelsPerUnit < 64) return step;
      step = decade * factor;
    }
  }
  return step;
}

std::string rulerText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);  // never "-0"
  return text;
}

/// Ink for lines and numbers on a ground, by its lightness.
glm::vec3 inkOn(const Background& background) {
  const bool light = !background.transparent && lightness(background.top) > 55;
  return light ? glm::vec3(0) : glm::vec3(1);
}

}  // namespace

void Renderer::drawUv(const gl::Framebuffer& target, const UvCamera& camera,
                      const RenderSettings& settings, const UvStyle& style) {
  drawUv(target, camera, settings, style, PicturePart::whole(target.width(), target.height()));
}

void Renderer::drawUv(const gl::Framebuffer& target, const UvCamera& camera,
                      const RenderSettings& settings, const UvStyle& style,
                      const PicturePart& part) {
  beginDrawingUv(target, camera, settings, style, part);
  continueDrawing(std::numeric_limits<double>::infinity());
}

void Renderer::beginDrawingUv(const gl::Framebuffer& target, const UvCamera& camera,
                              const RenderSettings& settings, const UvStyle& style,
                              const PicturePart& part) {
  begin({&target, {}, settings, part, true, camera, style});
}

/// All that lies over the charts.
void Renderer::finishUv(const Frame& frame, const Unfinished& picture) {
  const RenderSettings& settings = frame.settings;
  if (uv_) drawUvLines(frame, picture.uvStyle);
  overlay_.clear();
  if (picture.uvStyle.frame) addUvTicks(frame, picture.uvCamera);
  if (uv_ && settings.numbers) addUvNumbers(frame, picture.uvCamera);
  const std::optional<ScalarRange> range = scalarRange(settings);
  if (uv_ && settings.scalarBar && range) addScalarBar(frame, *range);
  overlay_.draw(frame.eye.viewport, frame.eye.tile, units::kColorMap, settings.colorSteps);
}

/// The texture's square on a grid, with numbers at its border. Lines are whole pixels wide.
void Renderer::drawUvGround(const Frame& frame, const UvCamera& camera) {
  const RenderSettings& settings = frame.settings;
  const glm::dvec2 size(frame.eye.viewport);
  const glm::vec3 ink = inkOn(settings.background);
  const float line = std::max(1.0f, std::round(settings.pixelScale));
  const glm::vec2 low = glm::round(glm::vec2(camera.toPixel({0, 1}, size)));
  const glm::vec2 high = glm::round(glm::vec2(camera.toPixel({1, 0}, size)));
  overlay_.clear();
  if (!settings.background.transparent) {
    overlay_.rectangle(low, high - low, glm::vec4(ink, 0.045f));
  }
  const double step = gridStep(camera.pixelsPerUnit(size) / double{settings.pixelScale});
  const glm::dvec2 first = glm::ceil(camera.toUv({0, size.y}, size) / step);
  const glm::dvec2 last = glm::floor(camera.toUv({size.x, 0}, size) / step);
  const glm::vec4 faint(ink, 0.055f), border(ink, 0.5f);
  for (double i = first.x; i <= last.x; ++i) {
    const double x = std::round(camera.toPixel({i * step, 0}, size).x);
    overlay_.rectangle({x, 0}, {line, size.y}, faint);
  }
  for (double i = first.y; i <= last.y; ++i) {
    const double y = std::round(camera.toPixel({0, i * step}, size).y);
    overlay_.rectangle({0, y}, {size.x, line}, faint);
  }
  const glm::vec2 span = high - low;
  overlay_.rectangle(low - line, {span.x + 2 * line, line}, border);
  overlay_.rectangle({low.x - line, high.y}, {span.x + 2 * line, line}, border);
  overlay_.rectangle({low.x - line, low.y}, {line, span.y}, border);
  overlay_.rectangle({high.x, low.y}, {line, span.y}, border);
  overlay_.draw(frame.eye.viewport, frame.eye.tile, units::kColorMap, 0);
}

/// Numbers below and left of the texture's square, or at the picture's border when that is nearer.
void Renderer::addUvTicks(const Frame& frame, const UvCamera& camera) {
  const RenderSettings& settings = frame.settings;
  const glm::dvec2 size(frame.eye.viewport);
  const glm::vec3 ink = inkOn(settings.background);
  TextStyle text;
  text.size = 0.85f * settings.textSize * settings.pixelScale;
  text.color = glm::vec4(ink, 0.75f);
  text.halo = glm::vec4(glm::vec3(1) - ink, settings.background.transparent ? 0.0f : 0.55f);
  const double step = gridStep(camera.pixelsPerUnit(size) / double{settings.pixelScale});
  const glm::dvec2 low = glm::max(camera.toUv({0, size.y}, size), glm::dvec2(0));
  const glm::dvec2 high = glm::min(camera.toUv({size.x, 0}, size), glm::dvec2(1));
  const glm::vec2 corner(camera.toPixel({0, 0}, size));
  const float row =
      std::clamp(corner.y + 1.1f * text.size, text.size, static_cast<float>(size.y) - text.size);
  for (double i = std::ceil(low.y / step - 1e-9); i * step <= high.y + 1e-9; ++i) {
    const auto y = static_cast<float>(camera.toPixel({0, i * step}, size).y);
    const std::string number = rulerText(i * step);
    const float least = overlay_.textWidth(number, text.size) + 0.4f * text.size;
    const float x = std::clamp(corner.x - 0.5f * text.size, least, static_cast<float>(size.x));
    if (y < row - text.size) overlay_.text({x, y}, number, text, TextAlign::Right);
  }
  for (double i = std::ceil(low.x / step - 1e-9); i * step <= high.x + 1e-9; ++i) {
    const auto x = static_cast<float>(camera.toPixel({i * step, 0}, size).x);
    const std::string number = rulerText(i * step);
    const float half = 0.5f * overlay_.textWidth(number, text.size);
    if (x < half || x + half > static_cast<float>(size.x)) continue;  // would be cut off
    overlay_.text({x, row}, number, text, TextAlign::Center);
  }
}

void Renderer::drawUvOutline(const Frame& frame, const SegmentRange& range, float width) {
  drawSegments(frame, range.count, glm::vec2(width + 1.8f), colors::kInk, 0, range.first);
  drawSegments(frame, range.count, glm::vec2(width), kWhite, 0, range.first);
}

void Renderer::drawUvLines(const Frame& frame, const UvStyle& style) {
  const RenderSettings& settings = frame.settings;
  glBindVertexArray(emptyVertexArray_.id());
  lineProgram_.use();
  setEye(lineProgram_, frame.eye);
  setScale(lineProgram_, ScalarRange{}, settings);
  uv_->bindOutlines(units::kValues);
  if (settings.seams && settings.hiddenCharts.empty()) {
    drawUvOutline(frame, {0, uv_->outlineCount()}, style.outlineWidth);
  }
  // Charts that are pointed at or selected get a stronger border.
  const Index hovered = hoveredChart(settings);
  for (Index island = 0; island < uv_->layout().firstTriangle.size(); ++island) {
    const Index chart = charts_->chartOf(uv_->layout().firstTriangle[island]);
    const bool strong =
        chart != kNone && (chart == hovered || holdsChart(settings.selectedCharts, chart));
    const bool hidden = holdsChart(settings.hiddenCharts, chart);
    if (hidden || (!strong && (settings.hiddenCharts.empty() || !settings.seams))) continue;
    drawUvOutline(frame, uv_->outlineOf(island), style.outlineWidth + (strong ? 1.0f : 0.0f));
  }
  if (settings.cuts) {
    uv_->bindCuts(units::kValues);
    drawCuts(frame, uv_->cutTriangle(), style.outlineWidth + 0.6f);
  }
  drawMarkLines(frame);
}

void Renderer::addUvNumbers(const Frame& frame, const UvCamera& camera) {
  const RenderSettings& settings = frame.settings;
  const glm::dvec2 size(frame.eye.viewport);
  const auto unit = static_cast<float>(camera.pixelsPerUnit(size));
  const float largest = 1.15f * settings.textSize * settings.pixelScale;
  TextStyle style;
  style.color = glm::vec4(1);
  style.halo = glm::vec4(0.04f, 0.04f, 0.05f, 0.9f);
  for (const ChartLabel& label : uv_->layout().places) {
    const Index chart = charts_->chartOf(uv_->layout().firstTriangle[label.chart]);
    if (chart == kNone || holdsChart(settings.hiddenCharts, chart)) continue;
    // Numbers of small charts are smaller, down to what can be read.
    style.size = std::min(largest, 1.5f * label.room * unit);
    if (style.size < 0.6f * largest) continue;
    overlay_.text(glm::vec2(camera.toPixel(label.place, size)), std::to_string(chart), style,
                  TextAlign::Center);
  }
}

}  // namespace chartflood
