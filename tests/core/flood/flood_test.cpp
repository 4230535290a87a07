// One round of flooding: core/flood (paper section 3.3).

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/flood/build_flood_graph.h"
#include "core/flood/flood.h"
#include "core/flood/min_heap.h"
#include "core/flood/primary_queue.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/parts/seeds.h"
#include "tests/core/flood/plain_flood.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

std::vector<Index> labelsOf(const Flood& flood) {
  std::vector<Index> labels;
  flood.copyLabels(labels);
  return labels;
}

PartShares equalWeights(const Mesh& mesh) {
  return {std::vector<double>(mesh.componentCount(), 1.0), {}};
}

struct Case {
  std::shared_ptr<const Mesh> mesh;
  GaussArea gauss;
  std::vector<Index> seeds;
  std::vector<double> offsets;

  Case(std::shared_ptr<const Mesh> m, std::size_t charts, unsigned rngSeed)
      : mesh(std::move(m)), gauss(computeGaussArea(*mesh, 30)) {
    Rng rng(rngSeed);
    seeds = placeSeeds(*mesh, effectiveChartCount(*mesh, charts), {}, equalWeights(*mesh), rng);
    for (std::size_t i = 0; i < seeds.size(); ++i) offsets.push_back(0.01 * rng.below(100));
  }
};

class FloodOn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, FloodOn,
                         testing::Values("rocket", "torus", "l-block", "tube", "plane", "cube"));

TEST_P(FloodOn, FastFloodsEqualThePlainOne) {
  for (const std::size_t charts : {1u, 7u, 40u, 300u}) {
    for (const double power : {1.0, 3.0, 2.5}) {
      const Case c(test::sampleMesh(GetParam(), 2500), charts, 5);
      const FloodSpeeds speeds{power, 1e-3, 1e-3};
      const FloodGraph packed = buildFloodGraph(*c.mesh, c.gauss, speeds);
      const FloodGraph arcs = buildFloodGraph(*c.mesh, c.gauss, speeds, FloodLayout::Arcs);
      ASSERT_EQ(packed.packed(), c.mesh->facesAreTriangles());
      for (const bool lookahead : {true, false}) {
        const auto plain = test::plainFlood(arcs, c.seeds, c.offsets, lookahead);
        for (const FloodGraph* graph : {&packed, &arcs}) {
          const auto flood = makeFlood(*graph, c.seeds.size());
          flood->start(c.seeds, c.offsets, lookahead, nullptr);
          flood->advance(kAll, nullptr);
          ASSERT_EQ(labelsOf(*flood), plain) << charts << " charts, p " << power;
        }
      }
    }
  }
}

TEST_P(FloodOn, StepsEqualOneGo) {
  const Case c(test::sampleMesh(GetParam(), 3000), 12, 3);
  const FloodGraph graph = buildFloodGraph(*c.mesh, c.gauss, {});
  const auto whole = makeFlood(graph, 12), stepped = makeFlood(graph, 12);
  whole->start(c.seeds, c.offsets, true, nullptr);
  EXPECT_EQ(whole->advance(kAll, nullptr), c.mesh->faceCount());
  stepped->start(c.seeds, c.offsets, true, nullptr);
  Rng rng(9);
  while (!stepped->finished()) stepped->advance(1 + rng.below(50), nullptr);
  EXPECT_EQ(labelsOf(*whole), labelsOf(*stepped));
  EXPECT_EQ(stepped->taken(), c.mesh->faceCount());
}

TEST_P(FloodOn, RecordRebuildsEveryMoment) {
  const Case c(test::sampleMesh(GetParam(), 2000), 9, 2);
  const FloodGraph graph = buildFloodGraph(*c.mesh, c.gauss, {});
  const auto flood = makeFlood(graph, 9);
  const auto record = std::make_shared<FloodRecord>(c.mesh->faceCount());
  flood->start(c.seeds, c.offsets, true, record);
  std::vector<Index> replayed(c.mesh->faceCount(), kNone);
  std::vector<float> time(c.seeds.size(), 0);
  std::size_t read = 0;
  while (!flood->finished()) {
    flood->advance(333, nullptr);
    for (; read < record->size(); ++read) {
      const Incorporation& taken = (*record)[read];
      ASSERT_EQ(replayed[taken.face], kNone);
      replayed[taken.face] = taken.chart;
      ASSERT_GE(taken.time, time[taken.chart]) << "local times of a chart never fall";
      time[taken.chart] = taken.time;
    }
    ASSERT_EQ(replayed, labelsOf(*flood));
  }
  EXPECT_EQ(record->size(), c.mesh->faceCount());
}

TEST_P(FloodOn, FarthestFacesEqualDijkstra) {
  const Case c(test::sampleMesh(GetParam(), 3000), 8, 4);
  const FloodGraph arcs = buildFloodGraph(*c.mesh, c.gauss, {}, FloodLayout::Arcs);
  const FloodGraph packed = buildFloodGraph(*c.mesh, c.gauss, {});
  const auto flood = makeFlood(packed, c.seeds.size());
  flood->start(c.seeds, c.offsets, true, nullptr);
  flood->advance(kAll, nullptr);
  const auto label = labelsOf(*flood);

  std::vector<float> distance(label.size(), std::numeric_limits<float>::infinity());
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Index f = 0; f < label.size(); ++f) {
    bool border = arcs.atMeshBorder[f] != 0;
    for (Index a = arcs.arcBegin[f]; a < arcs.arcBegin[f + 1]; ++a) {
      border = border || label[arcs.arcs[a].face] != label[f];
    }
    if (border) queue.push({distance[f] = 0.0f, f});
  }
  while (!queue.empty()) {
    const auto [d, f] = queue.top();
    queue.pop();
    if (d != distance[f]) continue;
    for (Index a = arcs.arcBegin[f]; a < arcs.arcBegin[f + 1]; ++a) {
      const FloodArc& arc = arcs.arcs[a];
      if (label[arc.face] != label[f] || !(d + arc.delay < distance[arc.face])) continue;
      queue.push({distance[arc.face] = d + arc.delay, arc.face});
    }
  }
  std::vector<float> best(c.seeds.size(), -1);
  for (Index f = 0; f < label.size(); ++f) best[label[f]] = std::max(best[label[f]], distance[f]);
  std::vector<Index> expected(c.seeds);
  for (Index k = 0; k < expected.size(); ++k) {
    if (distance[c.seeds[k]] == best[k]) continue;
    for (Index f = 0; f < label.size(); ++f) {
      if (label[f] == k && distance[f] == best[k]) {
        expected[k] = f;
        break;
      }
    }
  }
  for (const unsigned threads : {1u, 2u, 5u}) {
    setThreadCount(threads);
    EXPECT_EQ(flood->farthestFromBorder(c.seeds), expected);
  }
  setThreadCount(0);
}

TEST(Flood, PolygonsAreNeverSplitAndAllTaken) {
  const auto mesh = test::grid(30, false);
  const Case c(mesh, 6, 1);
  const FloodGraph graph = buildFloodGraph(*mesh, c.gauss, {});
  EXPECT_FALSE(graph.packed());
  const auto flood = makeFlood(graph, 6);
  flood->start(c.seeds, std::vector<double>(6, 0.0), true, nullptr);
  EXPECT_EQ(flood->advance(kAll, nullptr), 900u);
  const auto plain = test::plainFlood(graph, c.seeds, std::vector<double>(6, 0.0), true);
  EXPECT_EQ(labelsOf(*flood), plain);
}

TEST(Flood, FacesThatShareSeveralEdgesAreReached) {
  // A pillow: two triangles back to back, glued along all three edges; and one glued along two.
  const auto pillow = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const auto bag = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}},
                                {{0, 1, 2}, {1, 0, 3}, {0, 2, 3}, {2, 1, 3}, {0, 3, 2}});
  for (const auto& mesh : {pillow, bag}) {
    const std::size_t charts = mesh->componentCount();
    const Case c(mesh, charts, 1);
    for (const FloodLayout layout : {FloodLayout::Automatic, FloodLayout::Arcs}) {
      const FloodGraph graph = buildFloodGraph(*mesh, c.gauss, {}, layout);
      const auto flood = makeFlood(graph, charts);
      flood->start(c.seeds, c.offsets, true, nullptr);
      EXPECT_EQ(flood->advance(kAll, nullptr), mesh->faceCount());
    }
  }
}

TEST(Flood, CancelStopsAndResumes) {
  const Case c(test::sampleMesh("sphere", 60000), 5, 1);
  const FloodGraph graph = buildFloodGraph(*c.mesh, c.gauss, {});
  const auto flood = makeFlood(graph, 5), whole = makeFlood(graph, 5);
  whole->start(c.seeds, c.offsets, true, nullptr);
  whole->advance(kAll, nullptr);
  flood->start(c.seeds, c.offsets, true, nullptr);
  Progress stop;
  stop.cancel();
  flood->advance(kAll, &stop);
  EXPECT_FALSE(flood->finished());
  EXPECT_LT(flood->taken(), c.mesh->faceCount());
  flood->advance(kAll, nullptr);
  EXPECT_EQ(labelsOf(*flood), labelsOf(*whole));
}

TEST(Flood, HeapWorkStaysNearOneOperationAFace) {
  const Case c(test::sampleMesh("bumps", 40000), 20, 1);
  const FloodGraph graph = buildFloodGraph(*c.mesh, c.gauss, {});
  const auto flood = makeFlood(graph, 20);
  flood->start(c.seeds, std::vector<double>(20, 0.0), true, nullptr);
  flood->advance(kAll, nullptr);
  const double faces = static_cast<double>(c.mesh->faceCount());
  EXPECT_LT(static_cast<double>(flood->counts().pushes) / faces, 1.12);
  EXPECT_LT(static_cast<double>(flood->counts().pops) / faces, 1.12);
}

TEST(FloodGraph, DelaysFollowEquations6To9) {
  const auto mesh = test::sampleMesh("bumps", 2000);
  const GaussArea gauss = computeGaussArea(*mesh, 45);
  const FloodSpeeds speeds{2, 1e-2, 1e-3};
  const FloodGraph graph = buildFloodGraph(*mesh, gauss, speeds, FloodLayout::Arcs);
  const auto centroid = faceCentroids(*mesh);
  const auto area = faceAreas(*mesh);
  const auto face = faceGaussArea(*mesh, gauss);
  double factor = 0;
  for (Index f = 0; f < mesh->faceCount(); ++f) {
    for (Index a = graph.arcBegin[f]; a < graph.arcBegin[f + 1]; ++a) {
      const FloodArc& arc = graph.arcs[a];
      const double k = (face[arc.face] + static_cast<double>(arc.edgeGain)) / area[arc.face];
      const double expected = glm::length(centroid[f] - centroid[arc.face]) *
                              std::pow(std::min(1.0, k / gauss.maxCurvature) + 1e-2, 2);
      const double ratio = static_cast<double>(arc.delay) / expected;
      if (factor == 0) factor = ratio;
      ASSERT_NEAR(ratio / factor, 1, 1e-5);  // equal up to one constant factor
    }
  }
}

TEST(FloodGraph, ExtremeSettingsStayFinite) {
  const auto mesh = test::sampleMesh("rocket", 3000);
  const GaussArea gauss = computeGaussArea(*mesh, 45);
  for (const double epsilon : {1e-9, 1e-6, 1.0}) {
    for (const double power : {0.0, 6.0, 10.0}) {
      const FloodGraph graph = buildFloodGraph(*mesh, gauss, {power, epsilon, 0});
      for (const FloodFace& face : graph.faces) {
        for (const float delay : face.delay) ASSERT_TRUE(std::isfinite(delay) && delay >= 0);
      }
    }
  }
}

TEST(MinHeap, SortsAnything) {
  Rng rng(1);
  MinHeap heap;
  std::vector<TimedFace> expected;
  for (Index i = 0; i < 3000; ++i) {
    const TimedFace entry = timedFace(0.25f * static_cast<float>(rng.below(100)), i);
    heap.push(entry);
    expected.push_back(entry);
    if (i % 3 != 0) continue;
    const auto least = std::min_element(expected.begin(), expected.end());
    ASSERT_EQ(heap.top(), *least);
    expected.erase(least);
    if (i % 2 == 0) {
      const TimedFace replacement = timedFace(static_cast<float>(rng.below(50)), 10000 + i);
      heap.replaceTop(replacement);
      expected.push_back(replacement);
    } else {
      heap.pop();
    }
  }
  std::sort(expected.begin(), expected.end());
  for (const TimedFace entry : expected) {
    ASSERT_EQ(heap.top(), entry);
    heap.pop();
  }
  EXPECT_TRUE(heap.empty());
}

TEST(MinHeap, NamesEveryEntryBeforeItIsTheTop) {
  Rng rng(1);
  MinHeap heap;
  for (Index i = 0; i < 1000; ++i) heap.push(timedFace(static_cast<float>(rng.below(100)), i));
  std::vector<int> named(1000, 0);
  std::size_t unnamed = 0;
  while (!heap.empty()) {
    if (named[faceOf(heap.top())] == 0) ++unnamed;
    heap.pop();
    if (!heap.empty()) ++named[faceOf(heap.risen())];
  }
  EXPECT_LE(unnamed, 9u);  // the first top and what is right below it from the start
}

TEST(PrimaryQueue, TiesGoToTheLowestChart) {
  for (const std::size_t count : {1u, 2u, 5u, 20u, 64u, 1000u}) {
    PrimaryQueue queue;
    queue.reset(count);
    EXPECT_TRUE(queue.finished());
    Rng rng(static_cast<unsigned>(count));
    std::vector<double> keys(count, PrimaryQueue::kFinished);
    for (int i = 0; i < 2000; ++i) {
      const Index chart = rng.below(static_cast<unsigned>(count));
      keys[chart] = i % 7 == 0 ? PrimaryQueue::kFinished : rng.below(10) - 4.0;
      auto others = keys;
      others[chart] = PrimaryQueue::kFinished;
      const auto first = std::min_element(others.begin(), others.end());
      const PrimaryQueue::Ranked other = queue.firstBut(chart);
      ASSERT_EQ(other.canGrow(), std::isfinite(*first));
      if (other.canGrow()) {
        ASSERT_EQ(other.chart, static_cast<Index>(first - others.begin()));
      }
      const PrimaryQueue::Ranked own = queue.setKey(chart, keys[chart]);
      const auto least = std::min_element(keys.begin(), keys.end());
      ASSERT_EQ(queue.top(), static_cast<Index>(least - keys.begin()));
      ASSERT_EQ(queue.finished(), !std::isfinite(*least));
      if (other.canGrow() || own.canGrow()) {
        ASSERT_EQ(queue.top(), own.before(other) ? own.chart : other.chart);
      }
    }
  }
}

}  // namespace
}  // namespace chartflood
