// Charts at a moment of a flood against counting them anew: core/segment/flood_cursor.

#include "core/segment/parts/flood_cursor.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/registry.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

class FloodCursorOn : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    mesh_ = test::sampleMesh(GetParam(), 900);
    gauss_ = std::make_shared<GaussArea>(computeGaussArea(*mesh_, 30));
    const auto graph = std::make_shared<FloodGraph>(buildFloodGraph(*mesh_, *gauss_, {}));
    SegmentOptions options;
    options.charts = 6;
    const auto stepper = findSegmenter("t-flooding")->make({mesh_, gauss_, graph}, options);
    Progress progress;
    for (auto* record : {&first_, &second_}) {
      stepper->advance(StepUnit::Flood, 1, progress);
      *record = stepper->record();
    }
  }
  /// Labels and areas of a prefix of the log, counted from nothing.
  void expectAt(const FloodCursor& cursor, const FloodRecord& record, std::size_t step) {
    std::vector<Index> label(mesh_->faceCount(), kNone);
    std::vector<std::size_t> faces(6, 0);
    for (std::size_t i = 0; i < step; ++i) {
      label[record[i].face] = record[i].chart;
      ++faces[record[i].chart];
    }
    ASSERT_TRUE(std::equal(label.begin(), label.end(), cursor.labels().begin()));
    std::vector<std::size_t> open(6, 0);
    for (Index side = 0; side < mesh_->opposite().size(); ++side) {
      const Index other = mesh_->opposite()[side];
      if (other == kNone) continue;
      const Index here = label[mesh_->faceOf(side / 3)];
      if (here != kNone && label[mesh_->faceOf(other / 3)] == kNone) ++open[here];
    }
    const ChartAreas areas = chartAreas(*mesh_, *gauss_, faceGaussArea(*mesh_, *gauss_), label, 6);
    for (std::size_t chart = 0; chart < cursor.chartCount(); ++chart) {
      EXPECT_EQ(cursor.faces(chart), faces[chart]);
      EXPECT_EQ(cursor.openSides(chart), open[chart]);
      EXPECT_NEAR(cursor.gaussArea(chart), areas.gaussArea[chart], 1e-9) << chart;
    }
  }

  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const GaussArea> gauss_;
  std::shared_ptr<const FloodRecord> first_, second_;
};

TEST_P(FloodCursorOn, AgreesWithThePrefixOfTheLogWhereverItComesFrom) {
  FloodCursor cursor(std::make_shared<FloodMeasures>(mesh_, gauss_));
  const std::size_t all = mesh_->faceCount();
  for (const std::size_t step : {all / 2, all / 3, all, std::size_t{1}, all / 2, std::size_t{0}}) {
    cursor.go(first_, step);
    expectAt(cursor, *first_, step);
    cursor.go(second_, all - step);
    expectAt(cursor, *second_, all - step);
  }
}

TEST_P(FloodCursorOn, FollowsTheRefinementBackAndForth) {
  FloodCursor cursor(std::make_shared<FloodMeasures>(mesh_, gauss_));
  const std::size_t all = mesh_->faceCount();
  auto seams = std::make_shared<SeamRecord>();
  seams->start.resize(all);
  for (std::size_t i = 0; i < all; ++i) seams->start[(*first_)[i].face] = (*first_)[i].chart;
  std::vector<Index> label = seams->start;
  Rng rng(3);
  for (int i = 0; i < 6; ++i) {
    const Index a = rng.below(6), b = (a + 1 + rng.below(5)) % 6;
    SeamStep step{a, b, seams->faces.size(), 0, 0};
    const auto moves = [&](Index from) {
      for (Index f = 0; f < all; ++f) {
        if (label[f] == from && rng.below(4) == 0) seams->faces.push_back(f);
      }
    };
    moves(a);
    step.toA = seams->faces.size();
    moves(b);
    step.end = seams->faces.size();
    seams->steps.push_back(step);
    seams->play(seams->steps.size() - 1, label);
  }
  const FaceValues surface = faceAreas(*mesh_);
  cursor.go(first_, all);
  for (const std::size_t step : {3u, 6u, 0u, 5u, 4u, 6u}) {
    cursor.refine(seams, step);
    label = seams->start;
    for (std::size_t i = 0; i < step; ++i) seams->play(i, label);
    ASSERT_TRUE(std::equal(label.begin(), label.end(), cursor.labels().begin()));
    const ChartAreas areas = chartAreas(*mesh_, *gauss_, faceGaussArea(*mesh_, *gauss_), label, 6);
    for (std::size_t chart = 0; chart < 6; ++chart) {
      double area = 0;
      for (Index f = 0; f < all; ++f) area += label[f] == chart ? surface[f] : 0;
      EXPECT_NEAR(cursor.gaussArea(chart), areas.gaussArea[chart], 1e-9);
      EXPECT_NEAR(cursor.area(chart), area, 1e-9 * (1 + area));
    }
  }
  cursor.go(first_, all / 2);
  expectAt(cursor, *first_, all / 2);
  cursor.go(first_, all);
  cursor.refine(seams, 2);
  cursor.go(second_, all / 3);
  expectAt(cursor, *second_, all / 3);
}

TEST_P(FloodCursorOn, ComesBackToTheVerySameAreas) {
  FloodCursor cursor(std::make_shared<FloodMeasures>(mesh_, gauss_));
  const std::size_t all = mesh_->faceCount();
  cursor.go(first_, all / 2);
  std::vector<double> before;
  for (std::size_t c = 0; c < cursor.chartCount(); ++c) before.push_back(cursor.gaussArea(c));
  cursor.go(first_, all);
  cursor.go(first_, 0);
  for (std::size_t step = 0; step <= all / 2; ++step) cursor.go(first_, step);
  for (std::size_t c = 0; c < before.size(); ++c) EXPECT_EQ(cursor.gaussArea(c), before[c]);
}

INSTANTIATE_TEST_SUITE_P(Samples, FloodCursorOn, testing::Values("rocket", "cube", "double-torus"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(FloodCursor, WithoutALogAllIsDry) {
  const auto mesh = test::sampleMesh("cube", 100);
  FloodCursor cursor(std::make_shared<FloodMeasures>(
      mesh, std::make_shared<GaussArea>(computeGaussArea(*mesh, 45))));
  cursor.go(nullptr, 50);
  EXPECT_EQ(cursor.step(), 0u);
  EXPECT_EQ(cursor.chartCount(), 0u);
}

}  // namespace
}  // namespace chartflood
