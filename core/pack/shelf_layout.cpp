#include "core/pack/shelf_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chartflood {

namespace {

/// Lower left corners of the boxes at this scale, in the order given; false when they do not fit.
bool putOnShelves(std::span<const EnclosingBox> boxes, std::span<const std::size_t> order,
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
  std::vector<EnclosingBox> boxes;
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
