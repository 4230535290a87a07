// Creases that seams may follow, as against the roughness of a surface:
// core/segment/borders/crease_lines.

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/charts/chart_stats.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/borders/border_refiner.h"
#include "core/segment/borders/crease_lines.h"
#include "tests/core/segment/flooded.h"
#include "tests/support/part_models.h"
#include "tests/support/segment_inputs.h"

namespace chartflood {
namespace {

/// Length of the sharp edges that are lines, and of all, over faces that `wanted` takes.
template <class Wanted>
std::array<double, 2> lengths(const Mesh& mesh, const Wanted& wanted) {
  const GaussArea gauss = computeGaussArea(mesh, 45);
  const std::vector<std::uint8_t> line = creaseLines(mesh, gauss);
  EXPECT_EQ(line.size(), gauss.sharpEdges.size());
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Index s = gauss.sharpEdges[i];
    if (!wanted(mesh.faceOf(s / 3))) continue;
    const auto at = mesh.positions();
    const double length = glm::length(at[mesh.sideStart(s)] - at[mesh.sideEnd(s)]);
    sum[0] += line[i] != 0 ? length : 0;
    sum[1] += length;
  }
  return sum;
}

constexpr auto kEverywhere = [](Index) { return true; };

/// A ball whose vertices are moved by up to `share` of an edge.
InputMesh roughBall(std::size_t triangles, double share) {
  InputMesh input = test::copyInput(*test::sampleMesh("sphere", triangles));
  const double edge = std::sqrt(4 * std::numbers::pi / static_cast<double>(triangles));
  const double radius = glm::length(input.positions.front());
  Rng rng(7);
  for (auto& p : input.positions) {
    for (int k = 0; k < 3; ++k) p[k] += radius * edge * share * (rng.below(2001) / 1000.0 - 1);
  }
  return input;
}

TEST(CreaseLines, AreAllSharpEdgesOfMachineParts) {
  for (const char* sample : {"cube", "l-block", "cylinder", "gear", "knot", "rocket"}) {
    for (const std::size_t triangles : {300, 1000, 6000, 30000}) {
      const auto [lines, all] = lengths(*test::sampleMesh(sample, triangles), kEverywhere);
      EXPECT_GT(all, 0) << sample << ' ' << triangles;
      EXPECT_DOUBLE_EQ(lines, all) << sample << ' ' << triangles;
    }
  }
}

TEST(CreaseLines, AreTheSingleEdgesOfCoarseBoxesBesideLargeParts) {
  test::PartModel model;
  model.addBox({0, 0, 0}, {10, 10, 10}, 12);
  for (int i = 0; i < 5; ++i) model.addBox({i, 0, 11}, {0.2, 0.3, 0.1});
  const auto [lines, all] = lengths(*model.mesh(), kEverywhere);
  EXPECT_GT(all, 6);  // normalised units
  EXPECT_DOUBLE_EQ(lines, all);
}

TEST(CreaseLines, AreNotTheSharpEdgesOfARoughSurface) {
  const auto mesh = test::rebuild(roughBall(8000, 0.55));
  const auto [lines, all] = lengths(*mesh, kEverywhere);
  EXPECT_GT(all, 20) << "the surface is not rough";
  EXPECT_LT(lines, 0.15 * all);
}

/// Each part by itself: a plain box beside a rough ball keeps its creases.
TEST(CreaseLines, OfAPartAreNotLostBesideARoughOne) {
  InputMesh input = roughBall(4000, 0.55);
  const auto ball = static_cast<Index>(test::rebuild(input)->faceCount());
  test::PartModel box;
  box.addBox({5, 5, 5}, {1, 1, 1}, 3);
  const InputMesh other = test::copyInput(*box.mesh());
  const auto shift = static_cast<Index>(input.positions.size());
  input.positions.insert(input.positions.end(), other.positions.begin(), other.positions.end());
  ASSERT_TRUE(input.faceStart.empty());
  for (std::size_t f = 0; f < other.faceCount(); ++f) {
    ASSERT_EQ(other.face(f).size(), 3u);
    for (const Index v : other.face(f)) input.corners.push_back(v + shift);
  }
  const auto mesh = test::rebuild(input);
  const auto ofBox = lengths(*mesh, [&](Index face) { return mesh->inputFace(face) >= ball; });
  const auto ofBall = lengths(*mesh, [&](Index face) { return mesh->inputFace(face) < ball; });
  EXPECT_GT(ofBox[1], 0);
  EXPECT_DOUBLE_EQ(ofBox[0], ofBox[1]);
  EXPECT_LT(ofBall[0], 0.2 * ofBall[1]);
}

/// Of refined borders, over the square root of the surface.
double seamLength(const test::Flooded& f, double creaseWeight) {
  const auto graph = std::make_shared<FloodGraph>(buildFloodGraph(*f.mesh, *f.gauss, {}));
  RefineOptions options;
  options.creaseWeight = creaseWeight;
  BorderRefiner refiner({f.mesh, f.gauss, graph}, f.face, f.state.label, f.state.chartCount,
                        f.state.seeds, options);
  Progress progress;
  EXPECT_TRUE(refiner.run(progress));
  const ChartStats stats = measureCharts(*f.mesh, f.relabelled(refiner.labels()));
  return stats.seamLength / std::sqrt(stats.surfaceArea);
}

/// Seams of a rough surface are as short as if nothing of it were sharp.
TEST(CreaseLines, RoughnessDoesNotLengthenSeams) {
  const test::Flooded f(test::rebuild(roughBall(8000, 0.55)), 30);
  EXPECT_LT(seamLength(f, 0.3), 1.02 * seamLength(f, 1));
}

/// As long as the borders of equal hexagons, nearly.
TEST(CreaseLines, SeamsOfARoughScanAreShort) {
  const auto mesh = test::realMesh("happy-buddha-20000.obj");
  if (!mesh) GTEST_SKIP() << "no folder of real meshes";
  const SegmentInputs in = test::segmentInputs(mesh);
  for (const std::size_t charts : {50, 100}) {
    SegmentOptions options;
    options.charts = charts;
    const auto stepper = makeTFlooding(in, options);
    Progress progress;
    ASSERT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
    const ChartStats stats = measureCharts(*mesh, *stepper->state());
    const double hexagons = 1.86 * std::sqrt(static_cast<double>(charts));
    EXPECT_LT(stats.seamLength / std::sqrt(stats.surfaceArea), 1.15 * hexagons) << charts;
  }
}

}  // namespace
}  // namespace chartflood
