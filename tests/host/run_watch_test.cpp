// What the viewer does with runs beside each other: the next best seeds of --best-of are kept, and
// numbers of charts that were tried can be used.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

class RunWatchTest : public testing::Test {
 protected:
  const ActionRegistry actions_ = makeActionRegistry();
  AppState state_{Session::Worker::Inline};

  RunWatchTest() { state_.preferences.explore = false; }

  void perform(const std::string& line) {
    ASSERT_TRUE(state_.perform(actions_, line)) << line;
    settle();
  }
  void settle() {
    for (int i = 0; i < 3; ++i) {
      state_.session().waitIdle();
      state_.update(0);
    }
  }
  void open(const std::string& sample, std::size_t triangles) {
    state_.session().openSample(sample, triangles);
    settle();
  }
  std::vector<Index> labels() { return state_.results().segmentation->label; }
  int charts() { return state_.document().parameters.charts; }
  /// The charts of one run alone.
  static std::vector<Index> alone(const std::string& sample, std::size_t triangles,
                                  const Parameters& parameters) {
    Session session(Session::Worker::Inline);
    Document document;
    document.parameters = parameters;
    document.parameters.bestOf = 1;
    session.setDocument(document, Session::Answer::Nothing);
    session.openSample(sample, triangles);
    session.step(StepUnit::Converged);
    return session.results()->segmentation->label;
  }
};

TEST_F(RunWatchTest, TheNextBestSeedsAreKept) {
  open("bumps", 1200);
  perform("set charts 6");
  perform("set best-of 3");
  perform("run");
  const auto set = state_.results().seedRuns;
  ASSERT_TRUE(set);
  ASSERT_EQ(set->runs.size(), 3u);
  ASSERT_EQ(state_.compare.stored.size(), 2u);
  const StoredResult& a = *state_.compare.find("A");
  const StoredResult& b = *state_.compare.find("B");
  EXPECT_LE(*a.figures.seams, *b.figures.seams) << "the better one first";
  EXPECT_THAT(state_.notices.toasts().back().text, HasSubstr("kept as A, B."));
  const int chosen = set->runs[set->chosen].parameters.rngSeed;
  std::vector<int> seeds{chosen};
  for (const StoredResult* stored : {&a, &b}) {
    seeds.push_back(stored->document.parameters.rngSeed);
    EXPECT_EQ(stored->document.parameters.bestOf, 1) << "going on does not try seeds again";
    EXPECT_EQ(stored->seeds.size(), 6u);
    EXPECT_EQ(stored->results->segmentation->label,
              alone("bumps", 1200, stored->document.parameters));
  }
  EXPECT_THAT(seeds, testing::UnorderedElementsAre(1, 2, 3));
  const std::vector<Index> label = a.results->segmentation->label;
  perform("use A");
  EXPECT_EQ(labels(), label);
}

TEST_F(RunWatchTest, WhatWasStoredByHandStays) {
  open("bumps", 1200);
  perform("set charts 6");
  perform("run");
  perform("store B");
  const std::vector<Index> mine = state_.compare.find("B")->results->segmentation->label;
  perform("set best-of 5");
  perform("spread-seeds");
  perform("run");
  ASSERT_EQ(state_.compare.stored.size(), 3u);
  EXPECT_EQ(state_.compare.find("B")->results->segmentation->label, mine);
  EXPECT_LE(*state_.compare.find("A")->figures.seams, *state_.compare.find("C")->figures.seams);
  EXPECT_THAT(state_.notices.toasts().back().text, HasSubstr("kept as A, C."));
}

TEST_F(RunWatchTest, TheFoundNumberIsUsedAndOthersCanBe) {
  open("sphere", 900);
  EXPECT_THAT(actions_.refusal("use-count 4", state_), HasSubstr("Fewest charts"));
  perform("set max-stretch 1.05");
  perform("set relief-stretch 0");  // one piece with cuts would do
  const int before = charts();
  perform("find-charts");
  const auto set = state_.results().chartRuns;
  ASSERT_TRUE(set);
  const chartflood::Run& found = set->runs[set->chosen];
  EXPECT_EQ(charts(), static_cast<int>(found.charts));
  EXPECT_EQ(labels(), alone("sphere", 900, found.parameters));
  const std::size_t steps = state_.undoHistory().size();
  ASSERT_NE(set->runs.front().charts, found.charts);
  const int fewer = static_cast<int>(set->runs.front().charts);
  perform("use-count " + std::to_string(fewer));
  EXPECT_EQ(charts(), fewer);
  EXPECT_EQ(labels(), alone("sphere", 900, set->runs.front().parameters));
  EXPECT_EQ(state_.undoHistory().size(), steps + 1);
  EXPECT_EQ(state_.undoHistory().undoName(), std::to_string(fewer) + " charts");
  EXPECT_EQ(state_.results().chartRuns, set) << "the plot stays";
  perform("undo");
  EXPECT_EQ(charts(), static_cast<int>(found.charts));
  EXPECT_EQ(labels(), alone("sphere", 900, found.parameters));
  perform("undo");
  EXPECT_EQ(charts(), before);
  EXPECT_FALSE(state_.perform(actions_, "use-count 499"));
  EXPECT_THAT(state_.notices.toasts().back().text, HasSubstr("499 charts were not tried"));
}

TEST_F(RunWatchTest, AfterOtherParametersANumberIsCutAnew) {
  open("sphere", 900);
  perform("set max-stretch 1.05");
  perform("find-charts");
  const chartflood::Run tried = state_.results().chartRuns->runs.front();
  perform("set rng-seed 7");
  perform("use-count " + std::to_string(tried.charts));
  EXPECT_TRUE(state_.results().finished);
  Parameters asked = state_.document().parameters;
  EXPECT_EQ(asked.rngSeed, 7);
  EXPECT_EQ(asked.charts, static_cast<int>(tried.charts));
  EXPECT_EQ(state_.results().segmentation->chartCount, tried.charts);
}

}  // namespace
}  // namespace chartflood
