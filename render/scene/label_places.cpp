#include "render/scene/label_places.h"

#include <algorithm>

namespace chartflood {

namespace {

/// Distance of each pixel to the border of its region, by two sweeps over the picture (chamfer
/// distance with steps 1 and sqrt 2); 0 outside all charts.
std::vector<float> distanceToBorder(std::span<const Index> chart, int width, int height) {
  constexpr float kDiagonal = 1.41421356f;
  std::vector<float> distance(chart.size(), 0.0f);
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  const auto via = [&](std::size_t here, int x, int y, float step) {
    if (x < 0 || y < 0 || x >= width || y >= height) return step;
    const std::size_t there = index(x, y);
    return chart[there] == chart[here] ? distance[there] + step : step;
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t here = index(x, y);
      if (chart[here] == kNone) continue;
      distance[here] =
          std::min({via(here, x - 1, y, 1), via(here, x, y - 1, 1),
                    via(here, x - 1, y - 1, kDiagonal), via(here, x + 1, y - 1, kDiagonal)});
    }
  }
  for (int y = height; y-- > 0;) {
    for (int x = width; x-- > 0;) {
      const std::size_t here = index(x, y);
      if (chart[here] == kNone) continue;
      distance[here] =
          std::min({distance[here], via(here, x + 1, y, 1), via(here, x, y + 1, 1),
                    via(here, x + 1, y + 1, kDiagonal), via(here, x - 1, y + 1, kDiagonal)});
    }
  }
  return distance;
}

}  // namespace

std::vector<ChartLabel> interiorPlaces(std::span<const Index> chart, int width, int height,
                                       std::size_t chartCount) {
  const std::vector<float> distance = distanceToBorder(chart, width, height);
  std::vector<ChartLabel> best(chartCount);
  for (std::size_t i = 0; i < chart.size(); ++i) {
    if (chart[i] == kNone || distance[i] <= best[chart[i]].room) continue;
    const auto column = static_cast<float>(i % static_cast<std::size_t>(width));
    const std::size_t line = i / static_cast<std::size_t>(width);
    best[chart[i]] = {chart[i], {column + 0.5f, static_cast<float>(line) + 0.5f}, distance[i]};
  }
  std::erase_if(best, [](const ChartLabel& label) { return label.chart == kNone; });
  return best;
}

}  // namespace chartflood
