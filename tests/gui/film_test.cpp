// Looking back over a whole run: the strip of rounds, the scrubber, and what the panels say of the
// moment that is shown.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/gauss/compute_gauss_area.h"
#include "core/segment/parts/chart_areas.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

using ::testing::StartsWith;

/// A finished run of a few rounds on a small sample.
class Film : public testing::Test {
 protected:
  void SetUp() override {
    ui_.state().perform(ui_.actions(), "set charts 6");
    ui_.state().perform(ui_.actions(), "set max-iterations 5");
    ui_.openFlooded("rocket", 800);
    ui_.state().perform(ui_.actions(), "run");
    ui_.frames(3);
    ASSERT_GE(results().history.size(), 3u);
    ASSERT_TRUE(playback().atFinal());
  }
  void run(const char* line) {
    ui_.state().perform(ui_.actions(), line);
    ui_.frames(2);
  }
  const Results& results() { return ui_.state().results(); }
  const Playback& playback() { return ui_.state().playback; }

  /// What is shown must be what the log says of the moment.
  void expectAgreement() {
    ui_.frames(1);
    const Results& now = results();
    const FloodRecord& record = *now.floods[playback().round()];
    std::vector<Index> label(now.mesh->faceCount(), kNone);
    for (std::size_t i = 0; i < playback().playhead(); ++i) {
      label[record[i].face] = record[i].chart;
    }
    for (Index f = 0; f < label.size(); ++f) ASSERT_EQ(ui_.state().chartOfFace(f), label[f]) << f;
    const ChartAreas areas =
        chartAreas(*now.mesh, *now.gaussArea, faceGaussArea(*now.mesh, *now.gaussArea), label, 6);
    const ChartStats& stats = *ui_.state().shownStats();
    ASSERT_EQ(stats.charts.size(), 6u);
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_NEAR(stats.charts[c].gaussArea, areas.gaussArea[c], 1e-9);
      EXPECT_EQ(stats.charts[c].faces, static_cast<std::size_t>(std::count(
                                           label.begin(), label.end(), static_cast<Index>(c))));
    }
  }

  HeadlessFrame ui_;
};

TEST_F(Film, DraggingAlongTheStripGoesThroughTheRounds) {
  const ProbedItem strip = ui_.item("rounds");
  const auto cell = [&](std::size_t i) {
    return ImVec2(strip.min.x + 16.0f * (static_cast<float>(i) + 0.5f), strip.center().y);
  };
  ui_.moveTo(cell(0));
  ui_.press();
  EXPECT_EQ(ui_.lastLine(), "go-to-round 1");
  expectAgreement();
  ui_.moveTo(cell(2));
  EXPECT_EQ(playback().round(), 2u);
  expectAgreement();
  ui_.moveTo(cell(playback().rounds()));
  EXPECT_TRUE(playback().atFinal());
  ui_.release();
  EXPECT_TRUE(ui_.state().showsFinal());
}

TEST_F(Film, TheScrubberGoesThroughTheRoundShown) {
  run("go-to-round 2");
  ui_.drag("scrubber", 0.9f, 0.3f);
  EXPECT_EQ(playback().round(), 1u);
  EXPECT_NEAR(static_cast<double>(playback().playhead()),
              0.3 * static_cast<double>(playback().capacity()), 12);
  expectAgreement();
  ui_.drag("scrubber", 0.3f, 0.6f);
  expectAgreement();
}

TEST_F(Film, HomeAndEndAreOfTheRoundAndWithCtrlOfTheRun) {
  run("go-to-round 2 count=100");
  ui_.key("Home");
  EXPECT_EQ(playback().round(), 1u);
  EXPECT_EQ(playback().playhead(), 0u);
  ui_.key("End");
  EXPECT_EQ(playback().playhead(), playback().capacity());
  ui_.key("Ctrl+Home");
  EXPECT_EQ(playback().round(), 0u);
  EXPECT_EQ(playback().playhead(), 0u);
  ui_.key("Ctrl+End");
  EXPECT_TRUE(playback().atFinal());
}

TEST_F(Film, BordersAreSteppedThroughBackAndForth) {
  const auto record = results().seamRecord;
  ASSERT_TRUE(record);
  ASSERT_EQ(playback().borderSteps(), record->steps.size());
  ASSERT_GT(record->steps.size(), 3u);
  std::vector<Index> label = results().segmentation->label;
  const auto expectLabels = [&] {
    for (Index f = 0; f < label.size(); ++f) ASSERT_EQ(ui_.state().chartOfFace(f), label[f]) << f;
    const ChartAreas areas =
        chartAreas(*results().mesh, *results().gaussArea,
                   faceGaussArea(*results().mesh, *results().gaussArea), label, 6);
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_NEAR(ui_.state().shownStats()->charts[c].gaussArea, areas.gaussArea[c], 1e-9);
    }
  };
  for (std::size_t i = record->steps.size(); i-- > 0;) {
    record->takeBack(i, label);
    ui_.key("Left");
    ui_.frames(1);
    ASSERT_TRUE(playback().inBorders());
    expectLabels();
  }
  EXPECT_EQ(label, record->start);
  for (std::size_t i = 0; i < record->steps.size(); ++i) {
    record->play(i, label);
    ui_.key("Right");
    ui_.frames(1);
    expectLabels();
  }
  EXPECT_TRUE(ui_.state().showsFinal());
  EXPECT_EQ(ui_.state().shownStats(), results().chartStats);
}

TEST_F(Film, TheScrubberGoesThroughTheBordersOfTheFinishedCharts) {
  ui_.drag("scrubber", 0.9f, 0.5f);
  EXPECT_TRUE(playback().inBorders());
  EXPECT_NEAR(static_cast<double>(playback().borderStep()),
              0.5 * static_cast<double>(playback().borderSteps()), 1.5);
  ui_.key("Home");
  EXPECT_EQ(playback().borderStep(), 0u);
  EXPECT_TRUE(playback().inBorders());
  ui_.key("End");
  EXPECT_TRUE(playback().atFinal());
  run("go-to-border 2");
  run("go-to-round 1");
  EXPECT_FALSE(playback().inBorders());
  expectAgreement();
}

TEST_F(Film, FiguresComeBackWithTheMoment) {
  run("go-to-round 1 count=300");
  const ChartStats before = *ui_.state().shownStats();
  run("run-end");
  EXPECT_EQ(ui_.state().shownStats(), results().chartStats);
  run("step-many");  // refused: nothing lies ahead
  run("back 700");
  run("go-to-round 1 count=300");
  const ChartStats& after = *ui_.state().shownStats();
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(after.charts[c].gaussArea, before.charts[c].gaussArea);
  }
}

TEST_F(Film, DoubleClickAdoptsTheRound) {
  const ProbedItem strip = ui_.item("rounds");
  ui_.moveTo({strip.min.x + 8, strip.center().y});
  for (int i = 0; i < 2; ++i) {
    ui_.press();
    ui_.release();
  }
  ui_.frames(2);
  EXPECT_THAT(ui_.lastLine(), StartsWith("adopt 1"));
  EXPECT_EQ(results().recordIteration, 0u);
  EXPECT_EQ(results().segmentation->iteration, 0u);
  EXPECT_TRUE(ui_.state().showsFinal());
}

TEST_F(Film, SizesOfALargeStep) {
  run("go-to-round 1 count=0");
  run("many 10");
  run("step-many");
  EXPECT_EQ(playback().playhead(), 10u);
  run("many charts");
  run("step-many");
  EXPECT_EQ(playback().playhead(), 16u);
  run("back-many");
  EXPECT_EQ(playback().playhead(), 10u);
}

TEST_F(Film, AStepOfTheSelectedChartTakesItsNextTriangle) {
  run("go-to-round 1 count=100");
  ui_.state().selectedChart = 3;
  run("step-chart");
  const FloodRecord& record = *results().floods[0];
  EXPECT_EQ(record[playback().playhead() - 1].chart, 3u);
  for (std::size_t i = 100; i + 1 < playback().playhead(); ++i) EXPECT_NE(record[i].chart, 3u);
}

TEST(FilmOfARun, PlayingEndsWithTheFinishedCharts) {
  HeadlessFrame ui;
  ui.state().perform(ui.actions(), "set charts 4");
  ui.state().perform(ui.actions(), "set max-iterations 3");
  ui.openFlooded("rocket", 800);
  ui.state().perform(ui.actions(), "speed 1000000");
  ui.state().perform(ui.actions(), "play");
  bool borders = false;
  for (int i = 0; i < 500 && ui.state().playback.playing(); ++i) {
    ui.frames(1);
    borders = borders || ui.state().playback.inBorders();
  }
  EXPECT_TRUE(ui.state().results().finished);
  EXPECT_TRUE(ui.state().playback.atFinal());
  EXPECT_TRUE(borders);
}

TEST(FilmOfASession, HasAllRoundsAgainAfterUndo) {
  HeadlessFrame ui;
  ui.openFlooded("rocket", 800);
  ui.state().perform(ui.actions(), "run");
  ui.frames(3);
  const std::size_t rounds = ui.state().playback.rounds();
  ui.state().perform(ui.actions(), "set charts 7");
  ui.frames(2);
  ui.state().undo();
  ui.frames(3);
  EXPECT_TRUE(ui.state().playback.atFinal());
  ui.state().perform(ui.actions(), "run-start");
  ui.frames(1);
  EXPECT_EQ(ui.state().playback.playhead(), 0u);
  EXPECT_EQ(ui.state().playback.rounds(), rounds);
}

}  // namespace
}  // namespace chartflood
