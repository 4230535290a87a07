// The conformance of every registered method, and what only t-flooding promises.

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/fast/fast_flooding.h"
#include "core/segment/parts/balance.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/registry.h"
#include "tests/support/segment_inputs.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

std::shared_ptr<const Segmentation> inOneGo(const Segmenter& method, const SegmentInputs& in,
                                            const SegmentOptions& options) {
  const auto stepper = method.make(in, options);
  Progress progress;
  EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
  return stepper->state();
}

struct MethodAndMesh {
  const Segmenter* method;
  std::string mesh;
  SearchKind search = SearchKind::Literal;
};

std::vector<MethodAndMesh> everyMethodOnEveryMesh() {
  std::vector<MethodAndMesh> cases;
  for (const Segmenter& method : segmenterTable()) {
    for (const char* mesh : {"rocket", "double-torus", "tube", "cube", "plane"}) {
      cases.push_back({&method, mesh});
    }
    for (const char* file : {"homer.obj", "fandisk.obj", "elephant-with-holes.off"}) {
      cases.push_back({&method, file});
    }
  }
  const Segmenter* method = findSegmenter("t-flooding");
  for (const char* mesh : {"rocket", "double-torus", "tube", "cube", "plane", "homer.obj",
                           "fandisk.obj", "elephant-with-holes.off", "spot.obj"}) {
    cases.push_back({method, mesh, SearchKind::Fast});
  }
  return cases;
}

class Conformance : public testing::TestWithParam<MethodAndMesh> {
 protected:
  void SetUp() override {
    const std::string& name = GetParam().mesh;
    const bool file = name.find('.') != std::string::npos;
    mesh_ = file ? test::realMesh(name) : test::sampleMesh(name, 4000);
    if (!mesh_) GTEST_SKIP() << "the folder of real meshes is absent";
    in_ = test::segmentInputs(mesh_);
    options_.charts = 11;
    options_.search = GetParam().search;
    if (options_.search == SearchKind::Fast) {
      ASSERT_TRUE(searchesFast(*mesh_, options_)) << "a mesh for the fast search";
    }
  }
  std::shared_ptr<const Mesh> mesh_;
  SegmentInputs in_;
  SegmentOptions options_;
};
/// What test names may be made of.
std::string plainName(std::string name) {
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Methods, Conformance, testing::ValuesIn(everyMethodOnEveryMesh()),
                         [](const auto& instance) {
                           const bool fast = instance.param.search == SearchKind::Fast;
                           return plainName((fast ? "fast_" : "") + (instance.param.method->id +
                                                                     ("_" + instance.param.mesh)));
                         });

TEST_P(Conformance, ChartsAreValid) {
  const auto state = inOneGo(*GetParam().method, in_, options_);
  EXPECT_EQ(state->chartCount, std::max<std::size_t>(11, mesh_->componentCount()));
  test::expectValid(*mesh_, *in_.gaussArea, *state);
}

TEST_P(Conformance, AnyWayThereGivesTheSameLabels) {
  const auto expected = inOneGo(*GetParam().method, in_, options_);
  // By faces, floods and iterations in any mixture.
  const auto mixed = GetParam().method->make(in_, options_);
  Rng rng(7);
  Progress progress;
  StepOutcome outcome = StepOutcome::Advanced;
  while (outcome != StepOutcome::Finished) {
    const std::uint32_t dice = rng.below(3);
    const StepUnit unit = dice == 0   ? StepUnit::Face
                          : dice == 1 ? StepUnit::Flood
                                      : StepUnit::Iteration;
    outcome = mixed->advance(unit, unit == StepUnit::Face ? 1 + rng.below(3000) : 1, progress);
  }
  EXPECT_EQ(mixed->state()->label, expected->label);
  EXPECT_EQ(mixed->state()->seeds, expected->seeds);
  // Cancelled again and again.
  const auto cancelled = GetParam().method->make(in_, options_);
  outcome = StepOutcome::Cancelled;
  for (int i = 0; outcome != StepOutcome::Finished; ++i) {
    Progress once;
    if (i % 3 != 2) once.cancel();
    outcome = cancelled->advance(i % 2 == 0 ? StepUnit::Converged : StepUnit::Flood, 1, once);
    ASSERT_LT(i, 100000);
  }
  EXPECT_EQ(cancelled->state()->label, expected->label);
  EXPECT_EQ(cancelled->state()->seeds, expected->seeds);
  EXPECT_EQ(cancelled->stopReason(), mixed->stopReason());
}

TEST_P(Conformance, ThreadsChangeNothing) {
  setThreadCount(1);
  const auto alone = inOneGo(*GetParam().method, test::segmentInputs(mesh_), options_);
  setThreadCount(2);
  const auto two = inOneGo(*GetParam().method, test::segmentInputs(mesh_), options_);
  setThreadCount(0);
  EXPECT_EQ(alone->label, two->label);
  EXPECT_EQ(alone->seeds, two->seeds);
}

TEST_P(Conformance, AnyNumberOfCharts) {
  for (const std::size_t charts : {std::size_t{1}, std::size_t{2}, std::size_t{300}}) {
    options_.charts = charts;
    options_.maxIterations = 3;
    const auto state = inOneGo(*GetParam().method, in_, options_);
    EXPECT_EQ(state->chartCount,
              std::min(std::max(charts, mesh_->componentCount()), mesh_->faceCount()));
    test::expectValid(*mesh_, *in_.gaussArea, *state);
  }
}

TEST(TFlooding, OneChartAFace) {
  const auto mesh = test::sampleMesh("sphere", 600);
  SegmentOptions options;
  options.charts = 100000;
  const auto state = inOneGo(*findSegmenter("t-flooding"), test::segmentInputs(mesh), options);
  EXPECT_EQ(state->chartCount, mesh->faceCount());
  test::expectValid(*mesh, *test::segmentInputs(mesh).gaussArea, *state);
}

TEST(TFlooding, BestRoundIsKept) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 8000));
  SegmentOptions options;
  options.refine.kind = RefineKind::None;
  const auto stepper = findSegmenter("t-flooding")->make(in, options);
  Progress progress;
  stepper->advance(StepUnit::Converged, 1, progress);
  double least = std::numeric_limits<double>::infinity();
  for (const IterationSummary& round : stepper->history())
    least = std::min(least, round.stdOverMean);
  const double kept = balanceOf(stepper->state()->areas.gaussArea).stdOverMean();
  EXPECT_DOUBLE_EQ(kept, least);
  EXPECT_DOUBLE_EQ(stepper->history()[stepper->bestIteration()].stdOverMean, least);
  EXPECT_EQ(stepper->state()->seeds, stepper->history()[stepper->bestIteration()].seeds);
}

TEST(TFlooding, LogAtTheEndIsTheKeptRounds) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 8000));
  SegmentOptions options;
  options.refine.kind = RefineKind::None;
  const auto stepper = findSegmenter("t-flooding")->make(in, options);
  Progress progress;
  stepper->advance(StepUnit::Converged, 1, progress);
  const auto record = stepper->record();
  ASSERT_EQ(record->size(), in.mesh->faceCount());
  const auto state = stepper->state();
  for (std::size_t i = 0; i < record->size(); ++i) {
    ASSERT_EQ(state->label[(*record)[i].face], (*record)[i].chart);
  }
}

TEST(TFlooding, AdoptedRoundIsFloodedAgain) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 6000));
  const auto stepper = findSegmenter("t-flooding")->make(in, {});
  Progress progress;
  stepper->advance(StepUnit::Flood, 3, progress);
  const auto third = stepper->state();
  stepper->advance(StepUnit::Flood, 2, progress);
  EXPECT_EQ(stepper->adopt(2, progress), StepOutcome::Advanced);
  EXPECT_EQ(stepper->state()->label, third->label);
  EXPECT_EQ(stepper->state()->iteration, 2u);
}

TEST(TFlooding, RestartTakesNothing) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 6000));
  const auto stepper = findSegmenter("t-flooding")->make(in, {});
  Progress progress;
  stepper->advance(StepUnit::Flood, 1, progress);
  const auto first = stepper->state();
  stepper->restartFlood();
  EXPECT_EQ(stepper->record()->size(), 0u);
  EXPECT_FALSE(stepper->state()->complete);
  stepper->advance(StepUnit::Flood, 1, progress);
  EXPECT_EQ(stepper->state()->label, first->label);
}

TEST(TFlooding, BalanceGetsBetterThanOneRound) {
  const auto in = test::segmentInputs(test::sampleMesh("bumps", 20000));
  const auto stepper = findSegmenter("t-flooding")->make(in, {});
  Progress progress;
  stepper->advance(StepUnit::Flood, 1, progress);
  const double first = balanceOf(stepper->state()->areas.gaussArea).stdOverMean();
  stepper->advance(StepUnit::Converged, 1, progress);
  const double last = balanceOf(stepper->state()->areas.gaussArea).stdOverMean();
  EXPECT_LT(last, 0.1 * first);
}

TEST(TFlooding, PlaneIsSharedByArea) {
  const auto mesh = test::grid(60, true);
  SegmentOptions options;
  options.charts = 8;
  const auto state = inOneGo(*findSegmenter("t-flooding"), test::segmentInputs(mesh), options);
  test::expectValid(*mesh, *test::segmentInputs(mesh).gaussArea, *state);
  std::vector<double> faces(8, 0);
  for (const Index label : state->label) faces[label] += 1;
  for (const double count : faces) EXPECT_GT(count, 0.5 * 7200 / 8);
}

TEST(TFlooding, PowersOfTwoChangeNothing) {
  const auto mesh = test::sampleMesh("rocket", 5000);
  InputMesh scaled = test::copyInput(*mesh);
  for (auto& p : scaled.positions) p *= 1024.0;
  const Segmenter& method = *findSegmenter("t-flooding");
  EXPECT_EQ(inOneGo(method, test::segmentInputs(mesh), {})->label,
            inOneGo(method, test::segmentInputs(test::rebuild(std::move(scaled))), {})->label);
}

struct Goal {
  const char* file;
  double stdOverMean;
};

class BalanceGoal : public testing::TestWithParam<Goal> {};
INSTANTIATE_TEST_SUITE_P(RealMeshes, BalanceGoal,
                         testing::Values(Goal{"stanford-bunny.obj", 0.02},
                                         Goal{"rocker-arm.obj", 0.02}, Goal{"homer.obj", 0.02},
                                         Goal{"armadillo-80354.ply", 0.02},
                                         Goal{"happy-buddha-19976.ply", 0.02},
                                         Goal{"igea-151558.ply", 0.02}),
                         [](const auto& instance) { return plainName(instance.param.file); });

TEST_P(BalanceGoal, IsReachedWithDefaults) {
  const auto mesh = test::realMesh(GetParam().file);
  if (!mesh) GTEST_SKIP() << "the folder of real meshes is absent";
  const auto in = test::segmentInputs(mesh);
  const auto state = inOneGo(*findSegmenter("t-flooding"), in, {});
  test::expectValid(*mesh, *in.gaussArea, *state);
  EXPECT_LE(balanceOf(state->areas.gaussArea).stdOverMean(), GetParam().stdOverMean);
}

TEST(EveryMethod, MakesTheLogOfAnEarlierRoundAgainAndLeavesTheStateAlone) {
  SegmentOptions options;
  options.charts = 7;
  const auto in = test::segmentInputs(test::sampleMesh("rocket", 1000));
  for (const Segmenter& method : segmenterTable()) {
    const auto stepper = method.make(in, options);
    Progress progress;
    std::vector<std::shared_ptr<const FloodRecord>> logs;
    for (int round = 0; round < 9; ++round) {
      stepper->advance(StepUnit::Flood, 1, progress);
      logs.push_back(stepper->record());
    }
    stepper->advance(StepUnit::Face, 50, progress);
    const auto before = stepper->record();
    for (std::size_t round = 0; round < logs.size(); ++round) {
      const auto again = stepper->replay(round, progress);
      ASSERT_EQ(again->size(), logs[round]->size());
      for (std::size_t i = 0; i < again->size(); ++i) {
        ASSERT_EQ((*again)[i].face, (*logs[round])[i].face) << method.id;
        ASSERT_EQ((*again)[i].chart, (*logs[round])[i].chart) << method.id;
        ASSERT_EQ((*again)[i].time, (*logs[round])[i].time) << method.id;
      }
    }
    EXPECT_EQ(stepper->record(), before) << method.id;
    EXPECT_EQ(before->size(), 50u) << method.id;
  }
}

TEST(EveryMethod, TellsHowItsBordersWereRefined) {
  SegmentOptions options;
  options.charts = 7;
  const auto in = test::segmentInputs(test::sampleMesh("rocket", 1000));
  for (const Segmenter& method : segmenterTable()) {
    for (const RefineKind kind : {RefineKind::Cuts, RefineKind::Moves, RefineKind::None}) {
      options.refine.kind = kind;
      const auto stepper = method.make(in, options);
      Progress progress;
      stepper->advance(StepUnit::Converged, 1, progress);
      const auto seams = stepper->seamRecord();
      ASSERT_EQ(seams == nullptr, kind == RefineKind::None) << method.id;
      if (!seams) continue;
      const auto log = stepper->record();
      for (std::size_t i = 0; i < log->size(); ++i) {
        ASSERT_EQ(seams->start[(*log)[i].face], (*log)[i].chart) << method.id;
      }
      std::vector<Index> label = seams->start;
      for (std::size_t i = 0; i < seams->steps.size(); ++i) seams->play(i, label);
      EXPECT_EQ(label, stepper->state()->label) << method.id;
    }
  }
}

TEST(EveryMethod, KeepsTheLastRoundWhereThatIsWished) {
  SegmentOptions options;
  options.charts = 7;
  options.keepLast = true;
  options.refine.kind = RefineKind::None;
  const auto in = test::segmentInputs(test::sampleMesh("rocket", 1000));
  for (const Segmenter& method : segmenterTable()) {
    for (const bool record : {true, false}) {
      options.record = record;
      const auto stepper = method.make(in, options);
      Progress progress;
      stepper->advance(StepUnit::Converged, 1, progress);
      const auto state = stepper->state();
      EXPECT_EQ(state->iteration + 1, stepper->history().size()) << method.id;
      const auto last = stepper->replay(state->iteration, progress);
      for (std::size_t i = 0; i < last->size(); ++i) {
        ASSERT_EQ(state->label[(*last)[i].face], (*last)[i].chart) << method.id;
      }
    }
  }
}

/// The rounds of t-flooding to the end, with the values of the paper.
std::unique_ptr<Stepper> printedRun(const SegmentInputs& in, SegmentOptions options) {
  options.charts = 9;
  options.offsetDamping = 0.9;
  options.settle = 0;
  options.refine.kind = RefineKind::None;
  auto stepper = segmenterOf("t-flooding").make(in, options);
  Progress progress;
  EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
  return stepper;
}

TEST(TFlooding, SeedsComeOneByOneWithAFloodBeforeEach) {
  const auto in = test::segmentInputs(test::sampleMesh("rocket", 2000));
  SegmentOptions options;
  options.placement = SeedPlacement::OneByOne;
  options.maxIterations = 5;
  options.patience = 100;
  options.detectCycles = false;
  const auto stepper = printedRun(in, options);
  const auto history = stepper->history();
  ASSERT_EQ(history.size(), 8u + 5u) << "rounds on the way do not count against the limit";
  std::size_t moved = 0;
  for (std::size_t round = 0; round + 1 < 9; ++round) {
    const IterationSummary& now = history[round];
    const IterationSummary& next = history[round + 1];
    ASSERT_EQ(now.seeds.size(), round + 1);
    // Offsets begin once all seeds are there; the new seed is none of the others.
    for (const double offset : next.offsets) EXPECT_EQ(offset, 0);
    EXPECT_EQ(std::count(next.seeds.begin(), next.seeds.end(), next.seeds.back()), 1);
    for (std::size_t c = 0; c < now.seeds.size(); ++c) moved += now.seeds[c] != next.seeds[c];
  }
  EXPECT_GT(moved, 8u) << "seeds move after each flood";
  EXPECT_GE(stepper->bestIteration(), 8u) << "a round with all charts is kept";
  const auto offset = [](double value) { return value > 0; };
  const auto& last = history.back().offsets;
  EXPECT_TRUE(std::any_of(last.begin(), last.end(), offset));
  EXPECT_EQ(stepper->state()->chartCount, 9u);
}

TEST(TFlooding, SeedsThatComeOneByOneGoOnFromAnyRoundAndKeepLocks) {
  const auto in = test::segmentInputs(test::sampleMesh("double-torus", 1500));
  SegmentOptions options;
  options.placement = SeedPlacement::OneByOne;
  options.seeds = options.locked = {17};
  const auto whole = printedRun(in, options);
  for (const IterationSummary& round : whole->history()) EXPECT_EQ(round.seeds[0], 17u);
  options.charts = 9;
  options.refine.kind = RefineKind::None;
  const auto stepper = segmenterOf("t-flooding").make(in, options);
  Progress progress;
  stepper->advance(StepUnit::Flood, 6, progress);
  stepper->adopt(2, progress);
  stepper->advance(StepUnit::Flood, 1, progress);
  EXPECT_EQ(stepper->history().back().seeds, stepper->history()[3].seeds);
  EXPECT_EQ(stepper->history().back().offsets, stepper->history()[3].offsets);
}

TEST(TFlooding, KeepsTheRoundOfLeastSpreadByEquation3WhereThatIsWished) {
  const auto in = test::segmentInputs(test::sampleMesh("gear", 3000));
  const FaceValues faceGauss = faceGaussArea(*in.mesh, *in.gaussArea);
  SegmentOptions options;
  options.patience = 15;
  for (const RoundMeasure measure : {RoundMeasure::Printed, RoundMeasure::Relative}) {
    options.roundMeasure = measure;
    const auto stepper = printedRun(in, options);
    const auto badness = [&](std::size_t round) {
      Progress progress;
      const auto record = stepper->replay(round, progress);
      std::vector<Index> label(in.mesh->faceCount());
      for (std::size_t i = 0; i < record->size(); ++i)
        label[(*record)[i].face] = (*record)[i].chart;
      const auto areas = chartAreas(*in.mesh, *in.gaussArea, {faceGauss.data(), faceGauss.size()}, label, 9);
      const Balance balance = balanceOf(areas.gaussArea);
      return measure == RoundMeasure::Printed ? balance.stdEq3 : balance.stdOverMean();
    };
    const double kept = badness(stepper->bestIteration());
    for (std::size_t round = 0; round < stepper->history().size(); ++round) {
      EXPECT_LE(kept, badness(round)) << round;
    }
  }
}

}  // namespace
}  // namespace chartflood
