#include "core/segment/borders/bordered_charts.h"

#include <algorithm>

namespace chartflood {

std::vector<std::uint8_t> borderedCharts(const Mesh& mesh, std::span<const Index> label,
                                         std::size_t charts) {
  std::vector<std::uint8_t> bordered(charts, 0);
  const auto opposite = mesh.opposite();
  for (Index s = 0; s < opposite.size(); ++s) {
    if (opposite[s] == kNone || opposite[s] < s) continue;
    const Index a = label[mesh.faceOf(s / 3)], b = label[mesh.faceOf(opposite[s] / 3)];
    if (a != b) bordered[a] = bordered[b] = 1;
  }
  const bool none = std::find(bordered.begin(), bordered.end(), 1) == bordered.end();
  if (none) std::fill(bordered.begin(), bordered.end(), std::uint8_t{1});
  return bordered;
}

}  // namespace chartflood
