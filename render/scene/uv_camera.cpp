#include "render/scene/uv_camera.h"

#include <algorithm>

namespace chartflood {

double UvCamera::pixelsPerUnit(const glm::dvec2& size) const {
  return std::min(size.x, size.y) / span;
}

glm::dvec2 UvCamera::toPixel(const glm::dvec2& uv, const glm::dvec2& size) const {
  const glm::dvec2 away = (uv - center) * pixelsPerUnit(size);
  return 0.5 * size + glm::dvec2(away.x, -away.y);
}

glm::dvec2 UvCamera::toUv(const glm::dvec2& pixel, const glm::dvec2& size) const {
  const glm::dvec2 away = (pixel - 0.5 * size) / pixelsPerUnit(size);
  return center + glm::dvec2(away.x, -away.y);
}

void UvCamera::zoom(double factor, const glm::dvec2& pixel, const glm::dvec2& size) {
  const glm::dvec2 kept = toUv(pixel, size);
  span = std::clamp(span / factor, kLeastSpan, kMostSpan);
  center += kept - toUv(pixel, size);
}

void UvCamera::pan(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& size) {
  center += toUv(from, size) - toUv(to, size);
  // The texture must not be lost out of sight.
  center = glm::dvec2(std::clamp(center.x, -2.0, 3.0), std::clamp(center.y, -2.0, 3.0));
}

void UvCamera::frame(const glm::dvec2& low, const glm::dvec2& high, const glm::dvec2& size) {
  constexpr double kMargin = 1.14;
  const double shorter = std::min(size.x, size.y);
  const glm::dvec2 box = high - low;
  center = 0.5 * (low + high);
  span = std::clamp(kMargin * std::max(box.x * shorter / size.x, box.y * shorter / size.y),
                    kLeastSpan, kMostSpan);
}

Eye makeEye(const UvCamera& camera, const PicturePart& part) {
  const glm::dvec2 size(part.wholeWidth, part.wholeHeight);
  const glm::dvec2 scale = 2.0 * camera.pixelsPerUnit(size) / size;
  Eye eye;
  eye.projection = glm::mat4(0);
  eye.projection[0][0] = static_cast<float>(scale.x);
  eye.projection[1][1] = static_cast<float>(scale.y);
  eye.projection[3] = glm::vec4(glm::vec2(-scale * camera.center), 0, 1);
  eye.tile = tileOf(part);
  eye.viewport = glm::vec2(size);
  eye.orthographic = true;
  eye.pixel = static_cast<float>(1 / camera.pixelsPerUnit(size));
  return eye;
}

}  // namespace chartflood
