// Charts become disks: numbers of cuts known from topology, on shapes and on real meshes.

#include "core/charts/cut_charts.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/charts/boundary_cut.h"
#include "core/charts/tip_cutter.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/registry.h"
#include "tests/core/charts/cut_support.h"
#include "tests/support/segment_inputs.h"

namespace chartflood {
namespace {

using test::checkDisks;
using test::countOf;
using test::cutAll;
using test::oneChart;

CutOptions withSearch(HandleSearch search) {
  CutOptions options;
  options.handleSearch = search;
  return options;
}

const HandleSearch kBoth[] = {HandleSearch::Shortest, HandleSearch::Wavefront};

TEST(CutCharts, AnOpenTubeTakesOneMerge) {
  const auto tube = test::tubeGrid(8, 3);
  const auto set = cutAll(*tube, oneChart(*tube));
  checkDisks(*tube, oneChart(*tube), *set);
  ASSERT_EQ(set->charts[0].cuts.size(), 1u);
  EXPECT_EQ(set->charts[0].cuts[0].reason, CutReason::Loop);
  EXPECT_EQ(set->charts[0].cuts[0].sides.size(), 3u) << "straight along the tube";
}

TEST(CutCharts, ATorusTakesOneHandleAndOneMerge) {
  for (const bool triangles : {false, true}) {
    const auto torus = test::torusGrid(12, 6, triangles);
    for (const HandleSearch search : kBoth) {
      const auto set = cutAll(*torus, oneChart(*torus), withSearch(search));
      checkDisks(*torus, oneChart(*torus), *set);
      const CutChart& chart = set->charts[0];
      EXPECT_EQ(countOf(chart, CutReason::Handle), 1u);
      EXPECT_EQ(countOf(chart, CutReason::Loop), 1u);
      EXPECT_EQ(chart.cuts.size(), 2u);
    }
  }
}

TEST(CutCharts, ASphereIsOpenedAlongOnePath) {
  for (const char* shape : {"sphere", "cube"}) {
    const auto mesh = test::sampleMesh(shape, 500);
    const auto set = cutAll(*mesh, oneChart(*mesh));
    checkDisks(*mesh, oneChart(*mesh), *set);
    EXPECT_EQ(countOf(set->charts[0], CutReason::Open), 1u);
  }
  const auto cube = test::quadCube();
  checkDisks(*cube, oneChart(*cube), *cutAll(*cube, oneChart(*cube)));
}

TEST(CutCharts, TheSmallestClosedMeshesOpen) {
  const auto tetrahedron = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  const auto set = cutAll(*tetrahedron, oneChart(*tetrahedron));
  checkDisks(*tetrahedron, oneChart(*tetrahedron), *set);
  EXPECT_EQ(set->charts[0].cuts[0].sides.size(), 2u);
  const auto pillow = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  checkDisks(*pillow, oneChart(*pillow), *cutAll(*pillow, oneChart(*pillow)));
}

TEST(CutCharts, ADoubleTorusTakesTwoHandles) {
  const auto mesh = test::sampleMesh("double-torus", 3000);
  for (const HandleSearch search : kBoth) {
    const auto set = cutAll(*mesh, oneChart(*mesh), withSearch(search));
    checkDisks(*mesh, oneChart(*mesh), *set);
    EXPECT_EQ(countOf(set->charts[0], CutReason::Handle), 2u);
  }
}

TEST(CutCharts, TheLoopThatIsReachedFirstIsJoinedFirst) {
  // A strip of 9 x 3 quads with two holes: the one nearer to the outer loop comes first.
  const auto whole = test::grid(9, false);
  std::vector<Index> label(whole->faceCount(), 0);
  label[1 * 9 + 4] = 1;  // one row of quads below it
  label[4 * 9 + 4] = 2;  // two rows of quads between the holes, four above
  Segmentation segmentation;
  segmentation.chartCount = 3;
  segmentation.label = label;
  const auto set = cutAll(*whole, segmentation);
  checkDisks(*whole, segmentation, *set);
  const auto& cuts = set->charts[0].cuts;
  ASSERT_EQ(cuts.size(), 2u);
  EXPECT_EQ(cuts[0].sides.size(), 1u);
  EXPECT_EQ(cuts[1].sides.size(), 2u) << "from the first hole, which now belongs to the boundary";
}

TEST(CutCharts, HandlesOfChartsWithHolesOpen) {
  for (const bool triangles : {false, true}) {
    for (const std::set<Index>& holes :
         {std::set<Index>{0}, {0, 20}, {0, 2, 4, 21, 23, 25}, {0, 7, 14, 21, 28, 35}}) {
      const auto mesh = test::torusGrid(12, 6, triangles, holes);
      for (const HandleSearch search : kBoth) {
        const auto set = cutAll(*mesh, oneChart(*mesh), withSearch(search));
        checkDisks(*mesh, oneChart(*mesh), *set);
        EXPECT_EQ(countOf(set->charts[0], CutReason::Handle), 1u);
      }
    }
  }
}

TEST(CutCharts, AnArcBetweenPointsOfOneBorderOpensAHandle) {
  // All quads of one ring around the tube but one: the shortest cut spans the remaining quad.
  const auto mesh = test::torusGrid(12, 6, false, {0, 1, 2, 3, 4});
  const auto set = cutAll(*mesh, oneChart(*mesh));
  checkDisks(*mesh, oneChart(*mesh), *set);
  const Cut& cut = set->charts[0].cuts[0];
  ASSERT_EQ(cut.reason, CutReason::Handle);
  EXPECT_EQ(cut.sides.size(), 1u);
  EXPECT_NE(mesh->sideStart(cut.sides[0]), mesh->sideEnd(cut.sides[0]));
}

TEST(CutCharts, SegmentsOfEveryKindBecomeDisks) {
  for (const char* shape : {"torus", "double-torus", "tube", "rocket", "knot"}) {
    const auto mesh = test::sampleMesh(shape, 2000);
    for (const Index count : {2u, 3u, 7u}) {
      const Segmentation segmentation = test::bands(*mesh, count);
      for (const HandleSearch search : kBoth) {
        checkDisks(*mesh, segmentation, *cutAll(*mesh, segmentation, withSearch(search)));
      }
    }
  }
}

TEST(CutCharts, SwitchesLeaveAProblemToRead) {
  const auto torus = test::torusGrid(12, 6, false);
  CutOptions options;
  options.handles = false;
  EXPECT_EQ(cutAll(*torus, oneChart(*torus), options)->charts[0].problem,
            "it has 1 handle and no border: turn on Cut handles.");
  options.loops = false;
  EXPECT_EQ(cutAll(*torus, oneChart(*torus), options)->charts[0].problem,
            "it has 1 handle and no border: turn on Cut handles and Open into disks.");
  options.handles = true;
  const auto opened = cutAll(*torus, oneChart(*torus), options);
  EXPECT_EQ(opened->charts[0].problem, "it has 2 borders: turn on Open into disks.");
  EXPECT_EQ(opened->charts[0].cuts.size(), 1u);
  const auto sphere = test::sampleMesh("sphere", 300);
  EXPECT_EQ(cutAll(*sphere, oneChart(*sphere), options)->charts[0].problem,
            "it has no border: turn on Open into disks.");
}

TEST(CutCharts, PiecesAndEmptyChartsAreToldApart) {
  const auto grid = test::grid(2, false);
  Segmentation segmentation;
  segmentation.chartCount = 3;
  segmentation.label = {0, 1, 1, 0};
  const auto set = cutAll(*grid, segmentation);
  EXPECT_EQ(set->charts[0].problem, "it is in 2 pieces: each of them needs a chart of its own.");
  EXPECT_EQ(set->charts[2].problem, "it has no faces.");
  EXPECT_TRUE(set->charts[0].cuts.empty());
}

TEST(CutCharts, ACancelledCutReturnsNothing) {
  const auto torus = test::torusGrid(12, 6, false);
  Progress progress;
  progress.cancel();
  EXPECT_EQ(cutCharts(*torus, oneChart(*torus), {}, progress), nullptr);
}

// --- Tips and cuts to the boundary ---

ChartSurface finger(Index length) {
  // A tube closed by a quad at its end.
  const auto tube = test::tubeGrid(4, length);
  std::vector<glm::dvec3> p(tube->positions().begin(), tube->positions().end());
  test::Polygons faces;
  for (Index f = 0; f < tube->faceCount(); ++f) {
    faces.emplace_back(tube->input().face(f).begin(), tube->input().face(f).end());
  }
  const Index top = 4 * length;
  faces.push_back({top, top + 1, top + 2, top + 3});
  const auto mesh = test::meshOf(p, faces);
  return extractCharts(*mesh, std::vector<Index>(mesh->faceCount(), 0), 1).front();
}

TEST(TipCutter, SlitsFingersThatAreLongAgainstTheirRim) {
  // The rim is 4 sqrt(2) long, each ring of quads 0.5 high.
  CutChart chart;
  chart.surface = finger(10);
  chart.topology = topologyOf(chart.surface);
  ASSERT_TRUE(chart.disk());
  CutChart same = chart;
  cutTips(same, 0.95);
  EXPECT_TRUE(same.cuts.empty()) << "5 is less than 0.95 of the rim";
  cutTips(chart, 0.85);
  ASSERT_EQ(chart.cuts.size(), 1u);
  EXPECT_EQ(chart.cuts[0].reason, CutReason::Tip);
  EXPECT_EQ(chart.cuts[0].sides.size(), 10u);
  EXPECT_TRUE(chart.disk());
  EXPECT_EQ(topologyOf(chart.surface), chart.topology);
}

/// A plate of 11 x 5 quads with square tubes of the given heights standing on every third quad of
/// its middle row, each closed by a quad. The rim is 32 long.
CutChart comb(const std::vector<Index>& heights) {
  std::vector<glm::dvec3> p;
  test::Polygons faces;
  for (Index j = 0; j <= 5; ++j) {
    for (Index i = 0; i <= 11; ++i) p.emplace_back(i, j, 0);
  }
  for (Index j = 0; j < 5; ++j) {
    for (Index i = 0; i < 11; ++i) {
      std::vector<Index> ring = {j * 12 + i, j * 12 + i + 1, j * 12 + i + 13, j * 12 + i + 12};
      const Index finger = (i - 2) / 3;
      if (j == 2 && i % 3 == 2 && finger < heights.size()) {
        for (Index k = 1; k <= heights[finger]; ++k) {
          const Index first = static_cast<Index>(p.size());
          for (const Index v : std::vector<Index>(ring)) p.emplace_back(p[v].x, p[v].y, k);
          for (Index c = 0; c < 4; ++c) {
            faces.push_back({ring[c], ring[(c + 1) % 4], first + (c + 1) % 4, first + c});
          }
          ring = {first, first + 1, first + 2, first + 3};
        }
      }
      faces.push_back(ring);
    }
  }
  const auto mesh = test::meshOf(p, faces);
  CutChart chart;
  chart.surface = extractCharts(*mesh, std::vector<Index>(mesh->faceCount(), 0), 1).front();
  chart.topology = topologyOf(chart.surface);
  return chart;
}

TEST(TipCutter, SlitsEachOfEqualFingers) {
  CutChart chart = comb({34, 34, 34});
  ASSERT_TRUE(chart.disk());
  CutChart same = chart;
  cutTips(same, 1.2);
  EXPECT_TRUE(same.cuts.empty());
  cutTips(chart, 1);
  ASSERT_EQ(chart.cuts.size(), 3u);
  for (const Cut& cut : chart.cuts) EXPECT_EQ(cut.sides.size(), 36u) << "two across the plate";
  EXPECT_TRUE(chart.disk());
}

TEST(TipCutter, ShortFingersBesideLongOnesStay) {
  CutChart chart = comb({34, 20, 40});
  cutTips(chart, 1);
  ASSERT_EQ(chart.cuts.size(), 2u);
  EXPECT_EQ(chart.cuts[0].sides.size(), 42u) << "the longest first";
  EXPECT_EQ(chart.cuts[1].sides.size(), 36u);
  CutChart all = comb({34, 20, 40});
  cutTips(all, 0.65);
  EXPECT_EQ(all.cuts.size(), 3u);
}

TEST(BoundaryCut, EveryVertexOfADiskCanBeOpenedTo) {
  const auto grid = test::grid(6, false);
  CutChart chart;
  chart.surface = extractCharts(*grid, std::vector<Index>(36, 0), 1).front();
  chart.topology = topologyOf(chart.surface);
  const auto distance = distanceToBoundary(chart.surface);
  Index opened = 0;
  for (Index v = 0; v < distance.size(); ++v) {
    const glm::dvec3 p = chart.surface.positions[v] * grid->scale() + grid->center();
    const double expected = std::min({p.x, p.y, 6 - p.x, 6 - p.y}) / grid->scale();
    EXPECT_NEAR(distance[v], expected, 1e-12) << "no way along diagonals";
    if (distance[v] == 0) continue;
    CutChart copy = chart;
    ASSERT_TRUE(cutToBoundary(copy, v, CutReason::Relief));
    EXPECT_TRUE(copy.disk());
    EXPECT_NEAR(copy.cuts[0].length, distance[v], 1e-12);
    ++opened;
  }
  EXPECT_EQ(opened, 25u);
}

TEST(BoundaryCut, CutsOneAfterTheOtherKeepADisk) {
  const auto grid = test::grid(9, true);
  CutChart chart;
  chart.surface = extractCharts(*grid, std::vector<Index>(162, 0), 1).front();
  chart.topology = topologyOf(chart.surface);
  std::size_t cuts = 0;
  while (true) {
    const auto distance = distanceToBoundary(chart.surface);
    const auto farthest = std::max_element(distance.begin(), distance.end());
    if (*farthest == 0) break;
    ASSERT_TRUE(
        cutToBoundary(chart, static_cast<Index>(farthest - distance.begin()), CutReason::Relief));
    ASSERT_TRUE(topologyOf(chart.surface).disk());
    ++cuts;
  }
  EXPECT_GT(cuts, 4u);
}

// --- Real meshes ---

Segmentation segmented(std::shared_ptr<const Mesh> mesh, std::size_t charts) {
  const SegmentInputs in = test::segmentInputs(std::move(mesh));
  SegmentOptions options;
  options.charts = charts;
  options.maxIterations = 10;
  const auto stepper = findSegmenter("t-flooding")->make(in, options);
  Progress progress;
  stepper->advance(StepUnit::Converged, 1, progress);
  return *stepper->state();
}

class RealMeshes : public testing::TestWithParam<const char*> {};

TEST_P(RealMeshes, EveryChartBecomesADiskForAnyThreadCount) {
  const auto mesh = test::realMesh(GetParam());
  if (!mesh) GTEST_SKIP() << "no folder of real meshes";
  const Segmentation segmentation =
      segmented(mesh, std::max<std::size_t>(20, mesh->componentCount()));
  for (const HandleSearch search : kBoth) {
    setThreadCount(1);
    const auto one = cutAll(*mesh, segmentation, withSearch(search));
    setThreadCount(2);
    const auto two = cutAll(*mesh, segmentation, withSearch(search));
    setThreadCount(0);
    checkDisks(*mesh, segmentation, *one);
    for (std::size_t c = 0; c < one->charts.size(); ++c) {
      const CutChart &a = one->charts[c], &b = two->charts[c];
      EXPECT_EQ(a.surface.triangles, b.surface.triangles);
      EXPECT_EQ(a.surface.opposite, b.surface.opposite);
      ASSERT_EQ(a.cuts.size(), b.cuts.size());
      for (std::size_t i = 0; i < a.cuts.size(); ++i) EXPECT_EQ(a.cuts[i].sides, b.cuts[i].sides);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(CutCharts, RealMeshes,
                         testing::Values("elephant-with-holes.off", "casting.off", "cheese.off",
                                         "tray-ascii.stl", "greek-helmet-quads.obj", "suzanne.obj"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace_if(
                               name.begin(), name.end(),
                               [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

TEST(CutCharts, AMeshWithManyHandlesBecomesOneDisk) {
  for (const char* file : {"cheese.off", "elephant-with-holes.off"}) {
    const auto mesh = test::realMesh(file);
    if (!mesh) GTEST_SKIP() << "no folder of real meshes";
    checkDisks(*mesh, oneChart(*mesh), *cutAll(*mesh, oneChart(*mesh)));
  }
}

}  // namespace
}  // namespace chartflood
