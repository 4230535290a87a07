#include "core/io/write/label_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr int kLines = 15;
constexpr std::size_t kSpansPerLine = 3;

template <class Visit>
void forEachSide(const Outline& outline, const Visit& visit) {
  for (const auto& loop : outline) {
    for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[(i + 1) % loop.size()]);
  }
}

double distanceTo(const Outline& outline, const glm::dvec2& p) {
  double least = std::numeric_limits<double>::infinity();
  forEachSide(outline, [&](const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 side = b - a;
    const double length = glm::dot(side, side);
    const double along = length > 0 ? glm::clamp(glm::dot(p - a, side) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(p - a - along * side));
  });
  return least;
}

/// Where the line at height y is inside, the longest spans first.
std::vector<std::pair<double, double>> spansAt(const Outline& outline, double y) {
  std::vector<double> crossings;
  forEachSide(outline, [&](const glm::dvec2& a, const glm::dvec2& b) {
    if ((a.y <= y) == (b.y <= y)) return;
    crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  });
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::pair<double, double>> spans;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    spans.emplace_back(crossings[i], crossings[i + 1]);
  }
  std::stable_sort(spans.begin(), spans.end(), [](const auto& a, const auto& b) {
    return a.second - a.first > b.second - b.first;
  });
  return spans;
}

}  // namespace

LabelPoint labelPoint(const Outline& outline) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  forEachSide(outline, [&](const glm::dvec2& a, const glm::dvec2&) {
    low = std::min(low, a.y);
    high = std::max(high, a.y);
  });
  LabelPoint best;
  for (int line = 0; line < kLines; ++line) {
    const double y = low + (high - low) * (line + 0.5) / kLines;
    const auto spans = spansAt(outline, y);
    for (std::size_t i = 0; i < std::min(spans.size(), kSpansPerLine); ++i) {
      if ((spans[i].second - spans[i].first) / 2 <= best.room) break;
      const glm::dvec2 middle((spans[i].first + spans[i].second) / 2, y);
      const double room = distanceTo(outline, middle);
      if (room > best.room) best = {middle, room};
    }
  }
  return best;
}

}  // namespace chartflood
