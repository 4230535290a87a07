#include "core/segment/creases/region_graph.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/segment/borders/seam_level.h"

namespace chartflood {

namespace {

glm::dvec3 triangleCross(const Mesh& mesh, Index triangle) {
  const auto& t = mesh.triangles()[triangle];
  const auto p = mesh.positions();
  return glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

/// Angle between the normals of the triangles beside an edge, radians; 0 where one has none.
double bendAt(const Mesh& mesh, Index side) {
  const Index left = side / 3, right = mesh.opposite()[side] / 3;
  if (mesh.degenerate(left) || mesh.degenerate(right)) return 0;
  const glm::dvec3 a = triangleCross(mesh, left), b = triangleCross(mesh, right);
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

RegionGraph::RegionGraph(const Mesh& mesh, std::span<const Index> label, std::size_t regions)
    : surface_(std::max(mesh.surfaceArea(), 1e-300)), count_(regions), into_(regions) {
  // The sums of regions and borders are those of a level whose clusters are the regions.
  GaussArea none;
  const std::vector<double> noGauss(mesh.faceCount(), 0);
  const SeamTables tables = makeSeamTables(mesh, none, noGauss, 1, 0);
  const SeamLevel level = buildSeamLevel(mesh, tables, {label.begin(), label.end()}, regions);
  area_ = level.area;
  euler_ = level.euler;
  triangles_.assign(regions, 0);
  for (Index f = 0; f < label.size(); ++f) {
    triangles_[label[f]] += mesh.triangleBegin(f + 1) - mesh.triangleBegin(f);
  }
  for (Index r = 0; r < regions; ++r) {
    into_[r] = r;
    for (Index arc = level.arcBegin[r]; arc < level.arcBegin[r + 1]; ++arc) {
      if (level.arcHead[arc] < r) continue;
      borders_[{r, level.arcHead[arc]}] = {level.arcLength[arc], 0, level.arcEuler[arc], 0};
    }
  }
  for (Index s = 0; s < mesh.opposite().size(); ++s) {
    const Index other = mesh.opposite()[s];
    if (other == kNone || other < s) continue;
    const Index a = label[mesh.faceOf(s / 3)], b = label[mesh.faceOf(other / 3)];
    if (a == b) continue;
    borders_[{std::min(a, b), std::max(a, b)}].bend += tables.sideLength[s] * bendAt(mesh, s);
  }
  for (Index c = 0; c < level.cornerCount(); ++c) {
    corners_.emplace_back(level.cornerNode.begin() + level.cornerNodeBegin[c],
                          level.cornerNode.begin() + level.cornerNodeBegin[c + 1]);
  }
  countCorners();
}

int RegionGraph::eulerOfBoth(Index a, Index b, const Border& border) const {
  return euler_[a] + euler_[b] + border.euler + border.corners;
}

double RegionGraph::score(Index a, Index b, const Border& border) const {
  const int growth =
      diskDefect(eulerOfBoth(a, b, border)) - diskDefect(euler_[a]) - diskDefect(euler_[b]);
  const double bend = border.length > 0 ? border.bend / border.length : 0;
  return border.length / std::sqrt(surface_) - 4 * std::min(area_[a], area_[b]) / surface_ -
         0.4 * growth - 0.3 * bend;
}

bool RegionGraph::joinBest() { return join(false); }
bool RegionGraph::joinLone() { return join(true); }

bool RegionGraph::join(bool loneOnly) {
  std::pair<Index, Index> best;
  double highest = 0;
  bool found = false;
  for (const auto& [pair, border] : borders_) {
    if (loneOnly && triangles_[pair.first] > 1 && triangles_[pair.second] > 1) continue;
    const double s = score(pair.first, pair.second, border);
    if (found && !(s > highest)) continue;
    best = pair;
    highest = s;
    found = true;
  }
  if (found) join(best.first, best.second);
  return found;
}

void RegionGraph::join(Index a, Index b) {
  const Border between = borders_[{a, b}];
  euler_[a] = eulerOfBoth(a, b, between);
  area_[a] += area_[b];
  triangles_[a] += triangles_[b];
  borders_.erase({a, b});
  std::map<std::pair<Index, Index>, Border> joined;
  for (const auto& [pair, border] : borders_) {
    const Index x = pair.first == b ? a : pair.first, y = pair.second == b ? a : pair.second;
    Border& sum = joined[{std::min(x, y), std::max(x, y)}];
    sum.length += border.length;
    sum.bend += border.bend;
    sum.euler += border.euler;
  }
  borders_ = std::move(joined);
  for (Index& r : into_) r = r == b ? a : r;
  for (auto& corner : corners_) {
    for (Index& r : corner) r = r == b ? a : r;
    std::sort(corner.begin(), corner.end());
    corner.erase(std::unique(corner.begin(), corner.end()), corner.end());
  }
  // Corners that lie inside now have been counted with the border that went.
  std::erase_if(corners_, [](const auto& corner) { return corner.size() < 2; });
  countCorners();
  --count_;
}

void RegionGraph::countCorners() {
  for (auto& [pair, border] : borders_) border.corners = 0;
  for (auto& corner : corners_) {
    std::sort(corner.begin(), corner.end());
    if (corner.size() == 2) ++borders_[{corner[0], corner[1]}].corners;
  }
}

}  // namespace chartflood
