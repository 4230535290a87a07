// Minimum cuts between charts: core/segment/max_flow, pair_cut, seam_cuts.

#include <chrono>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/charts/chart_stats.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/borders/max_flow.h"
#include "core/segment/borders/seam_cuts.h"
#include "core/segment/growth/vsa_price.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/parts/face_clusters.h"
#include "tests/core/segment/flooded.h"
#include "tests/support/segmentation_checks.h"

namespace chartflood {
namespace {

/// A dense random graph of few nodes, whose cuts can all be tried.
struct SmallGraph {
  static constexpr Index kNodes = 9;
  MaxFlow::Amount length[kNodes][kNodes] = {};
  MaxFlow::Amount terminal[kNodes] = {};

  explicit SmallGraph(std::uint32_t seed) {
    Rng rng(seed);
    for (Index i = 0; i < kNodes; ++i) {
      terminal[i] = static_cast<MaxFlow::Amount>(rng.below(200)) - 100;
      for (Index j = 0; j < i; ++j) length[i][j] = length[j][i] = rng.below(3) ? rng.below(60) : 0;
    }
  }
  /// What the cut with these nodes on the source's side costs.
  MaxFlow::Amount cost(unsigned source, MaxFlow::Amount shift) const {
    MaxFlow::Amount sum = 0;
    for (Index i = 0; i < kNodes; ++i) {
      const bool in = (source >> i & 1) != 0;
      const MaxFlow::Amount tie = terminal[i] + shift;
      if (in != (tie > 0)) sum += std::abs(tie);
      for (Index j = 0; j < i; ++j) sum += in != ((source >> j & 1) != 0) ? length[i][j] : 0;
    }
    return sum;
  }
  MaxFlow::Amount least(MaxFlow::Amount shift) const {
    MaxFlow::Amount best = std::numeric_limits<MaxFlow::Amount>::max();
    for (unsigned set = 0; set < 1u << kNodes; ++set) best = std::min(best, cost(set, shift));
    return best;
  }
};

TEST(MaxFlow, FindsTheLeastOfAllCutsAndGoesOnFromOneToTheNext) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const SmallGraph graph(seed);
    MaxFlow flow;
    flow.reset(SmallGraph::kNodes);
    Index arc[SmallGraph::kNodes][SmallGraph::kNodes] = {};
    for (Index i = 0; i < SmallGraph::kNodes; ++i) {
      flow.beginNode();
      for (Index j = 0; j < SmallGraph::kNodes; ++j) {
        if (i == j) continue;
        arc[i][j] = flow.addArc(j, graph.length[i][j]);
        if (j > i) continue;
        flow.setReverse(arc[i][j], arc[j][i]);
        flow.setReverse(arc[j][i], arc[i][j]);
      }
      flow.addTerminal(i, graph.terminal[i]);
    }
    flow.endNodes();
    MaxFlow::Amount shift = 0;
    for (const MaxFlow::Amount change : {0, 15, 15, -50, 5}) {
      for (Index i = 0; i < SmallGraph::kNodes; ++i) flow.addTerminal(i, change);
      shift += change;
      flow.solve();
      unsigned set = 0;
      for (Index i = 0; i < SmallGraph::kNodes; ++i) set |= flow.onSourceSide(i) ? 1u << i : 0u;
      EXPECT_EQ(graph.cost(set, shift), graph.least(shift)) << "graph " << seed << " + " << shift;
    }
  }
}

struct SeamFlooded : test::Flooded {
  using test::Flooded::Flooded;
  SeamCuts cuts(SeamCuts::Options options) const {
    options.eta = eta;
    return {*mesh, *gauss, face, state.label, state.chartCount, state.seeds, options};
  }
};

double defects(const ChartStats& stats) {
  double sum = 0;
  for (const auto& chart : stats.charts) sum += static_cast<double>(std::max(0L, 1 - chart.euler));
  return sum;
}

class CutsOn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, CutsOn,
                         testing::Values("rocket", "torus", "double-torus", "tube", "bumps"));

TEST_P(CutsOn, EnergyFallsAndChartsStayWhole) {
  const SeamFlooded f(test::sampleMesh(GetParam(), 6000), 9);
  const ChartStats before = measureCharts(*f.mesh, f.state);
  for (const bool anneal : {true, false}) {
    for (const bool oneSided : {false, true}) {
      SCOPED_TRACE(testing::Message() << "anneal " << anneal << " one-sided " << oneSided);
      SeamCuts cuts = f.cuts({.oneSided = oneSided, .anneal = anneal});
      const double start = cuts.energy();
      Progress progress;
      ASSERT_TRUE(cuts.run(progress));
      EXPECT_LT(cuts.energy(), start);
      const Segmentation after = f.relabelled(cuts.labels());
      test::expectValid(*f.mesh, *f.gauss, after);
      const ChartStats stats = measureCharts(*f.mesh, after);
      EXPECT_LE(defects(stats), defects(before));
      EXPECT_LT(stats.seamLength, before.seamLength);
    }
  }
}

TEST_P(CutsOn, TheRecordPlaysForthAndBack) {
  const SeamFlooded f(test::sampleMesh(GetParam(), 4000), 7);
  SeamCuts cuts = f.cuts({});
  Progress progress;
  cuts.run(progress);
  const SeamRecord& record = cuts.record();
  EXPECT_GT(record.steps.size(), 0u);
  std::vector<Index> label = record.start;
  EXPECT_EQ(label, f.state.label);
  for (std::size_t i = 0; i < record.steps.size(); ++i) record.play(i, label);
  EXPECT_TRUE(std::equal(label.begin(), label.end(), cuts.labels().begin()));
  for (std::size_t i = record.steps.size(); i-- > 0;) record.takeBack(i, label);
  EXPECT_EQ(label, record.start);
}

/// At full weight from the start, without annealing, no step may raise the energy.
TEST(SeamCuts, EnergyNeverRisesAtTemperatureZero) {
  const SeamFlooded f(test::sampleMesh("bumps", 3000), 6);
  SeamCuts cuts = f.cuts({.clusters = false, .anneal = false});
  Progress progress;
  cuts.run(progress);
  const SeamRecord record = cuts.record();
  std::vector<Index> label = record.start;
  double energy = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= record.steps.size(); ++i) {
    const SeamCuts now(*f.mesh, *f.gauss, f.face, label, f.state.chartCount, {}, {.eta = f.eta});
    EXPECT_LE(now.energy(), energy + 1e-9) << "step " << i;
    energy = now.energy();
    if (i < record.steps.size()) record.play(i, label);
  }
}

/// Without balance the shortest seam across a square is straight, whichever column it takes.
TEST(SeamCuts, TeethBecomeAStraightLine) {
  const Index n = 20;
  const auto mesh = test::grid(n, false);
  const GaussArea gauss = computeGaussArea(*mesh, 45);
  const FaceValues face = faceGaussArea(*mesh, gauss);
  const std::vector<glm::dvec3> center = faceCentroids(*mesh);
  const auto [low, high] = std::minmax_element(
      center.begin(), center.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const double step = (high->x - low->x) / (n - 1);
  std::vector<Index> label(mesh->faceCount());
  for (Index f = 0; f < label.size(); ++f) {
    const auto column = std::lround((center[f].x - low->x) / step);
    const auto row = std::lround((center[f].y - low->x) / step);
    label[f] = column < (row % 2 == 0 ? 9 : 11) ? 0 : 1;
  }
  const auto seam = [&](std::span<const Index> labels) {
    std::size_t edges = 0;
    for (Index s = 0; s < mesh->opposite().size(); ++s) {
      const Index other = mesh->opposite()[s];
      if (other == kNone || other < s) continue;
      edges += labels[mesh->faceOf(s / 3)] != labels[mesh->faceOf(other / 3)] ? 1 : 0;
    }
    return edges;
  };
  SeamCuts cuts(*mesh, gauss, face, label, 2, {}, {.weight = 0});
  EXPECT_GT(seam(cuts.labels()), 2 * n);
  Progress progress;
  cuts.run(progress);
  EXPECT_EQ(seam(cuts.labels()), n);
}

/// Every column of a sheet is as short a seam as any other: the method's own cost draws it to the
/// fold, two columns away, and proxies fitted on the way make that cost nothing.
TEST(SeamCuts, TheMethodsOwnCostDrawsTheSeamToTheFold) {
  const Index n = 20;
  InputMesh input = test::copyInput(*test::grid(n, false));
  for (glm::dvec3& p : input.positions) p.z = std::max(0.0, p.x - input.positions[n / 2].x);
  const auto mesh = test::rebuild(std::move(input));
  const GaussArea gauss = computeGaussArea(*mesh, 180);
  const FaceValues face = faceGaussArea(*mesh, gauss);
  const GrowthGraph graph = buildGrowthGraph(*mesh);
  std::vector<Index> label(mesh->faceCount()), sides(mesh->faceCount());
  const std::vector<glm::dvec3> center = faceCentroids(*mesh);
  double fold = 0;
  for (Index f = 0; f < label.size(); ++f) {
    sides[f] = graph.faces[f].normal.x < -0.1f ? 1 : 0;
    if (sides[f] == 0) fold = std::max(fold, center[f].x);
  }
  const double step = std::sqrt(mesh->surfaceArea() / static_cast<double>(n * n));
  for (Index f = 0; f < label.size(); ++f) label[f] = center[f].x < fold + 1.6 * step ? 0 : 1;
  ASSERT_NE(label, sides);
  const auto price = makeVsaPrice(graph.faces, {{0, 0, 1}, {-0.7, 0, 0.7}});
  SeamCuts alone(*mesh, gauss, face, label, 2, {}, {.weight = 0, .anneal = false});
  SeamCuts cuts(*mesh, gauss, face, label, 2, {},
                {.weight = 0, .price = price.get(), .anneal = false});
  Progress progress;
  alone.run(progress);
  EXPECT_TRUE(std::equal(label.begin(), label.end(), alone.labels().begin()));
  cuts.run(progress);
  EXPECT_TRUE(std::equal(sides.begin(), sides.end(), cuts.labels().begin()));
  EXPECT_NEAR(price->total(cuts.labels()), 0, 1e-9);
}

TEST(SeamCuts, StoppedBeforeItBeginsCutsNothing) {
  const SeamFlooded f(test::sampleMesh("bumps", 2000), 6);
  SeamCuts cuts = f.cuts({});
  const std::vector<Index> before(cuts.labels().begin(), cuts.labels().end());
  Progress stopped;
  stopped.cancel();
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(cuts.run(stopped));
  EXPECT_TRUE(cuts.record().steps.empty());
  EXPECT_EQ(std::vector<Index>(cuts.labels().begin(), cuts.labels().end()), before);
  Progress go;
  EXPECT_TRUE(cuts.run(go));
  EXPECT_FALSE(cuts.record().steps.empty());
}

TEST(SeamCuts, AnyThreadsAndCancelledRunsGiveTheSame) {
  const SeamFlooded f(test::sampleMesh("bumps", 20000), 24);
  const auto labels = [&](unsigned threads, bool stop) {
    setThreadCount(threads);
    SeamCuts cuts = f.cuts({});
    Progress go;
    if (!stop) {
      cuts.run(go);
    } else {  // stopped anywhere, over and over, and gone on with
      int stops = 0;
      for (bool done = false; !done && stops < 10000; ++stops) {
        Progress once;
        std::thread hand([&] {
          std::this_thread::sleep_for(std::chrono::microseconds(300) * stops);
          once.cancel();
        });
        done = cuts.run(once);
        hand.join();
      }
      EXPECT_GT(stops, 3);
    }
    setThreadCount(0);
    return std::vector<Index>(cuts.labels().begin(), cuts.labels().end());
  };
  const auto alone = labels(1, false);
  EXPECT_EQ(labels(2, false), alone);
  EXPECT_EQ(labels(2, true), alone);
}

TEST(FaceClusters, AreConnectedPartsOfCharts) {
  const SeamFlooded f(test::sampleMesh("rocket", 5000), 8);
  for (const auto& clusters :
       {clusterFaces(*f.mesh, f.state.label, 6), clusterNearSeams(*f.mesh, f.state.label, 2)}) {
    std::vector<Index> chart(clusters.count, kNone);
    for (Index face = 0; face < clusters.ofFace.size(); ++face) {
      Index& of = chart[clusters.ofFace[face]];
      if (of == kNone) of = f.state.label[face];
      EXPECT_EQ(of, f.state.label[face]);
    }
    Segmentation s = f.state;
    s.label = clusters.ofFace;
    s.chartCount = clusters.count;
    s.seeds.assign(clusters.count, kNone);
    for (Index face = 0; face < s.label.size(); ++face) s.seeds[s.label[face]] = face;
    s.areas = chartAreas(*f.mesh, *f.gauss, f.face, s.label, s.chartCount);
    test::expectValid(*f.mesh, *f.gauss, s);
  }
}

}  // namespace
}  // namespace chartflood
