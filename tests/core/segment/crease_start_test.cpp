// Charts from sharp edges: core/segment/crease_regions, region_graph, split_chart, crease_start.

#include <algorithm>
#include <cctype>
#include <string>

#include <gtest/gtest.h>

#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/creases/crease_regions.h"
#include "core/segment/creases/crease_start.h"
#include "tests/support/segment_inputs.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

Segmentation finished(const SegmentInputs& in, std::size_t charts) {
  SegmentOptions options;
  options.charts = charts;
  const auto stepper = makeCreaseStart(in, options);
  Progress progress;
  EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
  return *stepper->state();
}

TEST(CreaseRegions, OfACubeAreItsSidesAndStayWhateverTheCuts) {
  const SegmentInputs in = test::segmentInputs(test::sampleMesh("cube", 1200));
  const CreaseRegions regions = creaseRegions(*in.mesh, *in.gaussArea);
  EXPECT_EQ(regions.count, 6u);
  EXPECT_TRUE(dividedByCreases(*in.mesh, *in.gaussArea));
  const Segmentation state = finished(in, 6);
  test::expectValid(*in.mesh, *in.gaussArea, state);
  std::vector<Index> seen(6, kNone);  // the chart of each side
  for (Index f = 0; f < regions.label.size(); ++f) {
    Index& chart = seen[regions.label[f]];
    if (chart == kNone) chart = state.label[f];
    EXPECT_EQ(chart, state.label[f]);
  }
}

TEST(CreaseRegions, ASmoothModelIsOneAndDoesNotSuit) {
  const SegmentInputs in = test::segmentInputs(test::sampleMesh("sphere", 1000));
  EXPECT_EQ(creaseRegions(*in.mesh, *in.gaussArea).count, 1u);
  EXPECT_FALSE(suitsCreaseStart(in, 20));
}

struct Suits {
  const char* file;
  bool expected;
};
class CreasesOf : public testing::TestWithParam<Suits> {};
INSTANTIATE_TEST_SUITE_P(
    Meshes, CreasesOf,
    testing::Values(Suits{"fandisk.obj", true}, Suits{"anchor_dense.off", true},
                    Suits{"casting.off", true}, Suits{"bracket-3.stl", true},
                    Suits{"tray-ascii.stl", true}, Suits{"cheese.off", false},
                    Suits{"fuze.obj", false}, Suits{"bones.off", false},
                    Suits{"greek-helmet-quads.obj", false}, Suits{"homer.obj", false},
                    Suits{"rocker-arm.obj", false}, Suits{"suzanne.obj", false}),
    [](const auto& instance) {
      std::string name = instance.param.file;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
      return name;
    });

TEST_P(CreasesOf, DivideMachineParts) {
  const auto mesh = test::realMesh(GetParam().file);
  if (!mesh) GTEST_SKIP() << "no such file here";
  EXPECT_EQ(dividedByCreases(*mesh, computeGaussArea(*mesh, 45)), GetParam().expected);
}

TEST(CreaseRegions, OfASoftBodyWithHardDetailsDoNotDivideIt) {
  EXPECT_FALSE(suitsCreaseStart(test::segmentInputs(test::sampleMesh("rocket", 5000)), 20));
  EXPECT_TRUE(suitsCreaseStart(test::segmentInputs(test::sampleMesh("gear", 5000)), 20));
}

TEST(CreaseStart, SeedsAreOfTheChartsAndToldOf) {
  const SegmentInputs in = test::segmentInputs(test::sampleMesh("gear", 3000));
  SegmentOptions options;
  options.charts = 20;
  std::vector<Index> told;
  options.onFlood = [&](const FloodBegun& begun) {
    EXPECT_EQ(begun.start.creases, std::optional(options.rngSeed));
    told = begun.start.seeds;
  };
  const auto stepper = makeCreaseStart(in, options);
  Progress progress;
  EXPECT_EQ(told, stepper->state()->seeds);
  stepper->advance(StepUnit::Converged, 1, progress);
  EXPECT_EQ(told, stepper->state()->seeds);
}

class CreaseStartOn : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, CreaseStartOn,
                         testing::Values("cube", "cylinder", "gear", "rocket", "torus"));

TEST_P(CreaseStartOn, AnyNumberOfChartsIsValid) {
  const SegmentInputs in = test::segmentInputs(test::sampleMesh(GetParam(), 3000));
  for (const std::size_t charts : {2u, 5u, 20u, 60u}) {
    const Segmentation state = finished(in, charts);
    EXPECT_EQ(state.chartCount, std::max(charts, in.mesh->componentCount()));
    test::expectValid(*in.mesh, *in.gaussArea, state);
  }
}

TEST_P(CreaseStartOn, StepsAndCancelledRunsGiveTheSame) {
  const SegmentInputs in = test::segmentInputs(test::sampleMesh(GetParam(), 3000));
  const Segmentation whole = finished(in, 12);
  SegmentOptions options;
  options.charts = 12;
  const auto stepper = makeCreaseStart(in, options);
  StepOutcome outcome = StepOutcome::Advanced;
  for (int i = 0; outcome != StepOutcome::Finished; ++i) {
    Progress progress;
    if (i % 2 == 1) progress.cancel();
    outcome = stepper->advance(i < 6 ? StepUnit::Face : StepUnit::Flood, 100, progress);
    ASSERT_LT(i, 100000);
  }
  EXPECT_EQ(stepper->state()->label, whole.label);
  EXPECT_EQ(stepper->record()->size(), in.mesh->faceCount());
}

}  // namespace
}  // namespace chartflood
