#include "core/charts/crease_share.h"

#include <glm/geometric.hpp>

namespace chartflood {

double creaseShare(const Mesh& mesh, const GaussArea& gauss, std::span<const Index> label) {
  const auto positions = mesh.positions();
  double all = 0, onBorders = 0;
  for (const Index s : gauss.sharpEdges) {
    const double l = glm::length(positions[mesh.sideStart(s)] - positions[mesh.sideEnd(s)]);
    all += l;
    const Index other = mesh.opposite()[s];
    if (label[mesh.faceOf(s / 3)] != label[mesh.faceOf(other / 3)]) onBorders += l;
  }
  return all > 0 ? onBorders / all : 0;
}

}  // namespace chartflood
