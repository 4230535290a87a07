// The small rules of sections 3.4 and 3.5: seeds, offsets, convergence, balance.

#include <algorithm>
#include <set>
#include <span>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/flood/build_flood_graph.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/seeds.h"
#include "core/segment/rounds/convergence.h"
#include "core/segment/rounds/offset_steps.h"
#include "core/segment/rounds/offsets.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

PartShares equalWeights(const Mesh& mesh) {
  return {std::vector<double>(mesh.componentCount(), 1.0), {}};
}

TEST(Offsets, PenaliseBySurplusOverTheSmallest) {
  std::vector<double> offsets = {0, 0, 0};
  updateOffsets(offsets, std::vector<double>{1, 3, 2}, 0.5);
  EXPECT_EQ(offsets, (std::vector<double>{0, 1, 0.5}));
  updateOffsets(offsets, std::vector<double>{2, 2, 4}, 0.5);
  EXPECT_EQ(offsets, (std::vector<double>{0, 1, 1.5}));
}

TEST(Offsets, SmallestIsAlwaysZero) {
  std::vector<double> offsets = {1, 2};
  updateOffsets(offsets, std::vector<double>{5, 1}, 0.9);
  EXPECT_EQ(*std::min_element(offsets.begin(), offsets.end()), 0);
}

/// Charts in a row, each of which gains from its neighbours what offsets lack in difference to it.
std::vector<double> areasInARow(const std::vector<double>& offsets) {
  std::vector<double> areas = {7, 3, 9, 1};
  const std::vector<double> seam = {0.2, 0.35, 0.1};
  for (std::size_t i = 0; i < seam.size(); ++i) {
    const double moved = seam[i] * (offsets[i + 1] - offsets[i]);
    areas[i] += moved;
    areas[i + 1] -= moved;
  }
  return areas;
}

TEST(OffsetSteps, EvenOutALinearAnswerWithinItsDegreesOfFreedom) {
  OffsetSteps steps;
  std::vector<double> offsets(4, 0), creeping(4, 0);
  for (int round = 0; round < 5; ++round) {
    steps.update(offsets, areasInARow(offsets));
    OffsetSteps without;
    without.update(creeping, areasInARow(creeping));
  }
  for (const double area : areasInARow(offsets)) EXPECT_NEAR(area, 5, 1e-9);
  EXPECT_GT(balanceOf(areasInARow(creeping)).std, 0.5);
  EXPECT_EQ(*std::min_element(offsets.begin(), offsets.end()), 0);
}

TEST(OffsetSteps, AreAShareOfTheSurplusWhenTheyBegin) {
  OffsetSteps steps;
  const auto first = [&] {
    std::vector<double> offsets = {10, 0};
    steps.update(offsets, std::vector<double>{6, 4});
    return offsets;
  };
  const std::vector<double> begin = first();
  EXPECT_GT(begin[0], 10);
  EXPECT_EQ(begin[1], 0);
  EXPECT_EQ(first(), begin) << "the same round again tells nothing new";
  steps.reset();
  EXPECT_EQ(first(), begin);
}

TEST(Balance, FollowsEquation3) {
  const Balance b = balanceOf(std::vector<double>{1, 2, 3, 6});
  EXPECT_DOUBLE_EQ(b.mean, 3);
  EXPECT_DOUBLE_EQ(b.stdEq3, std::sqrt(14.0));
  EXPECT_DOUBLE_EQ(b.std, std::sqrt(14.0 / 4));
  EXPECT_DOUBLE_EQ(b.max, 6);
  EXPECT_DOUBLE_EQ(b.stdOverMean(), std::sqrt(14.0 / 4) / 3);
  EXPECT_FALSE(balanceOf(std::vector<double>{0, 0}).defined);
  EXPECT_EQ(balanceOf(std::vector<double>{0, 0}).stdOverMean(), 0);
}

TEST(Convergence, PatienceCountsFromTheBest) {
  Convergence c({.maxIterations = 100, .patience = 3, .settlePatience = 0});
  const std::vector<Index> a = {1}, b = {2};
  EXPECT_EQ(c.round(a, b, 5), StopReason::NotStopped);
  EXPECT_EQ(c.round(a, b, 4), StopReason::NotStopped);
  EXPECT_EQ(c.round(a, b, 6), StopReason::NotStopped);
  EXPECT_EQ(c.round(a, b, 4), StopReason::NotStopped);  // equal is no gain
  EXPECT_EQ(c.round(a, b, 7), StopReason::NoImprovement);
  EXPECT_EQ(c.best(), 1u);
}

TEST(Convergence, SettlesBeforeItGivesUp) {
  Convergence c({.maxIterations = 100, .patience = 1, .settlePatience = 2});
  const std::vector<Index> a = {1}, b = {2};
  c.round(a, b, 5);
  EXPECT_EQ(c.round(a, b, 6), StopReason::NotStopped);
  EXPECT_TRUE(c.settling());
  EXPECT_EQ(c.round(a, a, 4), StopReason::NotStopped);
  EXPECT_EQ(c.round(a, a, 4), StopReason::NotStopped);
  EXPECT_EQ(c.round(a, a, 4), StopReason::NoImprovement);
  EXPECT_EQ(c.best(), 2u);
}

TEST(Convergence, LimitsRounds) {
  Convergence c({.maxIterations = 2, .patience = 10});
  const std::vector<Index> a = {1}, b = {2};
  EXPECT_EQ(c.round(a, b, 5), StopReason::NotStopped);
  EXPECT_EQ(c.round(a, b, 4), StopReason::MaxIterations);
}

TEST(Convergence, SeesRestAndCyclesWhereSeedsAreTheWholeState) {
  const std::vector<Index> a = {1, 2}, b = {3, 4}, swapped = {2, 1};
  Convergence still({.offsetsChange = false});
  EXPECT_EQ(still.round(a, a, 1), StopReason::Converged);
  Convergence cycle({.offsetsChange = false});
  EXPECT_EQ(cycle.round(a, b, 1), StopReason::NotStopped);
  EXPECT_EQ(cycle.round(b, swapped, 1), StopReason::Cycle);
  Convergence ignored({.detectCycles = false, .offsetsChange = false});
  EXPECT_EQ(ignored.round(a, a, 1), StopReason::NotStopped);
  Convergence settles({.offsetsChange = true});
  EXPECT_EQ(settles.round(a, a, 1), StopReason::NotStopped);
}

TEST(Convergence, SeesThemWithOffsetsWhereTheseDoNotSettleAsInThePaper) {
  const std::vector<Index> a = {1, 2}, b = {3, 4};
  Convergence rest({.offsetsChange = true, .settlePatience = 0});
  EXPECT_EQ(rest.round(a, a, 1), StopReason::Converged);
  Convergence cycle({.offsetsChange = true, .settlePatience = 0});
  EXPECT_EQ(cycle.round(a, b, 1), StopReason::NotStopped);
  EXPECT_EQ(cycle.round(b, a, 1), StopReason::Cycle);
  Convergence ignored({.detectCycles = false, .offsetsChange = true, .settlePatience = 0});
  EXPECT_EQ(ignored.round(a, a, 1), StopReason::NotStopped);
}

/// Distance of every face to the nearest of `seeds` over the dual graph, by plain relaxation.
std::vector<double> seedDistances(const Mesh& mesh, std::span<const Index> seeds) {
  const auto centroid = faceCentroids(mesh);
  std::vector<double> distance(mesh.faceCount(), 1e9);
  for (const Index seed : seeds) distance[seed] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index s = 0; s < mesh.opposite().size(); ++s) {
      if (mesh.opposite()[s] == kNone) continue;
      const Index f = mesh.faceOf(s / 3), g = mesh.faceOf(mesh.opposite()[s] / 3);
      const double there = distance[f] + glm::length(centroid[f] - centroid[g]);
      if (there >= distance[g] - 1e-12) continue;
      distance[g] = there;
      changed = true;
    }
  }
  return distance;
}

TEST(Seeds, EachIsAmongTheFarthestFaces) {
  for (const char* sample : {"rocket", "tube", "torus"}) {
    const auto mesh = test::sampleMesh(sample, 1500);
    Rng rng(1);
    const auto seeds = placeSeeds(*mesh, 8, {}, equalWeights(*mesh), rng);
    ASSERT_EQ(std::set<Index>(seeds.begin(), seeds.end()).size(), 8u);
    for (std::size_t i = 1; i < seeds.size(); ++i) {
      const auto distance = seedDistances(*mesh, std::span(seeds).first(i));
      const double farthest = *std::max_element(distance.begin(), distance.end());
      EXPECT_NEAR(distance[seeds[i]], farthest, 1e-5 * farthest) << sample << " seed " << i;
    }
  }
}

TEST(Seeds, EveryComponentGetsOne) {
  std::vector<glm::dvec3> p;
  test::Polygons faces;
  for (Index i = 0; i < 30; ++i) {
    p.insert(p.end(), {{3.0 * i, 0, 0}, {3.0 * i + 1, 0, 0}, {3.0 * i, 1, 0}});
    faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto mesh = test::meshOf(p, faces);
  EXPECT_EQ(effectiveChartCount(*mesh, 5), 30u);
  Rng rng(1);
  const auto seeds = placeSeeds(*mesh, 30, {}, equalWeights(*mesh), rng);
  EXPECT_EQ(std::set<Index>(seeds.begin(), seeds.end()).size(), 30u);
}

TEST(Seeds, GoToTheComponentsWithTheMostToShare) {
  // Two separate grids; the first has nine times the weight of the second.
  std::vector<glm::dvec3> p;
  test::Polygons faces;
  for (Index part = 0; part < 2; ++part) {
    const Index base = static_cast<Index>(p.size());
    for (Index y = 0; y <= 10; ++y) {
      for (Index x = 0; x <= 10; ++x) p.emplace_back(x + 20 * part, y, 0);
    }
    for (Index y = 0; y < 10; ++y) {
      for (Index x = 0; x < 10; ++x) {
        const Index a = base + y * 11 + x;
        faces.push_back({a, a + 1, a + 12, a + 11});
      }
    }
  }
  const auto mesh = test::meshOf(p, faces);
  Rng rng(1);
  const auto seeds = placeSeeds(*mesh, 10, {}, PartShares{{9, 1}, {}}, rng);
  EXPECT_EQ(std::count_if(seeds.begin(), seeds.end(), [](Index f) { return f < 100; }), 9);
}

TEST(Seeds, NeverMoreThanFaces) {
  const auto cube = test::quadCube();
  EXPECT_EQ(effectiveChartCount(*cube, 100), 6u);
  Rng rng(3);
  const auto seeds = placeSeeds(*cube, 6, {}, equalWeights(*cube), rng);
  EXPECT_EQ(std::set<Index>(seeds.begin(), seeds.end()).size(), 6u);
}

TEST(Seeds, GivenOnesComeFirst) {
  const auto mesh = test::grid(10, true);
  Rng rng(1);
  const auto seeds = placeSeeds(*mesh, 3, std::vector<Index>{7, 3}, equalWeights(*mesh), rng);
  ASSERT_EQ(seeds.size(), 3u);
  EXPECT_EQ(seeds[0], 7u);
  EXPECT_EQ(seeds[1], 3u);
  EXPECT_THROW(placeSeeds(*mesh, 3, std::vector<Index>{7, 7}, equalWeights(*mesh), rng),
               UsageError);
  EXPECT_THROW(placeSeeds(*mesh, 3, std::vector<Index>{200}, equalWeights(*mesh), rng), UsageError);
}

}  // namespace
}  // namespace chartflood
