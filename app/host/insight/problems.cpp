#include "app/host/insight/problems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "app/host/insight/thickness.h"
#include "core/base/cross.h"
#include "core/base/interruption.h"
#include "core/charts/chart_surface.h"
#include "core/param/border_overlaps.h"
#include "core/param/uv_overlaps.h"

namespace chartflood {

namespace {

constexpr std::array kKinds = {ProblemKind::NotDisks,        ProblemKind::NotFlat,
                               ProblemKind::Flipped,         ProblemKind::Overlapping,
                               ProblemKind::DegenerateFaces, ProblemKind::ThinCharts,
                               ProblemKind::OpenSharpEdges,  ProblemKind::NonManifoldEdges};

/// Less than this is no overlap, pixels of the texture: nobody could paint on it.
constexpr double kLeastOverlap = 0.05;

struct KindInfo {
  const char *id, *one, *many, *name, *help;
};

constexpr std::array<KindInfo, kKinds.size()> kInfos = {{
    {"not-disks", "chart is no disk", "charts are no disks", "Charts that are no disks",
     "A chart lies flat only when it hangs together and has one border. The cuts of the unwrap open "
     "it; so does a seed more."},
    {"not-flat", "chart is not laid flat", "charts are not laid flat", "Charts not laid flat",
     "The unwrap left them out: they have no place in the texture."},
    {"flipped", "flipped triangle", "flipped triangles", "Flipped triangles",
     "They face the other way in the texture: paint comes out mirrored and twice in one place."},
    {"overlapping", "triangle over another", "triangles over others", "Triangles over others",
     "They share a place of the texture: paint on one shows on the other too."},
    {"degenerate-faces", "face without area", "faces without area", "Faces without area",
     "They have no direction of their own and follow their neighbours. Usually harmless."},
    {"thin-charts", "thin chart", "thin charts", "Thin charts",
     "Thinner than 8 pixels of the texture: hard to paint on. Fewer charts or a larger texture "
     "help."},
    {"open-sharp-edges", "sharp edge inside a chart", "sharp edges inside charts",
     "Sharp edges inside charts",
     "No border follows them: shading and paint run across the crease. More crease avoidance or "
     "more charts help."},
    {"non-manifold-edges", "edge of more than two faces", "edges of more than two faces",
     "Edges of more than two faces",
     "The surface branches there. It was split apart, so that a chart never runs across."},
}};

const KindInfo& infoOf(ProblemKind kind) { return kInfos[static_cast<std::size_t>(kind)]; }

/// Whether the unwrap belongs to the charts.
bool isFlat(const Results& r) {
  return r.flat && r.charts && r.unwrap && r.charts->charts.size() == r.chartStats->charts.size() &&
         r.unwrap->charts.size() == r.charts->charts.size();
}

/// A place for each chart that `test` says yes to.
template <typename Test>
void addCharts(std::size_t charts, ProblemKind kind, Test&& test, std::vector<Problem>& out) {
  Problem problem{kind, 0, 0, {}, {}, {}};
  for (Index c = 0; c < charts; ++c) {
    if (test(c)) problem.places.push_back({c, kNone});
  }
  problem.count = problem.places.size();
  if (problem.count > 0) out.push_back(std::move(problem));
}

/// Counts triangles by chart, the charts with most of them first.
void addTriangles(std::vector<Index> triangles, const Results& results, ProblemKind kind,
                  std::vector<Problem>& out) {
  if (triangles.empty()) return;
  Problem problem{kind, triangles.size(), 0, {}, std::move(triangles), {}};
  std::vector<std::size_t> count(results.charts->charts.size(), 0);
  for (const Index t : problem.triangles) {
    const Index chart = results.segmentation->label[results.mesh->faceOf(t)];
    if (chart < count.size()) ++count[chart];
  }
  for (Index c = 0; c < count.size(); ++c) {
    if (count[c] > 0) problem.places.push_back({c, kNone});
  }
  std::stable_sort(problem.places.begin(), problem.places.end(),
                   [&](const auto& a, const auto& b) { return count[a.chart] > count[b.chart]; });
  if (!problem.places.empty()) out.push_back(std::move(problem));
}

/// Calls `visit` with each triangle of the mesh that lies in the texture, and its places there.
template <typename Visit>
void eachFlatTriangle(const Results& results, Index chart, Visit&& visit) {
  const ChartSurface& surface = results.charts->charts[chart].surface;
  const auto& uv = results.atlas->uv[chart];
  if (uv.size() != surface.vertexCount()) return;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto& v = surface.triangles[t];
    visit(surface.meshTriangle[t], PlaneTriangle{uv[v[0]], uv[v[1]], uv[v[2]]});
  }
}

double signedArea(const PlaneTriangle& t) { return cross(t[1] - t[0], t[2] - t[0]) / 2; }

void addFlipped(const Results& results, std::vector<Problem>& out) {
  std::vector<Index> flipped;
  for (Index c = 0; c < results.atlas->uv.size(); ++c) {
    if (results.unwrap->charts[c].distortion.flipped == 0) continue;
    double sum = 0;
    eachFlatTriangle(results, c, [&](Index, const PlaneTriangle& t) { sum += signedArea(t); });
    eachFlatTriangle(results, c, [&](Index triangle, const PlaneTriangle& t) {
      if (signedArea(t) * sum < 0) flipped.push_back(triangle);
    });
  }
  std::sort(flipped.begin(), flipped.end());
  addTriangles(std::move(flipped), results, ProblemKind::Flipped, out);
}

/// The border of a chart in the texture; empty unless it has one.
FlatBorder borderOf(const Results& results, Index chart) {
  const ChartSurface& surface = results.charts->charts[chart].surface;
  const auto& uv = results.atlas->uv[chart];
  FlatBorder border;
  if (uv.size() != surface.vertexCount()) return border;
  const auto loops = boundaryLoops(surface);
  if (loops.size() != 1) return border;
  for (const Index side : loops.front()) border.push_back(uv[surface.sideStart(side)]);
  return border;
}

/// The box of all that a chart covers in the texture.
PlaneBox boxOf(std::span<const glm::dvec2> uv) {
  PlaneBox box;
  for (const glm::dvec2& p : uv) box.add(p);
  return box;
}

/// Charts whose triangles must be looked at one by one: all others lie apart, as their borders
/// tell.
std::vector<bool> chartsInDoubt(const Results& results) {
  const auto& uv = results.atlas->uv;
  std::vector<FlatBorder> borders;
  for (Index c = 0; c < uv.size(); ++c) borders.push_back(borderOf(results, c));
  std::vector<bool> doubt = findMeetingCharts(borders);
  for (Index c = 0; c < borders.size(); ++c) {
    if (borders[c].empty() || results.unwrap->charts[c].distortion.flipped > 0) doubt[c] = true;
  }
  // Those may reach beyond their borders.
  const std::vector<bool> alone = doubt;
  for (Index c = 0; c < uv.size(); ++c) {
    if (!alone[c]) continue;
    const PlaneBox box = boxOf(uv[c]);
    for (Index d = 0; d < uv.size(); ++d) {
      if (!doubt[d] && box.meets(boxOf(uv[d]))) doubt[d] = true;
    }
  }
  return doubt;
}

void addOverlapping(const Results& results, std::vector<Problem>& out) {
  std::vector<Index> triangle;
  std::vector<PlaneTriangle> places;
  const std::vector<bool> doubt = chartsInDoubt(results);
  for (Index c = 0; c < results.atlas->uv.size(); ++c) {
    if (!doubt[c]) continue;
    eachFlatTriangle(results, c, [&](Index t, const PlaneTriangle& place) {
      triangle.push_back(t);
      places.push_back(place);
    });
  }
  const double size = std::max(results.atlas->textureSize, 1);
  const std::vector<bool> over = findOverlaps(places, kLeastOverlap / size);
  std::vector<Index> found;
  for (std::size_t i = 0; i < over.size(); ++i) {
    if (over[i]) found.push_back(triangle[i]);
  }
  std::sort(found.begin(), found.end());
  addTriangles(std::move(found), results, ProblemKind::Overlapping, out);
}

void addDegenerate(const Results& results, std::vector<Problem>& out) {
  const Mesh& mesh = *results.mesh;
  Problem problem{ProblemKind::DegenerateFaces, 0, 0, {}, {}, {}};
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
  Problem problem{ProblemKind::OpenSharpEdges, 0, 0, {}, {}, {}};
  double all = 0, inside = 0;
  for (const Index side : results.gaussArea->sharpEdges) {
    const double length =
        glm::distance(mesh.positions()[mesh.sideStart(side)], mesh.positions()[mesh.sideEnd(side)]);
    all += length;
    const Index chart = label[mesh.faceOf(side / 3)];
    if (chart == kNone || chart != label[mesh.faceOf(mesh.opposite()[side] / 3)] || cut[side])
      continue;
    ++problem.count;
    problem.sides.push_back(side);
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

/// Edges of the input that more than two triangles share. The mesh has split them apart, and says
/// whether there were any.
void addNonManifold(const Results& results, std::vector<Problem>& out) {
  const Mesh& mesh = *results.mesh;
  const auto repairs = mesh.repairs();
  if (std::none_of(repairs.begin(), repairs.end(),
                   [](const Repair& r) { return r.what == "non-manifold-edges"; })) {
    return;
  }
  const auto inputVertex = [&](Index vertex) { return mesh.inputVertex(vertex); };
  using Ends = std::pair<Index, Index>;
  std::vector<std::pair<Ends, Index>> sides;
  for (Index side = 0; side < mesh.opposite().size(); ++side) {
    const Index a = inputVertex(mesh.sideStart(side)), b = inputVertex(mesh.sideEnd(side));
    sides.push_back({{std::min(a, b), std::max(a, b)}, side});
  }
  std::sort(sides.begin(), sides.end());
  Problem problem{ProblemKind::NonManifoldEdges, 0, 0, {}, {}, {}};
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].first == sides[first].first) ++end;
    if (end - first < 3) continue;
    ++problem.count;
    const Index side = sides[first].second, face = mesh.faceOf(side / 3);
    problem.sides.push_back(side);
    problem.places.push_back({results.segmentation->label[face], face});
  }
  if (problem.count > 0) out.push_back(std::move(problem));
}

}  // namespace

const char* problemId(ProblemKind kind) { return infoOf(kind).id; }

std::span<const ProblemKind> problemKinds() { return kKinds; }

const char* problemName(ProblemKind kind) { return infoOf(kind).name; }
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
  }
  const bool placed =
      flat && results.atlas && results.atlas->uv.size() == results.charts->charts.size();
  if (placed) {
    addFlipped(results, problems);
    throwIfInterrupted();
    addOverlapping(results, problems);
  }
  throwIfInterrupted();
  addDegenerate(results, problems);
  if (placed) addThin(results, problems);
  addSharpEdges(results, problems);
  addNonManifold(results, problems);
  return problems;
}

}  // namespace chartflood
