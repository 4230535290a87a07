#include "render/scene/uv_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace chartflood {

namespace {

constexpr int kSide = 768;

float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

/// Writes `value` into the pixels whose middle the triangle covers. Places in pixels, y down.
void fillTriangle(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, Index value,
                  std::vector<Index>& image) {
  const float whole = cross(b - a, c - a);
  if (whole == 0) return;
  const auto first = [](float low) { return std::max(0, static_cast<int>(std::ceil(low - 0.5f))); };
  const auto last = [](float high) {
    return std::min(kSide - 1, static_cast<int>(std::floor(high - 0.5f)));
  };
  const int left = first(std::min({a.x, b.x, c.x})), right = last(std::max({a.x, b.x, c.x}));
  const int top = first(std::min({a.y, b.y, c.y})), bottom = last(std::max({a.y, b.y, c.y}));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const glm::vec2 p(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float atA = cross(c - b, p - b) / whole, atB = cross(a - c, p - c) / whole;
      if (atA < 0 || atB < 0 || atA + atB > 1) continue;
      image[static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)] = value;
    }
  }
}

}  // namespace

std::vector<ChartLabel> islandPlaces(const UvLayout& layout) {
  const glm::vec2 box = layout.high - layout.low;
  const float unit = std::max({box.x, box.y, 1e-6f}) / kSide;  // texture units of a pixel
  std::vector<Index> island(static_cast<std::size_t>(kSide) * kSide, kNone);
  const auto pixel = [&](const glm::vec3& corner) {
    return glm::vec2(corner.x - layout.low.x, layout.high.y - corner.y) / unit;
  };
  for (std::size_t t = 0; t < layout.island.size(); ++t) {
    if (layout.island[t] == kNone) continue;
    const auto corners = layout.corners.begin() + static_cast<std::ptrdiff_t>(3 * t);
    fillTriangle(pixel(corners[0]), pixel(corners[1]), pixel(corners[2]), layout.island[t], island);
  }
  std::vector<ChartLabel> places =
      interiorPlaces(island, kSide, kSide, layout.firstTriangle.size());
  for (ChartLabel& label : places) {
    label.place = {layout.low.x + label.place.x * unit, layout.high.y - label.place.y * unit};
    label.room *= unit;
  }
  return places;
}

}  // namespace chartflood
