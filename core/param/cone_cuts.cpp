#include "core/param/cone_cuts.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/charts/edge_paths.h"
#include "core/charts/make_cut.h"
#include "core/param/thin_triangles.h"

namespace chartflood {

namespace {

/// Angle missing around a vertex that is more than the rounding of a file.
constexpr double kLeastCurvature = 1e-6;
/// Tips that may each have a slit of any length: there is no other way to lay a cone flat.
constexpr std::size_t kFewCones = 3;
/// Shortest over longest edge at which the angles of a triangle are roundings.
constexpr double kNoAngles = 1e-14;

/// The inner vertices around which the angles do not add up to a full turn.
std::vector<bool> coneVertices(const ChartSurface& surface) {
  std::vector<double> angle(surface.vertexCount(), 0);
  std::vector<bool> measured(surface.vertexCount(), true);
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const FlatTriangle flat = flatTriangle(surface, t);
    const bool noAngles = !(flat.shortest() > kNoAngles * flat.length());
    for (std::size_t i = 0; i < 3; ++i) {
      const Index vertex = surface.triangles[t][i];
      if (noAngles || surface.opposite[3 * t + i] == kNone) measured[vertex] = false;
      const glm::dvec2 out = flat.edge[i], in = flat.edge[(i + 2) % 3];
      angle[vertex] += std::atan2(in.x * out.y - in.y * out.x, -glm::dot(in, out));
    }
  }
  std::vector<bool> cone(surface.vertexCount());
  for (std::size_t v = 0; v < cone.size(); ++v) {
    cone[v] = measured[v] && std::abs(angle[v] - 2 * std::numbers::pi) > kLeastCurvature;
  }
  return cone;
}

/// Ways of edges to all marked vertices; empty when some have none or they get too long.
class ConeTree {
 public:
  ConeTree(const ChartSurface& surface, std::vector<bool> cone)
      : surface_(surface), distances_(surface), cone_(std::move(cone)) {
    for (Index side = 0; side < surface.opposite.size(); ++side) {
      if (surface.opposite[side] != kNone) continue;
      distances_.addSource(surface.sideStart(side));
      boundary_ += sideLength(surface, side);
    }
  }

  std::vector<std::vector<Index>> grow(double most) {
    std::size_t left = 0;
    for (const bool cone : cone_) left += cone ? 1 : 0;
    const bool few = left <= kFewCones;
    std::vector<std::vector<Index>> paths;
    double length = 0;
    while (left > 0) {
      const Index reached = distances_.next();
      if (reached == kNone) return {};
      if (!cone_[reached]) continue;
      const std::vector<Index>& path = paths.emplace_back(distances_.pathTo(reached));
      for (const Index side : path) {
        length += sideLength(surface_, side);
        for (const Index end : {surface_.sideStart(side), surface_.sideEnd(side)}) {
          left -= cone_[end] ? 1 : 0;
          cone_[end] = false;
          distances_.addSource(end);
        }
      }
      if (!few && length > most * boundary_) return {};
    }
    return paths;
  }

 private:
  const ChartSurface& surface_;
  EdgeDistances distances_;
  std::vector<bool> cone_;  // still to be reached
  double boundary_ = 0;
};

}  // namespace

bool openCones(CutChart& chart, double most) {
  CF_CHECK(chart.disk());
  const auto paths = ConeTree(chart.surface, coneVertices(chart.surface)).grow(most);
  if (paths.empty()) return false;
  std::vector<Index> all;
  for (const std::vector<Index>& path : paths) {
    chart.cuts.push_back(makeCut(chart.surface, CutReason::Relief, path));
    all.insert(all.end(), path.begin(), path.end());
  }
  openAlong(chart.surface, all);
  chart.topology = topologyOf(chart.surface);
  CF_CHECK(chart.disk());
  return true;
}

}  // namespace chartflood
