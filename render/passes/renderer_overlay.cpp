// Scalar bar and chart numbers.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "render/passes/renderer.h"
#include "render/passes/renderer_colors.h"
#include "render/passes/texture_units.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

/// Dark letters on light ground and the other way round, each with a halo of the ground's kind.
TextStyle textOn(const Background& background, float size) {
  const bool light = !background.transparent && lightness(background.top) > 55;
  const glm::vec4 bright(0.95f, 0.95f, 0.95f, 1), dark(0.09f, 0.09f, 0.10f, 1);
  TextStyle style;
  style.size = size;
  style.color = light ? dark : bright;
  style.halo = light ? glm::vec4(1, 1, 1, 0.75f) : glm::vec4(0.05f, 0.05f, 0.06f, 0.75f);
  return style;
}

/// Breaks a line at spaces so that no part is wider than `widest` where words allow.
std::vector<std::string> wrap(Overlay& overlay, const std::string& text, float size, float widest) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (!lines.back().empty() && overlay.textWidth(longer, size) > widest)
      lines.push_back(word);
    else
      lines.back() = longer;
    at = end + 1;
  }
  return lines;
}

}  // namespace

void Renderer::drawOverlay(const Frame& frame, const Camera& camera) {
  overlay_.clear();
  if (frame.settings.numbers) addNumbers(frame, camera);
  const std::optional<ScalarRange> range = scalarRange(frame.settings);
  if (frame.settings.scalarBar && range) addScalarBar(frame, *range);
  overlay_.draw(frame.eye.viewport, frame.eye.tile, units::kColorMap, frame.settings.colorSteps);
}

double Renderer::scalarBarShare(const RenderSettings& settings, int width) const {
  if (!settings.scalarBar || !scalarRange(settings)) return 0;
  // Margin, numbers, bar and the mean's mark.
  const double pixels =
      double{kScalarBarWidth} * double{settings.pixelScale} * double{settings.textSize} / 13.0;
  return std::min(pixels / std::max(width, 1), 0.3);
}

void Renderer::addScalarBar(const Frame& frame, const ScalarRange& range) {
  const RenderSettings& settings = frame.settings;
  const float scale = settings.pixelScale;
  const glm::vec2 picture = frame.eye.viewport;
  const TextStyle style = textOn(settings.background, settings.textSize * scale);
  const float margin = 18 * scale, thick = 14 * scale, gap = 7 * scale;
  const float line = 1.35f * style.size;
  const float height = scalarBarHeight(picture.y, scale);

  const std::vector<ScalarTick> ticks =
      scalarTicks(range, static_cast<int>(std::clamp(height / (2.6f * style.size), 1.0f, 6.0f)));
  float widest = 0;
  for (const ScalarTick& tick : ticks) {
    widest = std::max(widest, overlay_.textWidth(tick.label, style.size));
  }
  // Bar with its numbers to the right, at the bottom right of the picture.
  const float left = std::round(picture.x - margin - widest - gap - thick);
  const float top = std::round(picture.y - margin - height - 0.5f * style.size);
  const float frameWidth = std::max(1.0f, std::round(scale));
  overlay_.rectangle({left - frameWidth, top - frameWidth},
                     {thick + 2 * frameWidth, height + 2 * frameWidth}, style.halo);
  overlay_.colorBar({left, top}, {thick, height});
  if (!settings.clampColors) {  // what lies beyond is grey
    const float cap = std::round(5 * scale), gapOfCap = frameWidth;
    const glm::vec4 grey(colors::kDry, 1);
    overlay_.rectangle({left, top - gapOfCap - cap}, {thick, cap}, grey);
    overlay_.rectangle({left, top + height + gapOfCap}, {thick, cap}, grey);
  }
  for (const ScalarTick& tick : ticks) {
    const float y = std::round(top + height * (1 - static_cast<float>(tick.place)));
    overlay_.rectangle({left + thick + frameWidth, y - 0.5f * frameWidth}, {3 * scale, frameWidth},
                       style.color);
    overlay_.text({left + thick + gap, y}, tick.label, style);
  }
  if (range.hasMean && range.mean > range.min && range.mean < range.max) {
    const float y = std::round(top + height * (1 - static_cast<float>(range.place(range.mean))));
    const float tip = left - 2 * frameWidth, size = 4.5f * scale;
    overlay_.triangle({tip, y}, {tip - 1.5f * size, y - size}, {tip - 1.5f * size, y + size},
                      style.color);
    overlay_.text({tip - 1.5f * size - 3 * scale, y}, "mean", style, TextAlign::Right);
  }
  const std::string title = range.title + (range.unit.empty() ? "" : " [" + range.unit + "]");
  const std::vector<std::string> lines =
      wrap(overlay_, title, style.size, std::min(0.6f * picture.x, 150 * scale));
  float y = top - 0.9f * line - line * static_cast<float>(lines.size() - 1);
  for (const std::string& part : lines) {
    overlay_.text({picture.x - margin, y}, part, style, TextAlign::Right);
    y += line;
  }
}

void Renderer::addNumbers(const Frame& frame, const Camera& camera) {
  const RenderSettings& settings = frame.settings;
  TextStyle style;
  style.size = 1.15f * settings.textSize * settings.pixelScale;
  style.color = glm::vec4(1);
  style.halo = glm::vec4(0.04f, 0.04f, 0.05f, 0.9f);
  const auto labels = chartLabels(camera, settings, static_cast<int>(frame.eye.viewport.x),
                                  static_cast<int>(frame.eye.viewport.y));
  for (const ChartLabel& label : labels) {
    if (label.room < 0.55f * style.size) continue;
    overlay_.text(label.place, std::to_string(label.chart), style, TextAlign::Center);
  }
}

}  // namespace chartflood
