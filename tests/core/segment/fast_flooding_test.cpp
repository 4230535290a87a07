// The fast search: clusters, the band around their seams, and the rounds on both.

#include "core/segment/fast/fast_flooding.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/charts/chart_stats.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/fast/coarse_graph.h"
#include "core/segment/fast/node_flood.h"
#include "core/segment/fast/seam_band.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/t_flooding.h"
#include "tests/support/segment_inputs.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

PartShares evenShares(const Mesh& mesh) {
  return {std::vector<double>(mesh.componentCount(), 1.0), {}};
}

SegmentOptions fastOptions(std::size_t charts) {
  SegmentOptions options;
  options.charts = charts;
  options.search = SearchKind::Fast;
  return options;
}

std::unique_ptr<Stepper> toTheEnd(const SegmentInputs& in, const SegmentOptions& options) {
  auto stepper = makeTFlooding(in, options);
  Progress progress;
  EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
  return stepper;
}

void expectSameLog(const FloodRecord& a, const FloodRecord& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].face, b[i].face);
    ASSERT_EQ(a[i].chart, b[i].chart);
    ASSERT_EQ(a[i].time, b[i].time);
  }
}

class FastOn : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    mesh_ = test::sampleMesh(GetParam(), 6000);
    in_ = test::segmentInputs(mesh_);
    faceGauss_ = faceGaussArea(*mesh_, *in_.gaussArea);
  }
  NodeGraphSource source() const { return {*mesh_, *in_.gaussArea, faceGauss_, *in_.floodGraph}; }

  std::shared_ptr<const Mesh> mesh_;
  SegmentInputs in_;
  FaceValues faceGauss_;
};
INSTANTIATE_TEST_SUITE_P(Samples, FastOn,
                         testing::Values("rocket", "double-torus", "cube", "bumps", "gear"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(FastOn, ChartsOfClustersHaveTheGaussAreaOfTheirFaces) {
  const CoarseGraph coarse =
      makeCoarseGraph(source(), clusterFaces(*mesh_, {}, 17, std::vector<Index>{3, 17, 1000}));
  std::vector<Index> nodeLabel(coarse.nodeCount());
  for (Index n = 0; n < nodeLabel.size(); ++n) nodeLabel[n] = (n / 40) % 5;
  const std::vector<double> sums = coarse.nodes.chartGauss(nodeLabel, 5);
  const std::vector<Index> label = projectLabels(coarse.nodes, nodeLabel);
  const ChartAreas areas = chartAreas(*mesh_, *in_.gaussArea, faceGauss_, label, 5);
  for (std::size_t c = 0; c < 5; ++c) {
    EXPECT_NEAR(sums[c], areas.gaussArea[c], 1e-9 * std::max(1.0, areas.gaussArea[c]));
  }
  for (Index n = 0; n < coarse.nodeCount(); ++n) {
    EXPECT_EQ(coarse.nodes.nodeOfFace[coarse.start[n]], n);
  }
  for (const Index face : {3u, 17u, 1000u}) {
    EXPECT_EQ(coarse.start[coarse.nodes.nodeOfFace[face]], face);
  }
}

TEST_P(FastOn, FloodsCountWhatTheirChartsHold) {
  const CoarseGraph coarse = makeCoarseGraph(source(), clusterFaces(*mesh_, {}, 9));
  Rng rng(5);
  const std::size_t charts = std::max<std::size_t>(6, mesh_->componentCount());
  const auto seeds =
      placeCoarseSeeds(coarse, mesh_->componentCount(), charts, {}, evenShares(*mesh_), rng);
  NodeFlood flood(*mesh_, coarse.nodes, charts);
  flood.start(seeds, std::vector<double>(charts, 0), true, nullptr);
  flood.take(mesh_->faceCount(), nullptr);
  ASSERT_TRUE(flood.finished());
  const auto whole = flood.labels();
  // In small steps, with a log.
  auto record = std::make_shared<FloodRecord>(mesh_->faceCount());
  flood.start(seeds, std::vector<double>(charts, 0), true, record);
  for (std::size_t step = 1; !flood.finished(); ++step) {
    flood.take(step, nullptr);
    const auto label = flood.labels();
    ASSERT_EQ(record->size(), flood.taken());
    const auto taken =
        std::count_if(label.begin(), label.end(), [](Index chart) { return chart != kNone; });
    ASSERT_EQ(static_cast<std::size_t>(taken), flood.taken());
  }
  EXPECT_EQ(flood.labels(), whole);
  for (std::size_t i = 0; i < record->size(); ++i) {
    ASSERT_EQ(whole[(*record)[i].face], (*record)[i].chart);
  }
}

/// Clusters flooded once, and a cluster of each chart's seed.
struct CoarseCharts {
  CoarseGraph graph;
  std::vector<Index> seeds, label;

  CoarseCharts(const NodeGraphSource& source, std::size_t charts, std::size_t size)
      : graph(makeCoarseGraph(source, clusterFaces(source.mesh, {}, size))) {
    Rng rng(3);
    charts = std::max(charts, source.mesh.componentCount());
    seeds = placeCoarseSeeds(graph, source.mesh.componentCount(), charts, {},
                             evenShares(source.mesh), rng);
    NodeFlood flood(source.mesh, graph.nodes, charts);
    flood.start(seeds, std::vector<double>(charts, 0), true, nullptr);
    flood.take(source.mesh.faceCount(), nullptr);
    label = flood.nodeLabels();
  }
};

TEST_P(FastOn, TheBandLeavesOneConnectedRestWithTheSeedOfEachChart) {
  const CoarseCharts charts(source(), 6, 11);
  for (const std::size_t rings : {1u, 2u, 20u}) {
    const SeamBand band =
        makeSeamBand(source(), charts.graph.nodes, charts.label, charts.seeds, rings);
    const NodeFaces faces(*mesh_, band.nodes.nodeOfFace, band.nodes.nodeCount());
    std::size_t rests = 0;
    for (std::size_t c = 0; c < charts.seeds.size(); ++c) {
      const auto rest = faces.of(band.seeds[c]);
      rests += rest.size();
      EXPECT_NE(std::find(rest.begin(), rest.end(), charts.graph.start[charts.seeds[c]]),
                rest.end());
      // Listed in steps over sides: connected when each but the first has one before it beside it.
      std::vector<bool> seen(mesh_->faceCount(), false);
      for (std::size_t i = 0; i < rest.size(); ++i) {
        bool touches = i == 0;
        for (Index s = 3 * mesh_->triangleBegin(rest[i]); s < 3 * mesh_->triangleBegin(rest[i] + 1);
             ++s) {
          const Index other = mesh_->opposite()[s];
          touches = touches || (other != kNone && seen[mesh_->faceOf(other / 3)]);
        }
        ASSERT_TRUE(touches);
        ASSERT_EQ(charts.label[charts.graph.nodes.nodeOfFace[rest[i]]], c);
        seen[rest[i]] = true;
      }
    }
    EXPECT_EQ(band.freeFaces + rests, mesh_->faceCount());
  }
}

TEST_P(FastOn, TheBandHoldsWhatAnyGraphOfItsNodesHolds) {
  const CoarseCharts charts(source(), 7, 13);
  const std::vector<glm::dvec3> centroid = faceCentroids(*mesh_);
  for (const std::size_t rings : {1u, 2u, 20u}) {
    const SeamBand band =
        makeSeamBand(source(), charts.graph.nodes, charts.label, charts.seeds, rings);
    const NodeGraph& nodes = band.nodes;
    const NodeFaces facesOf(*mesh_, nodes.nodeOfFace, nodes.nodeCount());
    std::vector<Index> sideOfArc;
    NodeGraph plain =
        buildNodeGraph(source(), nodes.nodeOfFace, band.freeFaces + band.seeds.size(), sideOfArc);
    const auto waysFrom = [&](Index node) {
      return std::span(plain.flood.arcs)
          .subspan(plain.flood.arcBegin[node],
                   plain.flood.arcBegin[node + 1] - plain.flood.arcBegin[node]);
    };
    const auto centroidOf = [&](Index node) { return centroid[facesOf.of(node)[0]]; };
    if (mesh_->facesAreTriangles()) {
      // The same delays to the last bit; how long they are is checked where both are faces.
      for (Index node = 0; node < band.freeFaces; ++node) {
        const FloodFace& record = nodes.flood.faces[node];
        for (FloodArc& way : waysFrom(node)) {
          for (int k = 0; k < 3; ++k) {
            if (record.neighbour[k] == kNone || record.neighbour[k] >> 2 != way.face) continue;
            way.delay = record.delay[k];
            EXPECT_NEAR(way.delay, glm::length(centroidOf(node) - centroidOf(way.face)), 1e-6);
          }
        }
      }
      for (std::size_t c = 0, i = 0; c < band.seeds.size(); ++c) {
        for (; i < nodes.flood.hubs[c].sideEnd; ++i) {
          const FloodHubSide& at = nodes.flood.hubSides[i];
          for (FloodArc& way : waysFrom(band.seeds[c])) {
            if (way.face == at.side >> 2) way.delay = at.delay;
          }
        }
      }
    }
    const std::size_t count = band.seeds.size();
    std::vector<Index> some(nodes.nodeCount());
    for (Index n = 0; n < some.size(); ++n) {
      some[n] = (n < band.freeFaces ? n / 50 : n) % static_cast<Index>(count);
    }
    const std::vector<double> areas = nodes.chartGauss(some, count);
    const std::vector<double> plainAreas = plain.chartGauss(some, count);
    for (std::size_t c = 0; c < count; ++c) EXPECT_NEAR(areas[c], plainAreas[c], 1e-9);
    if (!mesh_->facesAreTriangles()) continue;

    ASSERT_EQ(nodes.flood.hubs.size(), count);
    for (std::size_t c = 0; c < count; ++c) {
      float& gain = plain.flood.gain[band.freeFaces + c];
      EXPECT_NEAR(nodes.flood.hubs[c].gain, gain, 1e-5 * gain + 1e-9);
      gain = nodes.flood.hubs[c].gain;  // summed in another order
    }
    std::vector<double> offsets(count);
    for (std::size_t c = 0; c < count; ++c) offsets[c] = 0.01 * static_cast<double>(c % 3);
    std::vector<Index> expected, label;
    // Labels of all widths.
    for (const std::size_t room : {count, std::size_t{300}, std::size_t{70000}}) {
      for (const bool lookahead : {true, false}) {
        const auto flood = makeFlood(nodes.flood, room);
        const auto slow = makeFlood(plain.flood, room);
        for (int again = 0; again < 2; ++again) {
          flood->start(band.seeds, offsets, lookahead, nullptr);
          slow->start(band.seeds, offsets, lookahead, nullptr);
          flood->advance(mesh_->faceCount(), nullptr);
          slow->advance(mesh_->faceCount(), nullptr);
        }
        EXPECT_TRUE(flood->finished());
        flood->copyLabels(label);
        slow->copyLabels(expected);
        EXPECT_EQ(label, expected);
      }
    }
  }
}

TEST_P(FastOn, WithoutALogTheLabelsAreTheSame) {
  SegmentOptions options = fastOptions(8);
  const auto logged = toTheEnd(in_, options);
  options.record = false;
  const auto plain = toTheEnd(in_, options);
  EXPECT_EQ(plain->state()->label, logged->state()->label);
  EXPECT_EQ(plain->history().size(), logged->history().size());
  EXPECT_EQ(plain->record(), nullptr);
}

// Other seeds are tried on a thread of their own where there is one.
TEST_P(FastOn, RoundsAreTheSameOnAnyNumberOfThreads) {
  setThreadCount(1);
  const auto alone = toTheEnd(in_, fastOptions(8));
  setThreadCount(3);
  const auto together = toTheEnd(in_, fastOptions(8));
  setThreadCount(0);
  EXPECT_EQ(together->state()->label, alone->state()->label);
  ASSERT_EQ(together->history().size(), alone->history().size());
  for (std::size_t i = 0; i < alone->history().size(); ++i) {
    EXPECT_EQ(together->history()[i].seeds, alone->history()[i].seeds);
    EXPECT_EQ(together->history()[i].stdOverMean, alone->history()[i].stdOverMean);
  }
}

TEST_P(FastOn, MayBeDroppedOrCancelledAtAnyRound) {
  setThreadCount(2);
  const auto whole = toTheEnd(in_, fastOptions(8));
  for (std::size_t rounds = 0; rounds < whole->history().size(); rounds += 3) {
    const auto stepper = makeTFlooding(in_, fastOptions(8));
    Progress progress, stopped;
    if (rounds > 0) stepper->advance(StepUnit::Flood, rounds, progress);
    stopped.cancel();
    EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, stopped), StepOutcome::Cancelled);
    if (rounds % 2 == 0) continue;  // dropped
    EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
    EXPECT_EQ(stepper->state()->label, whole->state()->label);
  }
  setThreadCount(0);
}

TEST_P(FastOn, MakesTheLogOfAnyRoundAgain) {
  const auto stepper = makeTFlooding(in_, fastOptions(8));
  Progress progress;
  std::vector<std::shared_ptr<const FloodRecord>> logs;
  while (!stepper->finished()) {
    const std::size_t before = stepper->history().size();
    stepper->advance(StepUnit::Flood, 1, progress);
    if (stepper->history().size() > before) logs.push_back(stepper->record());
  }
  ASSERT_EQ(logs.size(), stepper->history().size());
  EXPECT_FALSE(stepper->history().back().band.empty());
  for (std::size_t round = 0; round < logs.size(); ++round) {
    expectSameLog(*stepper->replay(round, progress), *logs[round]);
  }
  // The log of the end is that of the round that was kept.
  expectSameLog(*stepper->record(), *logs[stepper->state()->iteration]);
}

TEST_P(FastOn, GoesBackToAnyRoundAndOnFromThere) {
  const auto stepper = makeTFlooding(in_, fastOptions(8));
  Progress progress;
  std::vector<std::vector<Index>> labels;
  while (!stepper->finished()) {
    const std::size_t before = stepper->history().size();
    stepper->advance(StepUnit::Flood, 1, progress);
    if (stepper->history().size() > before) labels.push_back(stepper->state()->label);
  }
  for (const std::size_t round : {labels.size() - 1, std::size_t{1}, labels.size() / 2}) {
    ASSERT_EQ(stepper->adopt(round, progress), StepOutcome::Advanced);
    if (round != stepper->bestIteration() || !stepper->state()->refined) {
      EXPECT_EQ(stepper->state()->label, labels[round]) << round;
    }
    EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
    test::expectValid(*mesh_, *in_.gaussArea, *stepper->state());
  }
}

TEST_P(FastOn, TheSameLabelsComeFromSeedsAndOffsetsAlone) {
  const auto stepper = toTheEnd(in_, fastOptions(8));
  FloodStart last;
  SegmentOptions options = fastOptions(8);
  options.onFlood = [&](const FloodBegun& begun) { last = begun.start; };
  const auto told = toTheEnd(in_, options);
  ASSERT_EQ(told->state()->label, stepper->state()->label);
  EXPECT_EQ(last.fast->band.size(), 8u);
  SegmentOptions again = fastOptions(8);
  again.seeds = last.seeds;
  again.offsets = last.offsets;
  again.fast = *last.fast;
  again.maxIterations = 1;
  EXPECT_EQ(toTheEnd(in_, again)->state()->label, stepper->state()->label);
}

TEST_P(FastOn, LockedSeedsStayAndGivenOnesBegin) {
  SegmentOptions options = fastOptions(8);
  options.seeds = {11, 12, 2000};
  options.locked = {12, 2000};
  std::vector<Index> first;
  options.onFlood = [&](const FloodBegun& begun) {
    if (first.empty()) first = begun.start.seeds;
  };
  const auto stepper = toTheEnd(in_, options);
  const auto state = stepper->state();
  EXPECT_TRUE(std::equal(options.seeds.begin(), options.seeds.end(), first.begin()));
  EXPECT_EQ(state->seeds[1], 12u);
  EXPECT_EQ(state->seeds[2], 2000u);
  test::expectValid(*mesh_, *in_.gaussArea, *state);
}

TEST_P(FastOn, HistoryTellsTheBalanceOfTheLabels) {
  SegmentOptions options = fastOptions(8);
  const auto stepper = makeTFlooding(in_, options);
  Progress progress;
  while (!stepper->finished()) {
    const std::size_t before = stepper->history().size();
    stepper->advance(StepUnit::Flood, 1, progress);
    if (stepper->history().size() == before) continue;
    EXPECT_NEAR(balanceOf(stepper->state()->areas.gaussArea).stdOverMean(),
                stepper->history().back().stdOverMean, 1e-7);
  }
}

TEST(FastFlooding, IsForMeshesWithFacesEnough) {
  const auto mesh = test::sampleMesh("rocket", 6000);
  EXPECT_TRUE(searchesFast(*mesh, fastOptions(15)));
  EXPECT_FALSE(searchesFast(*mesh, fastOptions(200)));
  EXPECT_FALSE(searchesFast(*mesh, SegmentOptions{}));
  const auto in = test::segmentInputs(mesh);
  SegmentOptions literal;
  literal.charts = 200;
  literal.maxIterations = 2;
  SegmentOptions fast = literal;
  fast.search = SearchKind::Fast;
  EXPECT_EQ(toTheEnd(in, fast)->state()->label, toTheEnd(in, literal)->state()->label);
}

TEST(FastFlooding, RefusesSeedsThatAreNone) {
  const auto in = test::segmentInputs(test::sampleMesh("rocket", 6000));
  SegmentOptions options = fastOptions(8);
  options.seeds = {5, 5};
  EXPECT_ANY_THROW(makeTFlooding(in, options));
  options.seeds = {4000000};
  EXPECT_ANY_THROW(makeTFlooding(in, options));
}

class FastGoal : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(RealMeshes, FastGoal,
                         testing::Values("stanford-bunny.obj", "armadillo-80354.ply",
                                         "igea-151558.ply", "homer.obj", "rocker-arm.obj"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

TEST_P(FastGoal, ChartsAreAsEvenAndSeamsAsShortAsOfTheLiteralSearch) {
  const auto mesh = test::realMesh(GetParam());
  if (!mesh) GTEST_SKIP() << "the folder of real meshes is absent";
  const auto in = test::segmentInputs(mesh);
  SegmentOptions options;
  options.refine.kind = RefineKind::Moves;
  options.record = false;
  // Single seeds of the generator differ by a factor of two, so that means over some are compared:
  // the smaller a mesh, the more can be had in the same time.
  double unevenness = 0, seams = 0;
  const int count = std::clamp(300000 / static_cast<int>(mesh->faceCount()), 4, 24);
  for (options.rngSeed = 1; options.rngSeed <= static_cast<std::uint32_t>(count);
       ++options.rngSeed) {
    const auto measured = [&](SearchKind search) {
      options.search = search;
      return measureCharts(*mesh, *toTheEnd(in, options)->state());
    };
    const ChartStats literal = measured(SearchKind::Literal), fast = measured(SearchKind::Fast);
    unevenness += std::log(fast.stdOverMean() / literal.stdOverMean()) / count;
    seams += std::log(fast.seamLength / literal.seamLength) / count;
  }
  EXPECT_LE(std::exp(unevenness), 1.05);
  EXPECT_LE(std::exp(seams), 1.05);
}

}  // namespace
}  // namespace chartflood
