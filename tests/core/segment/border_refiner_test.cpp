// Refined borders are short whatever the number of charts, and longer only for more balance:
// core/segment/border_refiner.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/charts/chart_stats.h"
#include "core/segment/borders/border_refiner.h"
#include "core/segment/parts/balance.h"
#include "tests/core/segment/flooded.h"
#include "tests/support/segmentation_checks.h"

namespace chartflood {
namespace {

using test::Flooded;

struct Refined {
  double length = 0;  ///< of seams, over the square root of the area
  double spread = 0;  ///< standard deviation of Gauss area over its mean
};

double lengthOf(const Flooded& f, const Segmentation& charts) {
  const ChartStats stats = measureCharts(*f.mesh, charts);
  return stats.seamLength / std::sqrt(stats.surfaceArea);
}

Refined refined(const Flooded& f, const RefineOptions& options) {
  const auto graph = std::make_shared<FloodGraph>(buildFloodGraph(*f.mesh, *f.gauss, {}));
  BorderRefiner refiner({f.mesh, f.gauss, graph}, f.face, f.state.label, f.state.chartCount,
                        f.state.seeds, options);
  Progress progress;
  EXPECT_TRUE(refiner.run(progress));
  const Segmentation after = f.relabelled(refiner.labels());
  test::expectValid(*f.mesh, *f.gauss, after);
  return {lengthOf(f, after), balanceOf(after.areas.gaussArea).stdOverMean()};
}

/// Single faces after the cuts must not buy the last bit of balance with stairs.
TEST(BorderRefiner, ManyChartsKeepTheCutsShortBorders) {
  const Flooded f(test::sampleMesh("bumps", 6000), 200);
  SeamCuts cuts(*f.mesh, *f.gauss, f.face, f.state.label, f.state.chartCount, f.state.seeds,
                {.eta = f.eta});
  Progress progress;
  ASSERT_TRUE(cuts.run(progress));
  const Segmentation cut = f.relabelled(cuts.labels());
  const double spread = balanceOf(cut.areas.gaussArea).stdOverMean();
  ASSERT_GT(spread, 0.05) << "nothing is left to even out";
  const Refined both = refined(f, {});
  EXPECT_LT(both.spread, spread);
  EXPECT_LE(both.length, 1.03 * lengthOf(f, cut));
}

TEST(BorderRefiner, SeamsNeverGetShorterAsBalanceCountsMore) {
  for (const char* sample : {"bumps", "rocket", "double-torus"}) {
    const Flooded f(test::sampleMesh(sample, 8000), 12);
    Refined before;
    for (const double weight : {0.0, 10.0, 100.0, 1000.0, 10000.0}) {
      const Refined now = refined(f, {.balanceWeight = weight, .creaseWeight = 1});
      EXPECT_GE(now.length, before.length) << sample << ", weight " << weight;
      if (weight > 0) {
        EXPECT_LE(now.spread, before.spread + 0.01) << sample << ", weight " << weight;
      }
      before = now;
    }
  }
}

}  // namespace
}  // namespace chartflood
