#include "render/scene/corner_uv.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace chartflood {

std::vector<glm::vec2> cornerUv(const Mesh& mesh, const ChartSet& charts, const Atlas& atlas) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  std::vector<glm::vec2> corners(3 * mesh.triangleCount(), glm::vec2(kNan));
  const std::size_t count = std::min(charts.charts.size(), atlas.uv.size());
  for (std::size_t c = 0; c < count; ++c) {
    const ChartSurface& surface = charts.charts[c].surface;
    const std::vector<glm::dvec2>& uv = atlas.uv[c];
    if (uv.size() != surface.vertexCount()) continue;  // not laid flat
    for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
      const std::size_t first = std::size_t{3} * surface.meshTriangle[t];
      for (std::size_t i = 0; i < 3; ++i) {
        corners[first + i] = glm::vec2(uv[surface.triangles[t][i]]);
      }
    }
  }
  return corners;
}

std::vector<Index> cutSides(const ChartSet& charts) {
  std::vector<Index> sides;
  for (const CutChart& chart : charts.charts) {
    for (const Cut& cut : chart.cuts) {
      sides.insert(sides.end(), cut.sides.begin(), cut.sides.end());
    }
  }
  return sides;
}

}  // namespace chartflood
