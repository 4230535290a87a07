// The three methods side by side: run beside the live charts, given up, refused.

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

class MethodRunsTest : public testing::Test {
 protected:
  const ActionRegistry actions_ = makeActionRegistry();

  /// A model with five charts, cut to the end.
  void segment(AppState& state, std::size_t triangles) {
    state.session().openSample("bumps", triangles);
    Document document;
    document.parameters.charts = 5;
    state.session().setDocument(document);
    state.session().step(StepUnit::Converged);
    state.session().waitIdle();
    state.update(0);
  }
  void waitForRuns(AppState& state) {
    for (int i = 0; i < 10'000 && state.methodRuns.running(); ++i) {
      state.update(0);
      if (state.methodRuns.running()) std::this_thread::sleep_for(std::chrono::milliseconds(3));
    }
    ASSERT_FALSE(state.methodRuns.running());
  }
};

TEST_F(MethodRunsTest, FillTheSlotsAndLeaveTheLiveChartsAlone) {
  AppState state{Session::Worker::Inline};
  segment(state, 1200);
  const Document document = state.document();
  const auto live = state.results().segmentation;
  ASSERT_TRUE(state.perform(actions_, "compare-methods"));
  waitForRuns(state);
  EXPECT_EQ(state.document(), document);
  EXPECT_EQ(state.results().segmentation, live);
  const auto& stored = state.compare.stored;
  ASSERT_EQ(stored.size(), 3u);
  EXPECT_EQ(state.compare.panes().size(), 3u);
  const char* const methods[] = {"mcgim", "vsa", "t-flooding"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(stored[i].name, kCompareSlots[i]);
    EXPECT_EQ(stored[i].figures.method, methods[i]);
    EXPECT_EQ(stored[i].figures.charts, 5u);
    EXPECT_EQ(stored[i].seeds.size(), 5u);
    EXPECT_TRUE(stored[i].results->flat);
    EXPECT_TRUE(stored[i].figures.stretch.has_value());
  }
  EXPECT_EQ(stored[2].results->segmentation->label, live->label);
  EXPECT_LT(*stored[2].figures.spread, *stored[0].figures.spread);
}

TEST_F(MethodRunsTest, GiveWhatEachMethodGivesAloneAndCanBeUsed) {
  AppState state{Session::Worker::Inline};
  segment(state, 1200);
  state.perform(actions_, "compare-methods");
  waitForRuns(state);
  ASSERT_TRUE(state.perform(actions_, "set method vsa"));
  state.update(0);
  state.session().step(StepUnit::Converged);
  state.session().waitIdle();
  state.update(0);
  const auto alone = state.results().segmentation->label;
  EXPECT_EQ(state.compare.find("B")->results->segmentation->label, alone);
  ASSERT_TRUE(state.perform(actions_, "use A"));
  state.update(0);
  EXPECT_EQ(state.document().parameters.method, "mcgim");
  EXPECT_EQ(state.results().segmentation->label,
            state.compare.find("A")->results->segmentation->label);
  // Once more, with other values: the slots are the comparison's own.
  ASSERT_TRUE(state.perform(actions_, "set charts 4"));
  state.update(0);
  ASSERT_TRUE(state.perform(actions_, "compare-methods"));
  waitForRuns(state);
  ASSERT_EQ(state.compare.stored.size(), 3u);
  EXPECT_EQ(state.compare.find("C")->figures.charts, 4u);
}

TEST_F(MethodRunsTest, AreGivenUpByStop) {
  AppState state{Session::Worker::Threaded};
  segment(state, 30'000);
  const auto live = state.results().segmentation;
  ASSERT_TRUE(state.perform(actions_, "compare-methods"));
  EXPECT_TRUE(state.methodRuns.running());
  EXPECT_THAT(state.methodRuns.state().words, HasSubstr("mcgim: "));
  EXPECT_THAT(actions_.refusal("compare-methods", state), HasSubstr("Esc gives up"));
  EXPECT_THAT(actions_.refusal("store A", state), HasSubstr("Esc gives up"));
  ASSERT_TRUE(state.perform(actions_, "stop"));
  EXPECT_FALSE(state.methodRuns.running());
  state.update(0);
  EXPECT_TRUE(state.compare.stored.empty());
  EXPECT_EQ(state.results().segmentation, live);
  EXPECT_EQ(actions_.refusal("compare-methods", state), "");
}

TEST_F(MethodRunsTest, NeedAModelAndFreeSlots) {
  AppState state{Session::Worker::Inline};
  EXPECT_THAT(actions_.refusal("compare-methods", state), HasSubstr("no model"));
  segment(state, 600);
  ASSERT_TRUE(state.perform(actions_, "store B"));
  EXPECT_THAT(actions_.refusal("compare-methods", state), HasSubstr("clear them first"));
  EXPECT_FALSE(state.perform(actions_, "compare-methods"));
  ASSERT_EQ(state.compare.stored.size(), 1u);
  ASSERT_TRUE(state.perform(actions_, "clear-compare"));
  EXPECT_EQ(actions_.refusal("compare-methods", state), "");
}

TEST_F(MethodRunsTest, EndWithTheirModel) {
  AppState state{Session::Worker::Threaded};
  segment(state, 30'000);
  state.perform(actions_, "compare-methods");
  state.session().openSample("sphere", 300);
  state.session().waitIdle();
  state.update(0);
  EXPECT_FALSE(state.methodRuns.running());
  EXPECT_TRUE(state.compare.stored.empty());
}

}  // namespace
}  // namespace chartflood
