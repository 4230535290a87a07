// The transport over a flood's record: what is shown, and what is asked of the worker.

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/host/film/playback.h"

namespace chartflood {
namespace {

std::shared_ptr<FloodRecord> record(std::size_t capacity, std::size_t filled) {
  auto log = std::make_shared<FloodRecord>(capacity);
  for (std::size_t i = 0; i < filled; ++i) log->append(static_cast<Index>(i), 0, 0);
  log->publish();
  return log;
}

Playback::Source source(std::shared_ptr<const FloodRecord> log) {
  return {true, log, false, false};
}

TEST(Playback, FollowsTheRecordWhilePaused) {
  Playback playback;
  auto log = record(100, 10);
  EXPECT_EQ(playback.update(source(log), 0.1), std::nullopt);
  EXPECT_EQ(playback.playhead(), 10u);
  log->append(10, 0, 0);
  log->publish();
  EXPECT_EQ(playback.playhead(), 11u);
}

TEST(Playback, AsksForTheFirstFloodAndThenPlaysItInThreeSeconds) {
  Playback playback;
  playback.playOneFlood();
  EXPECT_EQ(playback.update(source(nullptr), 0.1), (StepRequest{StepUnit::Flood, 1}));
  const auto log = record(3000, 3000);
  playback.update(source(log), 0);
  EXPECT_EQ(playback.playhead(), 0u);
  playback.update(source(log), 1.0);
  EXPECT_EQ(playback.playhead(), 1000u);
  EXPECT_EQ(playback.update(source(log), 2.5), std::nullopt);
  EXPECT_EQ(playback.playhead(), 3000u);
  EXPECT_FALSE(playback.playing());
}

TEST(Playback, SixtyRoundsAreWatchedInFifteenSeconds) {
  std::vector<std::shared_ptr<const FloodRecord>> rounds;
  for (int i = 0; i < 60; ++i) rounds.push_back(record(3000, 3000));
  Playback::Source run = source(rounds.back());
  run.rounds = rounds;
  run.round = 59;
  run.stopped = run.finished = true;
  run.borderSteps = 100;
  Playback playback;
  playback.update(run, 0);
  playback.play();
  constexpr double kFrame = 1.0 / 60;
  double seconds = 0, first = 0;
  while (playback.playing() && seconds < 100) {
    playback.update(run, kFrame);
    seconds += kFrame;
    if (playback.round() == 0 && !playback.inBorders()) first = seconds;
  }
  EXPECT_TRUE(playback.atFinal());
  EXPECT_NEAR(first, Playback::kDefaultSeconds, 0.1);
  EXPECT_LT(seconds, 15);
  EXPECT_GT(seconds, 10);
}

TEST(Playback, RunningAsksForTheNextRoundAtTheEnd) {
  Playback playback;
  const auto log = record(100, 100);
  playback.update(source(log), 0);
  playback.play();
  EXPECT_EQ(playback.update(source(log), 0.1), (StepRequest{StepUnit::Iteration, 1}));
}

TEST(Playback, StopsWhenAStopRuleFired) {
  Playback playback;
  const auto log = record(100, 100);
  playback.update(source(log), 0);
  playback.play();
  playback.setSpeed(1000);
  Playback::Source stopped = source(log);
  stopped.stopped = stopped.finished = true;
  EXPECT_EQ(playback.update(stopped, 0.05), std::nullopt);
  EXPECT_EQ(playback.playhead(), 50u) << "a finished flood is shown again from its start";
  EXPECT_EQ(playback.update(stopped, 1), std::nullopt);
  EXPECT_FALSE(playback.playing());
}

TEST(Playback, AsksForTheFinishedChartsOnceAfterAStopRule) {
  Playback playback;
  const auto log = record(100, 100);
  playback.update(source(log), 0);
  playback.play();
  Playback::Source stopped = source(log);
  stopped.stopped = true;
  EXPECT_EQ(playback.update(stopped, 0.1), (StepRequest{StepUnit::Iteration, 1}));
  EXPECT_EQ(playback.update(stopped, 0.1), std::nullopt) << "the worker was stopped";
  EXPECT_FALSE(playback.playing());
}

TEST(Playback, PausesWhenTheWorkerGivesNothing) {
  Playback playback;
  const auto log = record(100, 40);
  playback.update(source(log), 0);
  playback.play();
  EXPECT_TRUE(playback.update(source(log), 0.1).has_value());
  EXPECT_EQ(playback.update(source(log), 0.1), std::nullopt);
  EXPECT_FALSE(playback.playing());
}

TEST(Playback, AsksNothingWhileTheWorkerIsBusy) {
  Playback playback;
  const auto log = record(100, 40);
  playback.update(source(log), 0);
  playback.play();
  Playback::Source busy = source(log);
  busy.busy = true;
  EXPECT_EQ(playback.update(busy, 1), std::nullopt);
  EXPECT_TRUE(playback.playing());
}

TEST(Playback, StepsComeFromTheRecordFirst) {
  Playback playback;
  playback.update(source(record(100, 10)), 0);
  playback.stepBack(4);
  EXPECT_EQ(playback.playhead(), 6u);
  EXPECT_EQ(playback.stepForward(3), std::nullopt);
  EXPECT_EQ(playback.playhead(), 9u);
  EXPECT_EQ(playback.stepForward(5), (StepRequest{StepUnit::Face, 4}));
  EXPECT_EQ(playback.playhead(), 10u);
}

TEST(Playback, StepBackStopsAtTheStart) {
  Playback playback;
  playback.update(source(record(100, 10)), 0);
  playback.stepBack(50);
  EXPECT_EQ(playback.playhead(), 0u);
}

TEST(Playback, ANewRecordWhilePlayingStartsAtItsBeginning) {
  Playback playback;
  playback.update(source(record(100, 100)), 0);
  playback.play();
  playback.update(source(record(100, 60)), 0);
  EXPECT_EQ(playback.playhead(), 0u);
}

/// Three finished rounds of 100 faces and a fourth with 10.
class RunPlayback : public testing::Test {
 protected:
  using Logs = std::vector<std::shared_ptr<const FloodRecord>>;

  Playback::Source run() const {
    return {true, live_, busy_, finished_, finished_, liveRound_, rounds_, borderSteps_};
  }
  void SetUp() override { playback_.update(run(), 0); }
  std::pair<std::size_t, std::size_t> moment() const {
    return {playback_.round(), playback_.playhead()};
  }
  using Moment = std::pair<std::size_t, std::size_t>;
  /// A stop rule has fired: the second round is the best one.
  void finish() {
    rounds_.push_back(live_);
    live_ = rounds_[1];
    liveRound_ = 1;
    finished_ = true;
    playback_.update(run(), 0);
  }

  Logs rounds_ = {record(100, 100), record(100, 100), record(100, 100)};
  std::shared_ptr<const FloodRecord> live_ = record(100, 10);
  std::size_t liveRound_ = 3;
  bool busy_ = false, finished_ = false;
  std::size_t borderSteps_ = 0;
  Playback playback_;
};

TEST_F(RunPlayback, StepsBackThroughTheRoundsAndForwardAgain) {
  EXPECT_EQ(moment(), Moment(3, 10));
  std::vector<Moment> seen;
  for (int i = 0; i < 230; ++i) {
    playback_.stepBack(1);
    playback_.update(run(), 0);
    seen.push_back(moment());
  }
  EXPECT_EQ(seen[9], Moment(2, 100));
  EXPECT_EQ(seen.back(), Moment(0, 80));
  for (std::size_t i = seen.size() - 1; i > 0; --i) {
    EXPECT_EQ(playback_.stepForward(1), std::nullopt);
    EXPECT_EQ(moment(), seen[i - 1]);
  }
  EXPECT_EQ(playback_.stepForward(4), (StepRequest{StepUnit::Face, 3}));
}

TEST_F(RunPlayback, AnyStepLeadsToTheSameMomentAsManySmallOnes) {
  playback_.goTo(0, 37);
  playback_.stepForward(150);
  EXPECT_EQ(moment(), Moment(1, 87));
  playback_.stepBack(150);
  EXPECT_EQ(moment(), Moment(0, 37));
}

TEST_F(RunPlayback, StaysWhereItIsWhileTheWorkerGoesOn) {
  playback_.goTo(1, 50);
  rounds_.push_back(live_);
  live_ = record(100, 20);
  liveRound_ = 4;
  playback_.update(run(), 0.1);
  EXPECT_EQ(moment(), Moment(1, 50));
  EXPECT_EQ(playback_.rounds(), 5u);
}

TEST_F(RunPlayback, AMomentOfTheFloodUnderWayBecomesOneOfItsRound) {
  playback_.seek(5);
  rounds_.push_back(live_);
  live_ = record(100, 20);
  liveRound_ = 4;
  playback_.update(run(), 0.1);
  EXPECT_EQ(moment(), Moment(3, 5));
}

TEST_F(RunPlayback, PlaysThroughTheRoundsAndThenAsksForMore) {
  playback_.goTo(1, 90);
  playback_.setSpeed(100);
  playback_.play();
  EXPECT_EQ(playback_.update(run(), 0.2), std::nullopt);
  EXPECT_EQ(moment(), Moment(2, 10));
  for (int i = 0; i < 9; ++i) EXPECT_EQ(playback_.update(run(), 0.1), std::nullopt);
  EXPECT_EQ(playback_.update(run(), 0.1), (StepRequest{StepUnit::Flood, 1}));
  EXPECT_EQ(moment(), Moment(3, 10));
}

TEST_F(RunPlayback, OneFloodEndsWithItsRound) {
  playback_.goTo(1, 90);
  playback_.setSpeed(100);
  playback_.playOneFlood();
  playback_.update(run(), 0.5);
  EXPECT_EQ(moment(), Moment(1, 100));
  EXPECT_FALSE(playback_.playing());
}

TEST_F(RunPlayback, TheFinishedChartsAreTheLastPicture) {
  finish();
  EXPECT_TRUE(playback_.atFinal());
  EXPECT_TRUE(playback_.atEndOfRun());
  playback_.stepBack(1);
  EXPECT_FALSE(playback_.atFinal());
  EXPECT_EQ(moment(), Moment(3, 10));
  playback_.goTo(3, 100);
  EXPECT_FALSE(playback_.atFinal());
  EXPECT_EQ(playback_.stepForward(1), std::nullopt);
  EXPECT_TRUE(playback_.atFinal());
}

TEST_F(RunPlayback, StepsOfTheRefinementStandBetweenTheLastRoundAndTheFinishedCharts) {
  borderSteps_ = 7;
  finish();
  EXPECT_TRUE(playback_.atFinal());
  EXPECT_EQ(playback_.borderStep(), 7u);
  for (std::size_t left = 7; left > 0; --left) {
    playback_.stepBack(1);
    playback_.update(run(), 0);
    EXPECT_TRUE(playback_.inBorders());
    EXPECT_EQ(playback_.borderStep(), left - 1);
    EXPECT_EQ(playback_.record(), live_) << "what was flooded is that of the kept round";
  }
  playback_.stepBack(3);
  EXPECT_EQ(moment(), Moment(3, 8));
  EXPECT_FALSE(playback_.inBorders());
  EXPECT_EQ(playback_.stepForward(5), std::nullopt);
  EXPECT_EQ(playback_.borderStep(), 2u);
  EXPECT_EQ(playback_.stepForward(100), std::nullopt);
  EXPECT_TRUE(playback_.atFinal());
  playback_.stepBack(9);
  EXPECT_EQ(moment(), Moment(3, 9));
}

TEST_F(RunPlayback, TheRefinementIsPlayedBehindTheLastRound) {
  borderSteps_ = 10;
  live_ = record(100, 100);
  finish();
  playback_.goTo(3, 90);
  playback_.setSpeed(100 / Playback::kDefaultSeconds);
  playback_.play();
  playback_.update(run(), 0.5);
  EXPECT_TRUE(playback_.inBorders());
  playback_.update(run(), 0.52 * Playback::kBorderSeconds);
  EXPECT_EQ(playback_.borderStep(), 5u);
  EXPECT_TRUE(playback_.playing());
  playback_.update(run(), 0.6 * Playback::kBorderSeconds);
  EXPECT_TRUE(playback_.atFinal());
  EXPECT_FALSE(playback_.playing());
}

TEST_F(RunPlayback, AnotherRunLeavesTheRefinement) {
  borderSteps_ = 10;
  finish();
  playback_.goToBorder(4);
  live_ = record(100, 100);
  liveRound_ = 0;
  rounds_ = {live_};
  borderSteps_ = 20;
  playback_.update(run(), 0);
  EXPECT_FALSE(playback_.inBorders());
  EXPECT_TRUE(playback_.atFinal());
}

TEST_F(RunPlayback, AFinishedRunIsPlayedFromItsBeginningToTheFinishedCharts) {
  rounds_.back() = record(100, 100);
  live_ = record(100, 100);
  playback_.update(run(), 0);
  finish();
  playback_.setSpeed(100);
  playback_.play();
  playback_.update(run(), 0.5);
  EXPECT_EQ(moment(), Moment(0, 50));
  for (int i = 0; i < 10 && playback_.playing(); ++i) playback_.update(run(), 0.9);
  EXPECT_TRUE(playback_.atFinal());
}

TEST_F(RunPlayback, ADroppedRoundIsAskedForAndThenShown) {
  rounds_[1] = nullptr;
  playback_.update(run(), 0);
  playback_.goTo(1, 40);
  EXPECT_EQ(playback_.missingRound(), 1u);
  EXPECT_EQ(moment(), Moment(1, 0));
  rounds_[1] = record(100, 100);
  playback_.update(run(), 0);
  EXPECT_EQ(playback_.missingRound(), std::nullopt);
  EXPECT_EQ(moment(), Moment(1, 40));
}

TEST_F(RunPlayback, AnotherRunBeginsAtItsEnd) {
  playback_.goTo(2, 40);
  rounds_.clear();
  live_ = record(100, 7);
  liveRound_ = 0;
  playback_.update(run(), 0);
  EXPECT_EQ(moment(), Moment(0, 7));
}

TEST_F(RunPlayback, AStepOfAChartEndsWithItsNextTriangle) {
  auto log = std::make_shared<FloodRecord>(20);
  for (Index i = 0; i < 20; ++i) log->append(i, i % 3, 0);
  log->publish();
  Playback playback;
  playback.update(source(log), 0);
  playback.seek(4);
  EXPECT_EQ(playback.stepChart(0), std::nullopt);
  EXPECT_EQ(playback.playhead(), 7u);
  EXPECT_EQ((*log)[6].chart, 0u);
}

}  // namespace
}  // namespace chartflood
