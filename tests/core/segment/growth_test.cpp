// Known answers of the two methods that grow charts by normals.

#include <algorithm>
#include <queue>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include "core/charts/chart_stats.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/growth/mcgim_price.h"
#include "core/segment/growth/vsa.h"
#include "core/segment/growth/vsa_regions.h"
#include "core/segment/parts/balance.h"
#include "core/segment/registry.h"
#include "tests/support/segment_inputs.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

std::unique_ptr<Stepper> finished(const char* method, const SegmentInputs& in,
                                  const SegmentOptions& options) {
  auto stepper = findSegmenter(method)->make(in, options);
  Progress progress;
  EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
  return stepper;
}

SegmentOptions charts(std::size_t count) {
  SegmentOptions options;
  options.charts = count;
  options.refine.kind = RefineKind::None;
  return options;
}

TEST(Vsa, FlatSidesAreFoundExactly) {
  const auto cube = test::segmentInputs(test::sampleMesh("cube", 1200));
  const auto state = finished("vsa", cube, charts(6))->state();
  EXPECT_LT(vsaCost(*cube.mesh, state->label, 6), 1e-9);
  const auto block = test::segmentInputs(test::sampleMesh("l-block", 1500));
  const auto sides = finished("vsa", block, charts(8))->state();
  EXPECT_LT(vsaCost(*block.mesh, sides->label, 8), 1e-9);
}

/// Its sides are flat, but not along an axis: costs that should be 0 are what rounding left.
std::shared_ptr<const Mesh> tiltedCube() {
  const auto cube = test::sampleMesh("cube", 48);
  InputMesh input = test::copyInput(*cube);
  const glm::dmat3 turn{{0.8, 0.36, 0.48}, {-0.6, 0.48, 0.64}, {0, -0.8, 0.6}};
  for (glm::dvec3& p : input.positions) p = turn * (p + glm::dvec3(0.3));
  return test::rebuild(std::move(input));
}

class ManyCharts : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, ManyCharts, testing::Values("vsa", "mcgim"));

TEST_P(ManyCharts, UpToOneForEachFaceAreFound) {
  const auto in = test::segmentInputs(tiltedCube());
  const std::size_t faces = in.mesh->faceCount();
  for (std::size_t count = 1; count <= faces; count += count < faces - 3 ? 4 : 1) {
    const auto state = finished(GetParam(), in, charts(count))->state();
    EXPECT_EQ(state->chartCount, count);
    test::expectValid(*in.mesh, *in.gaussArea, *state);
  }
}

TEST(Vsa, KeepsTheCheapestRoundAndFitsTheMinimiser) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 3000));
  for (const VsaSeeding seeding :
       {VsaSeeding::OneByOne, VsaSeeding::Doubling, VsaSeeding::Random}) {
    SegmentOptions options = charts(12);
    options.vsa.seeding = seeding;
    const auto stepper = finished("vsa", in, options);
    const auto state = stepper->state();
    test::expectValid(*in.mesh, *in.gaussArea, *state);
    const double cost = vsaCost(*in.mesh, state->label, 12);
    EXPECT_NEAR(cost, stepper->history()[stepper->bestIteration()].cost, 1e-9 * cost);
    for (const IterationSummary& round : stepper->history()) {
      if (round.seeds.size() < 12) continue;
      EXPECT_GE(round.cost, cost * (1 - 1e-12));
    }
  }
  // Any other proxy than the fitted one costs more, and E = 2 (A - |S|).
  auto faces = test::segmentInputs(test::sampleMesh("bumps", 3000)).mesh->faceCount();
  std::vector<GrowthFace> patch;
  for (std::size_t i = 0; i < std::min<std::size_t>(faces, 50); ++i) {
    GrowthFace face;
    const float x = 0.01f * static_cast<float>(i);
    face.normal = glm::normalize(glm::vec3(x, x * x, 1.0f));
    face.area = 1.0f + x;
    face.label = 0;
    patch.push_back(face);
  }
  const std::vector<glm::dvec3> none(1, glm::dvec3(0));
  const VsaRegion region = fitRegions(patch, none)[0];
  EXPECT_NEAR(region.cost, 2 * (region.area - glm::length(region.sum)), 1e-5 * region.area);
  for (const glm::dvec3 shift : {glm::dvec3(0.01, 0, 0), glm::dvec3(0, -0.01, 0)}) {
    const glm::dvec3 other = glm::normalize(region.normal + shift);
    double cost = 0;
    for (const GrowthFace& face : patch) {
      const glm::dvec3 d = glm::dvec3(face.normal) - other;
      cost += static_cast<double>(face.area) * glm::dot(d, d);
    }
    EXPECT_GT(cost, region.cost);
  }
}

TEST(Vsa, TeleportationOnlyLowersTheCost) {
  const auto in = test::segmentInputs(test::sampleMesh("rocket", 4000));
  SegmentOptions options = charts(15);
  options.maxIterations = 500;
  const auto with = finished("vsa", in, options)->state();
  options.vsa.teleport = false;
  const auto without = finished("vsa", in, options)->state();
  EXPECT_LE(vsaCost(*in.mesh, with->label, 15), vsaCost(*in.mesh, without->label, 15));
}

/// Refined borders are shorter, and the method's own cost stays what growth made it, or falls.
class RefinedGrowth : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, RefinedGrowth, testing::Values("vsa", "mcgim"));

TEST_P(RefinedGrowth, ShortensSeamsAndKeepsItsCost) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 6000));
  const bool vsa = GetParam() == std::string("vsa");
  const GrowthGraph graph = buildGrowthGraph(*in.mesh);
  const auto cost = [&](const Segmentation& state) {
    if (vsa) return vsaCost(*in.mesh, state.label, state.chartCount);
    GrowthStart start{state.seeds, {}};
    for (const Index seed : state.seeds) start.normals.emplace_back(graph.faces[seed].normal);
    const auto price = makeMcgimPrice(graph, start, 1);
    price->fit(state.label);
    return price->total(state.label);
  };
  const auto lengthOf = [&](const Segmentation& state) {
    return measureCharts(*in.mesh, state).seamLength;
  };
  const auto grown = finished(GetParam(), in, charts(15))->state();
  for (const RefineKind kind : {RefineKind::Cuts, RefineKind::Moves}) {
    SegmentOptions options = charts(15);
    options.refine.kind = kind;
    const auto refined = finished(GetParam(), in, options)->state();
    test::expectValid(*in.mesh, *in.gaussArea, *refined);
    EXPECT_LT(lengthOf(*refined), 0.95 * lengthOf(*grown));
    EXPECT_LT(cost(*refined), 1.02 * cost(*grown));
  }
}

TEST(Mcgim, SixChartsOfACubeAreItsSides) {
  const auto in = test::segmentInputs(test::sampleMesh("cube", 1200));
  const auto state = finished("mcgim", in, charts(6))->state();
  EXPECT_LT(vsaCost(*in.mesh, state->label, 6), 1e-9);
}

/// Nearest seed of each face over the dual graph by plain Dijkstra, and the distance.
std::vector<double> distancesToSeeds(const Mesh& mesh, const std::vector<Index>& seeds) {
  const auto centroid = faceCentroids(mesh);
  std::vector<double> distance(mesh.faceCount(), 1e300);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index seed : seeds) queue.emplace(distance[seed] = 0, seed);
  while (!queue.empty()) {
    const auto [here, face] = queue.top();
    queue.pop();
    if (here > distance[face]) continue;
    for (Index s = 3 * mesh.triangleBegin(face); s < 3 * mesh.triangleBegin(face + 1); ++s) {
      if (mesh.opposite()[s] == kNone) continue;
      const Index next = mesh.faceOf(mesh.opposite()[s] / 3);
      const double there = here + glm::length(centroid[face] - centroid[next]);
      if (there < distance[next]) queue.emplace(distance[next] = there, next);
    }
  }
  return distance;
}

TEST(Mcgim, LargeLambdaGivesVoronoiCells) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 3000));
  SegmentOptions options = charts(7);
  options.mcgim.lambda = 1e6;
  const auto state = finished("mcgim", in, options)->state();
  const auto nearest = distancesToSeeds(*in.mesh, state->seeds);
  std::size_t elsewhere = 0;
  for (Index c = 0; c < 7; ++c) {
    const auto own = distancesToSeeds(*in.mesh, {state->seeds[c]});
    for (Index f = 0; f < own.size(); ++f) {
      elsewhere += state->label[f] == c && own[f] > nearest[f] * (1 + 1e-4);
    }
  }
  EXPECT_EQ(elsewhere, 0u);
}

TEST(Mcgim, DisksStayDisksAndRunningNormalsAreValid) {
  const auto in = test::segmentInputs(test::sampleMesh("torus", 2000));
  SegmentOptions options = charts(8);
  options.mcgim.disks = true;
  test::expectValid(*in.mesh, *in.gaussArea, *finished("mcgim", in, options)->state());
  options.mcgim = {.runningNormals = true};
  test::expectValid(*in.mesh, *in.gaussArea, *finished("mcgim", in, options)->state());
}

class Growth : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, Growth, testing::Values("vsa", "mcgim"));

TEST_P(Growth, OneChartAFaceAndFlatGround) {
  const auto sphere = test::segmentInputs(test::sampleMesh("sphere", 300));
  EXPECT_EQ(finished(GetParam(), sphere, charts(100000))->state()->chartCount,
            sphere.mesh->faceCount());
  const auto plane = test::segmentInputs(test::grid(8, false));
  const auto state = finished(GetParam(), plane, charts(5))->state();
  EXPECT_EQ(state->chartCount, 5u);
  test::expectValid(*plane.mesh, *plane.gaussArea, *state);
}

TEST_P(Growth, LockedSeedsStay) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 2000));
  SegmentOptions options = charts(6);
  options.seeds = {100, 700};
  options.locked = {700};
  const auto seeds = finished(GetParam(), in, options)->state()->seeds;
  EXPECT_EQ(seeds.size(), 6u);
  EXPECT_NE(std::find(seeds.begin(), seeds.end(), Index{700}), seeds.end());
}

/// What of each chart even growth evens out: L2,1 errors, costs of paths or areas.
Balance balanceOfAreas(const Mesh& mesh, const Segmentation& state) {
  std::vector<double> area(state.chartCount, 0);
  const FaceValues faces = faceAreas(mesh);
  for (std::size_t f = 0; f < state.label.size(); ++f) area[state.label[f]] += faces[f];
  return balanceOf(area);
}

Balance balanceOfErrors(const Mesh& mesh, const Segmentation& state) {
  GrowthGraph graph = buildGrowthGraph(mesh);
  for (std::size_t f = 0; f < state.label.size(); ++f) graph.faces[f].label = state.label[f];
  std::vector<double> errors;
  const std::vector<glm::dvec3> none(state.chartCount, glm::dvec3(0));
  for (const VsaRegion& region : fitRegions(graph.faces, none)) errors.push_back(region.cost);
  return balanceOf(errors);
}

TEST_P(ManyCharts, GrowToTheSameArea) {
  const auto in = test::segmentInputs(test::sampleMesh("rocket", 4000));
  SegmentOptions options = charts(12);
  const double before =
      balanceOfAreas(*in.mesh, *finished(GetParam(), in, options)->state()).stdOverMean();
  options.even = EvenGrowth::Area;
  const auto stepper = finished(GetParam(), in, options);
  const auto state = stepper->state();
  test::expectValid(*in.mesh, *in.gaussArea, *state);
  EXPECT_LT(balanceOfAreas(*in.mesh, *state).stdOverMean(), std::min(0.1, 0.5 * before));
  // Rounds come out again from what the history has of them, the even ones with their offsets.
  Progress progress;
  const auto log = stepper->replay(stepper->bestIteration(), progress);
  for (std::size_t i = 0; i < log->size(); ++i) {
    ASSERT_EQ(state->label[(*log)[i].face], (*log)[i].chart);
  }
}

/// Figures of the paper's first future work: worst chart over the mean, deviation over the mean,
/// and what it costs.
struct EvenBar {
  const char* mesh;
  double deviation, energy;
};
class EvenErrors : public testing::TestWithParam<EvenBar> {};
INSTANTIATE_TEST_SUITE_P(Meshes, EvenErrors,
                         testing::Values(EvenBar{"rocker-arm.obj", 0.07, 1.4},
                                         EvenBar{"homer.obj", 0.05, 1.25},
                                         EvenBar{"armadillo-80354.ply", 0.16, 1.11}),
                         [](const auto& info) { return "Number" + std::to_string(info.index); });

TEST_P(EvenErrors, OfVsaAreTheSameForEveryChart) {
  const auto mesh = test::realMesh(GetParam().mesh);
  if (!mesh) GTEST_SKIP() << "the folder of real meshes is absent";
  const auto in = test::segmentInputs(mesh);
  SegmentOptions options = charts(20);
  const auto alone = finished("vsa", in, options)->state();
  options.even = EvenGrowth::Error;
  const auto even = finished("vsa", in, options)->state();
  const Balance balance = balanceOfErrors(*mesh, *even);
  EXPECT_LE(balance.stdOverMean(), GetParam().deviation);
  EXPECT_LE(balance.max / balance.mean, 1.16);
  EXPECT_LE(vsaCost(*mesh, even->label, 20), GetParam().energy * vsaCost(*mesh, alone->label, 20));
  EXPECT_GT(balanceOfErrors(*mesh, *alone).stdOverMean(), 0.3);
}

TEST_P(EvenErrors, OfPathsAreTheSameForEveryChartOfMcgim) {
  const auto mesh = test::realMesh(GetParam().mesh);
  if (!mesh) GTEST_SKIP() << "the folder of real meshes is absent";
  const auto in = test::segmentInputs(mesh);
  SegmentOptions options = charts(20);
  const auto alone = finished("mcgim", in, options);
  options.even = EvenGrowth::Error;
  const auto even = finished("mcgim", in, options);
  // The log has the cost of the path to each face.
  const auto balance = [](const Stepper& stepper) {
    std::vector<double> cost(20, 0);
    const FloodRecord& log = *stepper.record();
    for (std::size_t i = 0; i < log.size(); ++i) {
      cost[log[i].chart] += static_cast<double>(log[i].time);
    }
    return balanceOf(cost);
  };
  const auto cost = [](const Stepper& s) { return s.history()[s.bestIteration()].cost; };
  EXPECT_LE(balance(*even).stdOverMean(), GetParam().deviation);
  EXPECT_LE(balance(*even).max / balance(*even).mean, 1.16);
  EXPECT_GT(balance(*alone).stdOverMean(), 0.2);
  EXPECT_LE(cost(*even), 1.35 * cost(*alone));
}

}  // namespace
}  // namespace chartflood
