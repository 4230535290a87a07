// Values answered with finished charts, as the window's state does it.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

class Explore : public testing::Test {
 protected:
  const ActionRegistry actions_ = makeActionRegistry();
  AppState state_{Session::Worker::Inline};

  void SetUp() override { state_.playback.setSpeed(2 * Playback::kFastest); }
  void perform(const std::string& line) {
    ASSERT_TRUE(state_.perform(actions_, line)) << line;
    settle();
  }
  void settle() {
    for (int i = 0; i < 12; ++i) {
      state_.session().waitIdle();
      state_.update(1.0 / 60);
    }
  }
  void open(const std::string& sample = "bumps", std::size_t triangles = 2000) {
    state_.openSample(sample, triangles);
    settle();
  }
  const std::vector<Index>& labels() { return state_.results().segmentation->label; }
  /// What a batch run with the present values gives.
  std::vector<Index> batch() {
    Session session(Session::Worker::Inline);
    session.openMesh(state_.results().mesh);
    session.setDocument(state_.document(), Session::Answer::Nothing);
    session.step(StepUnit::Converged);
    return session.results()->segmentation->label;
  }
};

TEST_F(Explore, AModelIsFloodedOnceAndThenFinished) {
  open();
  EXPECT_TRUE(state_.results().finished);
  EXPECT_TRUE(state_.results().flat) << "with its texture";
  EXPECT_TRUE(state_.showsFinal());
  EXPECT_EQ(labels(), batch());
}

TEST_F(Explore, AFloodThatWasPausedStaysWhereItIs) {
  state_.playback.setSpeed(60);
  state_.openSample("bumps", 2000);
  state_.update(1.0 / 60);
  state_.update(1.0 / 60);
  perform("play");
  ASSERT_FALSE(state_.playback.playing());
  EXPECT_FALSE(state_.results().finished);
}

TEST_F(Explore, AValueGivesFinishedCharts) {
  open();
  for (const char* line : {"set speed-power 2", "set charts 9", "set sharp-angle 20",
                           "set crease-weight 0.6", "set best-of 2", "set patience 3"}) {
    perform(line);
    EXPECT_TRUE(state_.results().finished && state_.results().flat) << line;
    EXPECT_TRUE(state_.showsFinal()) << line;
    EXPECT_EQ(labels(), batch()) << line;
  }
}

TEST_F(Explore, ADragIsSketchedAndSettlesWhenLetGo) {
  open();
  perform("set speed-power 1.5 drag=on");
  EXPECT_TRUE(state_.results().sketch);
  EXPECT_TRUE(state_.showsFinal()) << "whole charts, not a flood";
  EXPECT_TRUE(state_.results().segmentation->complete);
  EXPECT_THAT(actions_.refusal("export-labels x.txt", state_), HasSubstr("complete charts"));
  EXPECT_THAT(actions_.refusal("store A", state_), HasSubstr("no charts"));
  perform("set speed-power 1.5");
  EXPECT_FALSE(state_.results().sketch);
  EXPECT_EQ(labels(), batch());
}

TEST_F(Explore, ChartsDoNotDependOnTheWay) {
  open();
  perform("set charts 12");
  const std::vector<Index> straight = labels();
  perform("set charts 30 drag=on");
  perform("set charts 7 drag=on");
  perform("set charts 7");
  perform("set speed-power 3");
  perform("set charts 12");
  perform("set speed-power 1");
  EXPECT_EQ(labels(), straight);
}

TEST_F(Explore, UndoBringsTheFilmAndTheTextureBack) {
  open();
  const std::shared_ptr<const Results> before = state_.sharedResults();
  ASSERT_GT(before->history.size(), 1u);
  perform("set charts 9");
  ASSERT_NE(state_.results().segmentation, before->segmentation);
  perform("undo");
  EXPECT_EQ(state_.results().segmentation, before->segmentation) << "the very same";
  EXPECT_EQ(state_.results().atlas, before->atlas);
  EXPECT_EQ(state_.results().floods, before->floods);
  perform("redo");
  EXPECT_EQ(labels(), batch());
}

TEST_F(Explore, ADragIsOneStepOfUndo) {
  open();
  const std::vector<Index> before = labels();
  for (const char* p : {"1.2", "1.4", "1.6"}) {
    perform(std::string("set speed-power ") + p + " drag=on");
  }
  perform("set speed-power 1.6");
  perform("undo");
  EXPECT_EQ(state_.document().parameters.speedPower, 1);
  EXPECT_EQ(labels(), before);
  EXPECT_FALSE(state_.undoHistory().canUndo());
}

TEST_F(Explore, FiguresAreHeldAgainstThoseBefore) {
  open();
  const CompareFigures before = state_.liveFigures();
  perform("set charts 9");
  ASSERT_TRUE(state_.earlierFigures());
  EXPECT_EQ(state_.earlierFigures()->seams, before.seams);
  EXPECT_NE(state_.liveFigures().seams, before.seams);
}

TEST_F(Explore, SeedsByHandStayWhereTheyWerePut) {
  open("bumps", 2000);
  perform("set charts 6");
  const std::size_t moved = 2;
  const Index face = 100;
  perform("move-seed " + std::to_string(moved) + ' ' + std::to_string(face));
  ASSERT_EQ(state_.presentSeeds().size(), 6u);
  EXPECT_EQ(state_.presentSeeds()[moved].face, face);
  EXPECT_EQ(labels(), batch());
  perform("set charts 8");
  EXPECT_EQ(state_.presentSeeds().size(), 8u) << "the other two were placed by the method";
  EXPECT_EQ(state_.presentSeeds()[moved].face, face);
  perform("add-seed 700");
  EXPECT_EQ(state_.document().parameters.charts, 9);
  EXPECT_EQ(labels(), batch());
}

TEST_F(Explore, EscLeadsFromTheFilmToTheFinishedCharts) {
  open();
  perform("run-start");
  ASSERT_FALSE(state_.showsFinal());
  perform("stop");
  EXPECT_TRUE(state_.showsFinal());
}

TEST_F(Explore, TheWayToTheEndIsNeverRefused) {
  open();
  EXPECT_EQ(actions_.refusal("run", state_), "");
  perform("run");
  EXPECT_EQ(labels(), batch());
}

TEST_F(Explore, OffValuesAreAnsweredWithAFlood) {
  perform("explore off");
  open();
  perform("run");
  EXPECT_THAT(actions_.refusal("run", state_), HasSubstr("finished"));
  perform("set patience 3");
  EXPECT_EQ(actions_.refusal("run", state_), "") << "a rule of the rounds has changed";
  perform("run");
  EXPECT_EQ(labels(), batch());
  perform("set charts 9");
  EXPECT_FALSE(state_.results().finished);
  EXPECT_EQ(state_.results().history.size(), 1u);
  EXPECT_FALSE(state_.earlierFigures());
}

}  // namespace
}  // namespace chartflood
