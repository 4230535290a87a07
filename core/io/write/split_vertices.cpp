#include "core/io/write/split_vertices.h"

namespace chartflood {

SplitVertices splitVertices(const ChartedMesh& m, const ChartPlaces& places) {
  const InputMesh& input = m.mesh.input();
  SplitVertices out;
  out.place.resize(input.positions.size(), kNone);
  out.chart.resize(input.positions.size(), kNone);
  out.corner = input.corners;
  std::vector<Index> next(input.positions.size(), kNone);  // list of a vertex and its copies
  std::size_t corner = 0;
  for (std::size_t f = 0; f < input.faceCount(); ++f) {
    const std::size_t end = corner + input.face(f).size();
    const Index chart = places.chart[f];
    if (chart == kNone || m.uv(chart).empty()) {
      corner = end;
      continue;
    }
    for (; corner < end; ++corner) {
      const Index wanted = places.corner[corner];
      Index at = input.corners[corner];
      while (out.place[at] != wanted && out.place[at] != kNone && next[at] != kNone) at = next[at];
      if (out.place[at] == kNone) {
        out.place[at] = wanted;
        out.chart[at] = chart;
      } else if (out.place[at] != wanted) {
        const Index copy = static_cast<Index>(out.place.size());
        next[at] = copy;
        out.copyOf.push_back(input.corners[corner]);
        out.place.push_back(wanted);
        out.chart.push_back(chart);
        next.push_back(kNone);
        at = copy;
      }
      out.corner[corner] = at;
    }
  }
  return out;
}

}  // namespace chartflood
