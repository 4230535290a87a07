#include "core/pack/shelf_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace chartflood {

namespace {

/// A chart turned upright.
struct TurnedBox {
  double angle = 0;
  glm::dvec2 low{0}, size{0};  ///< of the turned points' bounding box
};

TurnedBox boxAt(const std::vector<glm::dvec2>& hull, double angle) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double c = std::cos(angle), s = std::sin(angle);
  glm::dvec2 low(inf), high(-inf);
  for (const glm::dvec2& p : hull) {
    const glm::dvec2 q(c * p.x - s * p.y, s * p.x + c * p.y);
    low = glm::min(low, q);
    high = glm::max(high, q);
  }
  return {angle, low, high - low};
}

/// The box of the least area has a side along the hull.
TurnedBox smallestBox(const std::vector<glm::dvec2>& hull) {
  TurnedBox best = boxAt(hull, 0);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 along = hull[(i + 1) % hull.size()] - hull[i];
    if (along == glm::dvec2(0)) continue;
    const TurnedBox box = boxAt(hull, -std::atan2(along.y, along.x));
    if (box.size.x * box.size.y < best.size.x * best.size.y) best = box;
  }
  return best.size.x >= best.size.y ? best : boxAt(hull, best.angle + std::numbers::pi / 2);
}

/// Lower left corners of the boxes at this scale, in the order given; false when they do not fit.
bool putOnShelves(std::span<const TurnedBox> boxes, std::span<const std::size_t> order,
                  double scale, const PackGaps& gaps, std::vector<glm::dvec2>& corners) {
  const double end = 1 - gaps.border;
  double x = gaps.border, top = end, height = 0;
  for (const std::size_t i : order) {
    const glm::dvec2 size = scale * boxes[i].size;
    if (x > gaps.border && x + size.x > end) {
      top -= height + gaps.between;
      x = gaps.border;
      height = 0;
    }
    if (x + size.x > end || top - size.y < gaps.border) return false;
    corners[i] = {x, top - size.y};
    x += size.x + gaps.between;
    height = std::max(height, size.y);
  }
  return true;
}

}  // namespace

std::vector<Placement> shelfLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                   double leastScale) {
  std::vector<TurnedBox> boxes;
  double longest = 0;
  for (const ChartOutline& outline : outlines) {
    boxes.push_back(smallestBox(outline.hull));
    longest = std::max(longest, boxes.back().size.x);
  }
  if (longest <= 0) return {};
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].size.y > boxes[b].size.y; });
  std::vector<glm::dvec2> corners(boxes.size()), best;
  double low = leastScale, high = (1 - 2 * gaps.border) / longest;
  for (int i = 0; i < 50; ++i) {
    const double scale = (low + high) / 2;
    if (putOnShelves(boxes, order, scale, gaps, corners)) {
      best = corners;
      low = scale;
    } else {
      high = scale;
    }
  }
  if (best.empty()) return {};
  // Rounding must not push a chart over the edge of its box.
  constexpr double kWithin = 1 - 1e-9;
  low *= kWithin;
  std::vector<Placement> placement;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    placement.push_back({boxes[i].angle, low,
                         best[i] + (1 - kWithin) / 2 * low * boxes[i].size - low * boxes[i].low});
  }
  return placement;
}

}  // namespace chartflood
