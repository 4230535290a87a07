// Models of several parts: core/segment/part_shares and what the methods make of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/charts/chart_stats.h"
#include "core/segment/creases/crease_start.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/part_shares.h"
#include "core/segment/parts/seeds.h"
#include "core/segment/registry.h"
#include "tests/support/part_models.h"
#include "tests/support/segment_inputs.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

Segmentation finishedParts(const SegmentInputs& in, std::size_t charts, SearchKind search,
                           const char* method = "t-flooding") {
  SegmentOptions options;
  options.charts = charts;
  options.search = search;
  const auto stepper = findSegmenter(method)->make(in, options);
  Progress progress;
  EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
  return *stepper->state();
}

/// Charts of each part.
std::vector<std::size_t> chartsOfParts(const Mesh& mesh, const Segmentation& state) {
  std::vector<std::size_t> charts(mesh.componentCount(), 0);
  for (const Index seed : state.seeds) ++charts[mesh.faceComponent()[seed]];
  return charts;
}

/// A ball and crumbs of one to three triangles around it.
std::shared_ptr<const Mesh> ballWithCrumbs(Index around, Index crumbs) {
  test::PartModel model;
  model.addBall({0, 0, 0}, 1, around);
  for (Index i = 0; i < crumbs; ++i) model.addFan({2, 0.02 * i, 0}, 0.01, 1 + i % 3);
  return model.mesh();
}

TEST(PartShares, OfOnePartLeaveWhatIsAskedFor) {
  const auto mesh = test::sampleMesh("sphere", 1000);
  EXPECT_EQ(countWithParts(*mesh, 20).charts, 20u);
  EXPECT_EQ(countWithParts(*mesh, 100000).charts, mesh->faceCount());
}

TEST(PartShares, CrumbsComeOnTop) {
  const auto mesh = ballWithCrumbs(24, 150);
  for (const std::size_t asked : {1u, 20u, 100u, 150u, 151u, 200u}) {
    const PartCount count = countWithParts(*mesh, asked);
    EXPECT_EQ(count.charts, 150 + asked);
    EXPECT_EQ(count.small, 150u);
  }
}

TEST(PartShares, PartsOfAKindShareWhatIsAskedFor) {
  test::PartModel model;
  for (Index i = 0; i < 10; ++i) model.addBall({3.0 * i, 0, 0}, 1, 12);
  const auto mesh = model.mesh();
  EXPECT_EQ(countWithParts(*mesh, 3).charts, 10u);
  EXPECT_EQ(countWithParts(*mesh, 10).charts, 10u);
  EXPECT_EQ(countWithParts(*mesh, 25).charts, 25u);
}

TEST(PartShares, AskingForMoreNeverGivesFewer) {
  test::PartModel model;
  model.addBall({0, 0, 0}, 3, 20);
  for (Index i = 0; i < 60; ++i) model.addBall({8.0 + 3 * i, 0, 0}, 0.1 + 0.01 * i, 8);
  const auto mesh = model.mesh();
  std::size_t before = 0;
  for (std::size_t asked = 1; asked <= 400; ++asked) {
    const std::size_t charts = countWithParts(*mesh, asked).charts;
    ASSERT_GE(charts, asked);
    ASSERT_GE(charts, before) << asked;
    before = charts;
  }
}

TEST(PartShares, ABodyHasAsManyChartsAsAloneWhateverTheSearch) {
  const auto mesh = ballWithCrumbs(90, 150);
  const SegmentInputs in = test::segmentInputs(mesh);
  for (const SearchKind search : {SearchKind::Literal, SearchKind::Fast}) {
    const Segmentation state = finishedParts(in, 20, search);
    test::expectValid(*mesh, *in.gaussArea, state);
    const auto charts = chartsOfParts(*mesh, state);
    EXPECT_EQ(charts[0], 20u);
    EXPECT_EQ(*std::max_element(charts.begin() + 1, charts.end()), 1u);
  }
}

TEST(PartShares, ABodyHasAsManyChartsAsAloneWithEveryMethod) {
  const auto mesh = ballWithCrumbs(30, 40);
  const SegmentInputs in = test::segmentInputs(mesh);
  for (const char* method : {"vsa", "mcgim"}) {
    const auto charts = chartsOfParts(*mesh, finishedParts(in, 12, SearchKind::Literal, method));
    EXPECT_EQ(charts[0], 12u) << method;
    EXPECT_EQ(*std::max_element(charts.begin() + 1, charts.end()), 1u) << method;
  }
}

TEST(PartShares, ClosedCrumbsTakeNothingThoughTheirGaussAreaIsThatOfABall) {
  test::PartModel model;
  model.addBall({0, 0, 0}, 1, 26);
  for (Index i = 0; i < 24; ++i) model.addTetrahedron({2, 0.1 * i, 0}, 1.0 / 60);
  const auto mesh = model.mesh();
  const SegmentInputs in = test::segmentInputs(mesh);
  for (const std::size_t asked : {20u, 40u}) {
    const auto charts = chartsOfParts(*mesh, finishedParts(in, asked, SearchKind::Literal));
    EXPECT_EQ(charts[0], asked);
    EXPECT_EQ(*std::max_element(charts.begin() + 1, charts.end()), 1u);
  }
}

TEST(PartShares, ChartsOfABodyAreAsEvenAndTheirSeamsAsShortAsAlone) {
  test::PartModel alone, among;
  alone.addBall({0, 0, 0}, 1, 40);
  among.addBall({0, 0, 0}, 1, 40);
  // Closed crumbs have twenty times the Gauss area of a chart of the ball.
  for (Index i = 0; i < 30; ++i) among.addTetrahedron({1.2, 0.03 * i, 0}, 0.01);
  std::vector<double> spread, seams;
  for (const auto& model : {alone, among}) {
    const SegmentInputs in = test::segmentInputs(model.mesh());
    const Segmentation state = finishedParts(in, 20, SearchKind::Literal);
    std::vector<double> ball;
    for (std::size_t c = 0; c < state.chartCount; ++c) {
      if (in.mesh->faceComponent()[state.seeds[c]] == 0) ball.push_back(state.areas.gaussArea[c]);
    }
    ASSERT_EQ(ball.size(), 20u);
    spread.push_back(balanceOf(ball).stdOverMean());
    seams.push_back(measureCharts(*in.mesh, state).seamLength);
  }
  EXPECT_LE(spread[1], 0.03);
  EXPECT_NEAR(seams[1], seams[0], 0.05 * seams[0]);
}

TEST(PartShares, AFlatPartGetsOneChart) {
  test::PartModel model;
  model.addBall({0, 0, 0}, 1, 20);
  model.addGrid({4, 0, 0}, 5, 10);
  const auto mesh = model.mesh();
  const auto charts =
      chartsOfParts(*mesh, finishedParts(test::segmentInputs(mesh), 20, SearchKind::Literal));
  EXPECT_EQ(charts, (std::vector<std::size_t>{19, 1}));
}

TEST(PartShares, PartsOfEqualGaussAreaGetChartsAlikeWhateverTheirSize) {
  test::PartModel model;
  for (const double radius : {1.0, 0.9, 0.7, 0.5}) {
    model.addBall({4 * radius, 9 * radius, 0}, radius, 40);
  }
  const auto mesh = model.mesh();
  const SegmentInputs in = test::segmentInputs(mesh);
  for (const SearchKind search : {SearchKind::Literal, SearchKind::Fast}) {
    const Segmentation state = finishedParts(in, 20, search);
    EXPECT_EQ(chartsOfParts(*mesh, state), (std::vector<std::size_t>{5, 5, 5, 5}));
    EXPECT_LE(balanceOf(state.areas.gaussArea).stdOverMean(), 0.1);
  }
}

}  // namespace
}  // namespace chartflood
