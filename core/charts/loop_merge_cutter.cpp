#include "core/charts/loop_merge_cutter.h"

#include "core/charts/chart_surface.h"
#include "core/charts/edge_paths.h"
#include "core/charts/make_cut.h"

namespace chartflood {

namespace {

std::size_t longestOf(const ChartSurface& surface, const std::vector<std::vector<Index>>& loops) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    double length = 0;
    for (const Index side : loops[i]) length += sideLength(surface, side);
    if (length > most) {
      most = length;
      longest = i;
    }
  }
  return longest;
}

/// The vertex farthest from `from` that can be reached; ties to the lower number.
Index farthestFrom(const ChartSurface& surface, Index from) {
  EdgeDistances distances(surface);
  distances.addSource(from);
  Index farthest = from;
  for (Index v = distances.next(); v != kNone; v = distances.next()) {
    if (distances.distance(v) > distances.distance(farthest)) farthest = v;
  }
  return farthest;
}

std::vector<Index> pathBetween(EdgeDistances& distances, Index from, Index to) {
  distances.addSource(from);
  Index reached = distances.next();
  while (reached != kNone && reached != to) reached = distances.next();
  return reached == kNone ? std::vector<Index>{} : distances.pathTo(to);
}

}  // namespace

std::vector<Cut> mergeLoops(ChartSurface& surface) {
  std::vector<Cut> cuts;
  const auto loops = boundaryLoops(surface);
  if (loops.size() < 2) return cuts;
  std::vector<Index> loopOf(surface.vertexCount(), kNone);
  for (Index l = 0; l < loops.size(); ++l) {
    for (const Index side : loops[l]) loopOf[surface.sideStart(side)] = l;
  }
  EdgeDistances distances(surface);
  std::vector<bool> merged(loops.size(), false);
  const auto surround = [&](std::size_t loop) {
    merged[loop] = true;
    for (const Index side : loops[loop]) distances.addSource(surface.sideStart(side));
  };
  surround(longestOf(surface, loops));
  std::vector<Index> opened;
  while (cuts.size() + 1 < loops.size()) {
    const Index reached = distances.next();
    if (reached == kNone) break;
    if (loopOf[reached] == kNone || merged[loopOf[reached]]) continue;
    const std::vector<Index> path = distances.pathTo(reached);
    cuts.push_back(makeCut(surface, CutReason::Loop, path));
    opened.insert(opened.end(), path.begin(), path.end());
    for (const Index side : path) distances.addSource(surface.sideStart(side));
    surround(loopOf[reached]);
  }
  openAlong(surface, opened);
  return cuts;
}

std::vector<Cut> openClosed(ChartSurface& surface) {
  if (surface.vertexCount() == 0) return {};
  const Index from = farthestFrom(surface, 0), to = farthestFrom(surface, from);
  std::vector<Index> path;
  {
    EdgeDistances distances(surface);
    path = pathBetween(distances, from, to);
  }
  if (path.size() == 1) {
    // One edge alone would open to a boundary of two sides that lie on each other.
    EdgeDistances distances(surface);
    distances.forbid(from, to);
    path = pathBetween(distances, from, to);
  }
  if (path.size() < 2) return {};
  std::vector<Cut> cuts{makeCut(surface, CutReason::Open, path)};
  openAlong(surface, path);
  return cuts;
}

}  // namespace chartflood
