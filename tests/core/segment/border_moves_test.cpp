// Border clean-up keeps topology and lowers its energy: core/segment/border_moves.

#include <gtest/gtest.h>

#include <cmath>

#include "core/charts/chart_stats.h"
#include "core/segment/borders/border_moves.h"
#include "core/segment/parts/balance.h"
#include "tests/core/segment/flooded.h"
#include "tests/support/segmentation_checks.h"

namespace chartflood {
namespace {

using test::Flooded;

class MovesOn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, MovesOn,
                         testing::Values("rocket", "torus", "double-torus", "tube", "bumps"));

TEST_P(MovesOn, TopologyStaysAndEnergyFalls) {
  const Flooded f(test::sampleMesh(GetParam(), 6000), 9);
  const ChartStats before = measureCharts(*f.mesh, f.state);
  for (const double weight : {0.0, 1000.0, 1e5}) {
    BorderMoves moves(*f.mesh, *f.gauss, f.face, f.state.label, f.state.chartCount, f.state.seeds,
                      {.weight = weight});
    const double start = moves.energy();
    Progress progress;
    EXPECT_TRUE(moves.run(progress));
    EXPECT_LE(moves.energy(), start);
    EXPECT_GT(moves.moves(), 0u);
    const Segmentation after = f.relabelled(moves.labels());
    test::expectValid(*f.mesh, *f.gauss, after);
    const ChartStats stats = measureCharts(*f.mesh, after);
    for (std::size_t c = 0; c < stats.charts.size(); ++c) {
      EXPECT_EQ(stats.charts[c].euler, before.charts[c].euler) << "chart " << c;
      EXPECT_EQ(stats.charts[c].boundaryLoops, before.charts[c].boundaryLoops) << "chart " << c;
    }
    if (weight == 0) {
      EXPECT_LT(stats.seamLength, before.seamLength);
    }
    // The running sums must agree with a fresh count.
    BorderMoves fresh(*f.mesh, *f.gauss, f.face, after.label, after.chartCount, after.seeds,
                      {.weight = weight});
    EXPECT_NEAR(fresh.energy(), moves.energy(), 1e-6 * std::max(1.0, start));
  }
}

TEST(BorderMoves, LargeWeightEvensOut) {
  const Flooded f(test::sampleMesh("bumps", 12000), 12);
  const auto spread = [&](double weight) {
    BorderMoves moves(*f.mesh, *f.gauss, f.face, f.state.label, f.state.chartCount, f.state.seeds,
                      {.weight = weight});
    Progress progress;
    moves.run(progress);
    return balanceOf(f.relabelled(moves.labels()).areas.gaussArea).stdOverMean();
  };
  EXPECT_LT(spread(1e5), 0.5 * spread(0));
}

/// The same unevenness costs the same however many charts there are: else many have their borders
/// shattered for a little more of balance.
TEST(BorderMoves, BalanceCostsTheSameWithManyCharts) {
  for (const std::size_t charts : {20, 100}) {
    const Flooded f(test::sampleMesh("bumps", 7000), charts);
    for (const bool likeCuts : {false, true}) {
      const BorderMoves moves(*f.mesh, *f.gauss, f.face, f.state.label, f.state.chartCount,
                              f.state.seeds, {.weight = 1000, .likeCuts = likeCuts, .eta = f.eta});
      const double price = likeCuts ? 1000 : 400 * 1000 * std::sqrt(0.1);
      const double balance = moves.energy() - moves.seamLength();
      const double faces = static_cast<double>(f.mesh->faceCount());
      EXPECT_NEAR(balance / moves.deviation() / moves.deviation(),
                  likeCuts ? price : price * std::sqrt(faces / 7000), 1e-6 * price);
    }
  }
}

TEST(BorderMoves, CancelledRunsGoOn) {
  const Flooded f(test::sampleMesh("bumps", 60000), 30);
  BorderMoves whole(*f.mesh, *f.gauss, f.face, f.state.label, f.state.chartCount, f.state.seeds,
                    {});
  Progress progress;
  whole.run(progress);
  BorderMoves stopped(*f.mesh, *f.gauss, f.face, f.state.label, f.state.chartCount, f.state.seeds,
                      {});
  std::size_t stops = 0;
  for (bool done = false; !done; ++stops) {
    Progress once;
    once.cancel();
    done = stopped.run(once);
  }
  EXPECT_GT(stops, 1u);
  EXPECT_TRUE(std::equal(whole.labels().begin(), whole.labels().end(), stopped.labels().begin()));
}

TEST(BorderMoves, WorksOnPolygons) {
  const auto mesh = test::grid(40, false);
  const Flooded f(mesh, 5);
  BorderMoves moves(*f.mesh, *f.gauss, f.face, f.state.label, f.state.chartCount, f.state.seeds,
                    {.weight = 0});
  const double start = moves.energy();
  Progress progress;
  moves.run(progress);
  EXPECT_LE(moves.energy(), start);
  test::expectValid(*f.mesh, *f.gauss, f.relabelled(moves.labels()));
}

}  // namespace
}  // namespace chartflood
