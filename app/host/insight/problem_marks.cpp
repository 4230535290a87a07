#include "app/host/insight/problem_marks.h"

#include <array>
#include <utility>
#include <vector>

namespace chartflood {

namespace {

/// Marks the triangles that are meant, or else all of the charts that are.
void markTriangles(const Mesh& mesh, const Segmentation& segmentation, const Problem& problem,
                   TriangleMark mark, std::vector<TriangleMark>& marks) {
  if (!problem.triangles.empty()) {
    for (const Index t : problem.triangles) marks[t] = mark;
    return;
  }
  std::vector<bool> meant(segmentation.chartCount, false);
  for (const ProblemPlace& place : problem.places) {
    if (place.chart < meant.size()) meant[place.chart] = true;
  }
  for (Index t = 0; t < marks.size(); ++t) {
    const Index chart = segmentation.label[mesh.faceOf(t)];
    if (chart < meant.size() && meant[chart]) marks[t] = mark;
  }
}

/// The edges of faces that are meant.
std::vector<Index> facesSides(const Mesh& mesh, const Problem& problem) {
  std::vector<Index> sides;
  for (const ProblemPlace& place : problem.places) {
    for (Index t = mesh.triangleBegin(place.face); t < mesh.triangleBegin(place.face + 1); ++t) {
      if (mesh.degenerate(t)) sides.insert(sides.end(), {3 * t, 3 * t + 1, 3 * t + 2});
    }
  }
  return sides;
}

}  // namespace

ProblemLook problemLook(ProblemKind kind) {
  switch (kind) {
  case ProblemKind::Flipped:
    return {TriangleMark::Stripes, markColor(TriangleMark::Stripes)};
  case ProblemKind::Overlapping:
    return {TriangleMark::Lattice, markColor(TriangleMark::Lattice)};
  case ProblemKind::NotDisks:
  case ProblemKind::NotFlat:
    return {TriangleMark::Bars, markColor(TriangleMark::Bars)};
  case ProblemKind::ThinCharts:
    return {TriangleMark::Dots, markColor(TriangleMark::Dots)};
  // Sky blue, orange red and white: told from seams (dark) and cuts (amber) by lightness and width.
  case ProblemKind::OpenSharpEdges:
    return {TriangleMark::None, glm::vec3(0.337f, 0.706f, 0.914f), 3.0f, true};
  case ProblemKind::NonManifoldEdges:
    return {TriangleMark::None, glm::vec3(0.925f, 0.314f, 0.157f), 4.2f, false};
  case ProblemKind::DegenerateFaces:
    return {TriangleMark::None, glm::vec3(1), 2.0f, false};
  }
  return {};
}

SurfaceMarks problemMarks(const Mesh& mesh, const Segmentation& segmentation,
                          std::span<const Problem> problems) {
  // The last one that is set stays.
  constexpr std::array kRising = {ProblemKind::ThinCharts,     ProblemKind::NotFlat,
                                  ProblemKind::NotDisks,       ProblemKind::Overlapping,
                                  ProblemKind::Flipped,        ProblemKind::DegenerateFaces,
                                  ProblemKind::OpenSharpEdges, ProblemKind::NonManifoldEdges};
  SurfaceMarks marks;
  for (const ProblemKind kind : kRising) {
    for (const Problem& problem : problems) {
      if (problem.kind != kind) continue;
      const ProblemLook look = problemLook(kind);
      if (look.mark != TriangleMark::None) {
        marks.triangles.resize(mesh.triangleCount(), TriangleMark::None);
        markTriangles(mesh, segmentation, problem, look.mark, marks.triangles);
        continue;
      }
      std::vector<Index> sides = problem.sides.empty() ? facesSides(mesh, problem) : problem.sides;
      marks.lines.push_back({std::move(sides), look.color, look.width, look.dashed});
    }
  }
  return marks;
}

}  // namespace chartflood
