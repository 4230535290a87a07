#include "app/host/problems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr std::array kKinds = {ProblemKind::NotDisks,   ProblemKind::NotFlat,
                               ProblemKind::Flipped,    ProblemKind::DegenerateFaces,
                               ProblemKind::ThinCharts, ProblemKind::OpenSharpEdges};

struct KindInfo {
  const char *id, *one, *many, *help;
};

constexpr std::array<KindInfo, kKinds.size()> kInfos = {{
    {"not-disks", "chart is no disk", "charts are no disks",
     "A chart lies flat only when it is one piece with one border. The cuts of the unwrap open "
     "it; so does a seed more."},
    {"not-flat", "chart is not laid flat", "charts are not laid flat",
     "The unwrap left them out: they have no place in the texture."},
    {"flipped", "flipped triangle", "flipped triangles",
     "They face the other way in the texture: paint comes out mirrored and twice in one place."},
    {"degenerate-faces", "face without area", "faces without area",
     "They have no direction of their own and follow their neighbours. Usually harmless."},
    {"thin-charts", "thin chart", "thin charts",
     "Thinner than 8 pixels of the texture: hard to paint on. Fewer charts or a larger texture "
     "help."},
    {"open-sharp-edges", "sharp edge inside a chart", "sharp edges inside charts",
     "No border follows them: shading and paint run across the crease. More crease avoidance or "
     "more charts help."},
}};

const KindInfo& infoOf(ProblemKind kind) { return kInfos[static_cast<std::size_t>(kind)]; }

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<glm::dvec2> convexHull(std::span<const glm::dvec2> points) {
  std::vector<glm::dvec2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  });
  std::vector<glm::dvec2> hull;
  const auto add = [&](const glm::dvec2& p, std::size_t fixed) {
    while (hull.size() >= fixed + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const glm::dvec2& p : sorted) add(p, 0);
  const std::size_t lower = hull.size() - (hull.empty() ? 0 : 1);
  for (auto p = sorted.rbegin(); p != sorted.rend(); ++p) add(*p, lower);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

/// Least distance between two parallel lines around the points: one of them holds a side of the
/// hull.
double leastWidth(std::span<const glm::dvec2> points) {
  const std::vector<glm::dvec2> hull = convexHull(points);
  if (hull.size() < 3) return 0;
  double least = std::numeric_limits<double>::max();
  std::size_t far = 1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 side = hull[(i + 1) % hull.size()] - hull[i];
    const auto height = [&](std::size_t k) { return cross(side, hull[k % hull.size()] - hull[i]); };
    // The farthest corner only moves on as the sides turn.
    for (std::size_t n = 0; n < hull.size() && height(far + 1) > height(far); ++n) ++far;
    least = std::min(least, height(far) / std::max(glm::length(side), 1e-300));
  }
  return least;
}

/// Whether the unwrap belongs to the charts.
bool isFlat(const Results& r) {
  return r.flat && r.charts && r.unwrap && r.charts->charts.size() == r.chartStats->charts.size() &&
         r.unwrap->charts.size() == r.charts->charts.size();
}

/// A place for each chart that `test` says yes to.
template <typename Test>
void addCharts(std::size_t charts, ProblemKind kind, Test&& test, std::vector<Problem>& out) {
  Problem problem{kind, 0, 0, {}};
  for (Index c = 0; c < charts; ++c) {
    if (test(c)) problem.places.push_back({c, kNone});
  }
  problem.count = problem.places.size();
  if (problem.count > 0) out.push_back(std::move(problem));
}

void addFlipped(const Unwrap& unwrap, std::vector<Problem>& out) {
  Problem problem{ProblemKind::Flipped, 0, 0, {}};
  for (Index c = 0; c < unwrap.charts.size(); ++c) {
    if (unwrap.charts[c].distortion.flipped == 0 || unwrap.charts[c].uv.empty()) continue;
    problem.count += unwrap.charts[c].distortion.flipped;
    problem.places.push_back({c, kNone});
  }
  std::stable_sort(problem.places.begin(), problem.places.end(), [&](const auto& a, const auto& b) {
    return unwrap.charts[a.chart].distortion.flipped > unwrap.charts[b.chart].distortion.flipped;
  });
  if (problem.count > 0) out.push_back(std::move(problem));
}

void addDegenerate(const Results& results, std::vector<Problem>& out) {
  const Mesh& mesh = *results.mesh;
  Problem problem{ProblemKind::DegenerateFaces, 0, 0, {}};
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (!mesh.degenerate(t)) continue;
    const Index face = mesh.faceOf(t);
    if (!problem.places.empty() && problem.places.back().face == face) continue;
    problem.places.push_back({results.segmentation->label[face], face});
  }
  problem.count = problem.places.size();
  if (problem.count > 0) out.push_back(std::move(problem));
}

/// Thickness of a chart in pixels of the texture.
double pixelThickness(const ChartSurface& surface, std::span<const glm::dvec2> uv, double size) {
  std::vector<glm::dvec2> outline;
  double area = 0, perimeter = 0;
  for (Index side = 0; side < surface.opposite.size(); ++side) {
    const glm::dvec2 a = size * uv[surface.sideStart(side)], b = size * uv[surface.sideEnd(side)];
    if (surface.opposite[side] != kNone) continue;
    area += cross(a, b) / 2;
    perimeter += glm::distance(a, b);
    outline.push_back(a);
  }
  return thickness(outline, std::abs(area), perimeter);
}

void addThin(const Results& results, std::vector<Problem>& out) {
  if (!results.atlas) return;
  const Atlas& atlas = *results.atlas;
  const auto size = static_cast<double>(atlas.textureSize);
  addCharts(
      std::min(atlas.uv.size(), results.charts->charts.size()), ProblemKind::ThinCharts,
      [&](Index c) {
        const ChartSurface& surface = results.charts->charts[c].surface;
        return atlas.uv[c].size() == surface.vertexCount() && !atlas.uv[c].empty() &&
               pixelThickness(surface, atlas.uv[c], size) < kThinPixels;
      },
      out);
}

/// One flag a side: a cut runs along it.
std::vector<bool> cutSides(const Results& results) {
  std::vector<bool> cut(3 * results.mesh->triangleCount(), false);
  if (!isFlat(results)) return cut;
  for (const CutChart& chart : results.charts->charts) {
    for (const Cut& path : chart.cuts) {
      for (const Index side : path.sides) cut[results.mesh->edgeOfSide(side)] = true;
    }
  }
  return cut;
}

void addSharpEdges(const Results& results, std::vector<Problem>& out) {
  if (!results.gaussArea || results.gaussArea->sharpEdges.empty()) return;
  const Mesh& mesh = *results.mesh;
  const std::vector<Index>& label = results.segmentation->label;
  const std::vector<bool> cut = cutSides(results);
  std::vector<double> open(results.segmentation->chartCount, 0.0);
  Problem problem{ProblemKind::OpenSharpEdges, 0, 0, {}};
  double all = 0, inside = 0;
  for (const Index side : results.gaussArea->sharpEdges) {
    const double length =
        glm::distance(mesh.positions()[mesh.sideStart(side)], mesh.positions()[mesh.sideEnd(side)]);
    all += length;
    const Index chart = label[mesh.faceOf(side / 3)];
    if (chart == kNone || chart != label[mesh.faceOf(mesh.opposite()[side] / 3)] || cut[side])
      continue;
    ++problem.count;
    inside += length;
    open[chart] += length;
  }
  if (problem.count == 0) return;
  problem.share = all > 0 ? inside / all : 0;
  for (Index c = 0; c < open.size(); ++c) {
    if (open[c] > 0) problem.places.push_back({c, kNone});
  }
  std::stable_sort(problem.places.begin(), problem.places.end(),
                   [&](const auto& a, const auto& b) { return open[a.chart] > open[b.chart]; });
  // Creases of no length have a chart all the same.
  if (!problem.places.empty()) out.push_back(std::move(problem));
}

}  // namespace

const char* problemId(ProblemKind kind) { return infoOf(kind).id; }

std::span<const ProblemKind> problemKinds() { return kKinds; }

const char* problemHelp(ProblemKind kind) { return infoOf(kind).help; }

std::string problemText(const Problem& problem) {
  const KindInfo& info = infoOf(problem.kind);
  std::string text =
      std::to_string(problem.count) + ' ' + (problem.count == 1 ? info.one : info.many);
  if (problem.kind == ProblemKind::OpenSharpEdges) {
    char share[32];
    std::snprintf(share, sizeof share, " (%.0f %%)", 100 * problem.share);
    text += share;
  }
  return text;
}

double thickness(std::span<const glm::dvec2> points, double area, double perimeter) {
  const double hydraulic = perimeter > 0 ? 4 * area / perimeter : 0;
  return std::min(leastWidth(points), hydraulic);
}

std::vector<Problem> findProblems(const Results& results) {
  std::vector<Problem> problems;
  if (!results.mesh || !results.segmentation || !results.chartStats) return problems;
  if (results.segmentation->label.size() != results.mesh->faceCount()) return problems;
  const ChartStats& stats = *results.chartStats;
  const bool flat = isFlat(results);
  addCharts(
      stats.charts.size(), ProblemKind::NotDisks,
      [&](Index c) { return !(flat ? results.charts->charts[c].disk() : stats.charts[c].disk); },
      problems);
  if (flat) {
    // Those that are no disks are named already.
    addCharts(
        stats.charts.size(), ProblemKind::NotFlat,
        [&](Index c) {
          return results.unwrap->charts[c].uv.empty() && results.charts->charts[c].disk();
        },
        problems);
    addFlipped(*results.unwrap, problems);
  }
  addDegenerate(results, problems);
  if (flat) addThin(results, problems);
  addSharpEdges(results, problems);
  return problems;
}

}  // namespace chartflood
