// Moments near and far: app/host/moment_charts.

#include <algorithm>
#include <future>
#include <memory>

#include <gtest/gtest.h>

#include "app/host/film/moment_charts.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/model/build_mesh.h"
#include "core/samples/samples.h"

namespace chartflood {
namespace {

constexpr Index kCharts = 5;

/// Large enough that a whole flood is far.
class Moments : public ::testing::Test {
 protected:
  Moments() {
    results.mesh = buildMesh(makeSample("torus", 120'000));
    results.gaussArea = std::make_shared<const GaussArea>(computeGaussArea(*results.mesh, 45));
    results.start.seeds.assign(kCharts, 0);
  }
  /// Takes the faces in their order, `shift` numbers on.
  std::shared_ptr<const FloodRecord> record(Index shift) const {
    const auto faces = static_cast<Index>(results.mesh->faceCount());
    auto log = std::make_shared<FloodRecord>(faces);
    for (Index i = 0; i < faces; ++i) log->append((i + shift) % faces, i % kCharts, 0.0f);
    log->publish();
    return log;
  }
  void expectThere(const MomentCharts& moment, const std::shared_ptr<const FloodRecord>& log,
                   std::size_t step) {
    MomentCharts other(WorkPlace{true, {}});
    other.show(results, log, step);
    EXPECT_TRUE(std::ranges::equal(moment.labels(), other.labels()));
    ASSERT_TRUE(moment.stats());
    for (std::size_t c = 0; c < kCharts; ++c) {
      EXPECT_EQ(moment.stats()->charts[c].gaussArea, other.stats()->charts[c].gaussArea);
      EXPECT_EQ(moment.stats()->charts[c].faces, other.stats()->charts[c].faces);
    }
  }
  /// Goes to a moment beside this thread and waits for it.
  void arrive(MomentCharts& moment, const std::shared_ptr<const FloodRecord>& log,
              std::size_t step) {
    moment.show(results, log, step);
    woken.get_future().wait();
    woken = {};
    moment.show(results, log, step);
  }

  Results results;
  std::promise<void> woken;
  const WorkPlace beside{false, [this] { woken.set_value(); }};
};

TEST_F(Moments, AFarOneComesLaterWhileTheOneBeforeStays) {
  const auto first = record(0), second = record(7);
  const std::size_t whole = first->size();
  MomentCharts moment(beside);
  moment.show(results, first, whole);
  EXPECT_TRUE(moment.labels().empty());
  EXPECT_FALSE(moment.stats());
  woken.get_future().wait();
  woken = {};
  moment.show(results, first, whole);
  expectThere(moment, first, whole);
  const auto stats = moment.stats();
  moment.show(results, second, whole);
  EXPECT_EQ(moment.stats(), stats);  // still the first
  woken.get_future().wait();
  woken = {};
  moment.show(results, second, whole);
  expectThere(moment, second, whole);
  arrive(moment, first, whole / 3);
  expectThere(moment, first, whole / 3);
}

TEST_F(Moments, ANearOneIsThereAtOnce) {
  const auto log = record(0);
  MomentCharts moment(beside);
  arrive(moment, log, log->size());
  for (const std::size_t step : {log->size() - 1000, log->size() - 10, log->size() - 90'000}) {
    moment.show(results, log, step);
    expectThere(moment, log, step);
  }
}

TEST_F(Moments, WhatArrivesForAnotherMeshIsForgotten) {
  const auto log = record(0);
  MomentCharts moment(beside);
  moment.show(results, log, log->size());
  moment.clear();
  results.mesh = buildMesh(makeSample("torus", 130'000));
  results.gaussArea = std::make_shared<const GaussArea>(computeGaussArea(*results.mesh, 45));
  woken.get_future().wait();
  woken = {};
  const auto other = record(0);
  moment.show(results, other, other->size());
  EXPECT_TRUE(moment.labels().empty());
  woken.get_future().wait();
  woken = {};
  moment.show(results, other, other->size());
  expectThere(moment, other, other->size());
}

}  // namespace
}  // namespace chartflood
