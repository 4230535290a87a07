// The transport over a flood's record: what is shown, and what is asked of the worker.

#include <gtest/gtest.h>

#include "app/host/playback.h"

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
  stopped.stopped = true;
  EXPECT_EQ(playback.update(stopped, 0.05), std::nullopt);
  EXPECT_EQ(playback.playhead(), 50u) << "a finished flood is shown again from its start";
  EXPECT_EQ(playback.update(stopped, 1), std::nullopt);
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

}  // namespace
}  // namespace chartflood
