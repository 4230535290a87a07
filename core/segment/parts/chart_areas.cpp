#include "core/segment/parts/chart_areas.h"

namespace chartflood {

namespace {

/// The chart that holds every face around the vertex, kNone when several do.
Index chartAround(const Mesh& mesh, std::span<const Index> label, Index vertex) {
  const Index first = mesh.vertexSide()[vertex];
  const Index chart = label[mesh.faceOf(first / 3)];
  for (Index side = mesh.turn(first); side != kNone && side != first; side = mesh.turn(side)) {
    if (label[mesh.faceOf(side / 3)] != chart) return kNone;
  }
  return chart;
}

}  // namespace

ChartAreas chartAreas(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
                      std::span<const Index> label, std::size_t chartCount) {
  ChartAreas out;
  out.gaussArea.assign(chartCount, 0);
  const auto add = [&](Index chart, double area) {
    (chart == kNone ? out.onSeams : out.gaussArea[chart]) += area;
  };
  for (Index f = 0; f < mesh.faceCount(); ++f) add(label[f], faceGauss[f]);
  for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
    const Index left = mesh.faceOf(gauss.sharpEdges[i] / 3);
    const Index right = mesh.faceOf(mesh.opposite()[gauss.sharpEdges[i]] / 3);
    if (left == right) continue;  // inside a polygon: part of its face
    add(label[left] == label[right] ? label[left] : kNone, gauss.edge[i]);
  }
  for (std::size_t i = 0; i < gauss.corners.size(); ++i) {
    add(chartAround(mesh, label, gauss.corners[i]), gauss.corner[i]);
  }
  return out;
}

}  // namespace chartflood
