#include "core/charts/boundary_cut.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/charts/chart_surface.h"
#include "core/charts/edge_paths.h"
#include "core/charts/make_cut.h"

namespace chartflood {

namespace {

std::vector<bool> boundaryVertices(const ChartSurface& surface) {
  std::vector<bool> boundary(surface.vertexCount(), false);
  for (Index side = 0; side < surface.opposite.size(); ++side) {
    if (surface.opposite[side] == kNone) boundary[surface.sideStart(side)] = true;
  }
  return boundary;
}

}  // namespace

std::vector<double> distanceToBoundary(const ChartSurface& surface) {
  EdgeDistances distances(surface);
  const std::vector<bool> boundary = boundaryVertices(surface);
  for (Index v = 0; v < boundary.size(); ++v) {
    if (boundary[v]) distances.addSource(v);
  }
  while (distances.next() != kNone) {
  }
  return distances.distances();
}

bool isOnBoundary(const ChartSurface& surface, Index vertex) {
  for (Index side = 0; side < surface.opposite.size(); ++side) {
    if (surface.opposite[side] == kNone && surface.sideStart(side) == vertex) return true;
  }
  return false;
}

bool cutToBoundary(CutChart& chart, Index vertex, CutReason reason) {
  const std::vector<bool> boundary = boundaryVertices(chart.surface);
  CF_CHECK(chart.disk() && !boundary[vertex]);
  EdgeDistances distances(chart.surface);
  distances.addSource(vertex);
  Index reached = distances.next();
  while (reached != kNone && !boundary[reached]) reached = distances.next();
  if (reached == kNone) return false;
  const std::vector<Index> path = distances.pathTo(reached);
  chart.cuts.push_back(makeCut(chart.surface, reason, path));
  openAlong(chart.surface, path);
  chart.topology = topologyOf(chart.surface);
  CF_CHECK(chart.disk());
  return true;
}

}  // namespace chartflood
