#include "render/scene/cut_path.h"

#include <cstddef>

#include <glm/geometric.hpp>

namespace chartflood {

std::vector<CutEdge> measureCuts(const Mesh& mesh, std::span<const Index> sides) {
  std::vector<CutEdge> edges;
  edges.reserve(sides.size());
  Index end = kNone;  // vertex that the path has reached
  double length = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Index start = mesh.sideStart(sides[i]), stop = mesh.sideEnd(sides[i]);
    bool backwards = stop == end;
    if (end == kNone || (start != end && stop != end)) {
      length = 0;
      // The first side of a path runs towards the one after it.
      backwards = i + 1 < sides.size() &&
                  (mesh.sideStart(sides[i + 1]) == start || mesh.sideEnd(sides[i + 1]) == start);
    }
    const double next = length + glm::distance(mesh.positions()[start], mesh.positions()[stop]);
    const auto here = static_cast<float>(length), there = static_cast<float>(next);
    edges.push_back(backwards ? CutEdge{sides[i], there, here} : CutEdge{sides[i], here, there});
    end = backwards ? start : stop;
    length = next;
  }
  return edges;
}

}  // namespace chartflood
