// The film of the HandleCutter: made in the background, played, and taken to pieces by its actions.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

class HandleFilmTest : public testing::Test {
 protected:
  const ActionRegistry actions_ = makeActionRegistry();
  AppState state_{Session::Worker::Inline};

  void segment(const char* sample, int charts) {
    state_.session().openSample(sample, 2000);
    Document document = state_.document();
    document.parameters.charts = charts;
    state_.session().setDocument(document);
    state_.session().step(StepUnit::Converged);
    state_.update(0);
  }
  void waitForFilm() {
    for (int i = 0; i < 2000 && !state_.film.ready(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      state_.update(0);
    }
    ASSERT_TRUE(state_.film.ready());
  }
};

TEST_F(HandleFilmTest, NeedsAChartWithAHandle) {
  EXPECT_THAT(actions_.refusal("watch-handles", state_), HasSubstr("no model"));
  segment("sphere", 3);
  EXPECT_EQ(actions_.refusal("watch-handles", state_), "No chart has a handle.");
  EXPECT_THAT(actions_.refusal("film-play", state_), HasSubstr("No film"));
}

TEST_F(HandleFilmTest, GrowsOverTheChartAndCutsItsHandle) {
  segment("torus", 1);
  ASSERT_TRUE(state_.perform(actions_, "watch-handles"));
  EXPECT_TRUE(state_.film.active());
  waitForFilm();
  const HandleFilm& film = state_.film;
  EXPECT_EQ(film.chart(), 0u);
  EXPECT_TRUE(film.playing());
  EXPECT_EQ(film.steps(), state_.results().mesh->faceCount());
  EXPECT_EQ(film.flood()->size(), film.steps());
  EXPECT_TRUE(film.lines().cuts.empty());
  EXPECT_EQ(film.sentence(), "");

  state_.perform(actions_, "film-next-event");
  EXPECT_FALSE(film.playing());
  EXPECT_FALSE(film.sentence().empty());
  EXPECT_FALSE(film.lines().fronts.empty());
  state_.perform(actions_, "film-seek " + std::to_string(film.steps()));
  EXPECT_FALSE(film.lines().cuts.empty()) << "a torus has one handle";
  state_.perform(actions_, "film-step -3");
  EXPECT_EQ(film.position(), film.steps() - 3);
  state_.perform(actions_, "film-seek 0");
  EXPECT_TRUE(film.lines().cuts.empty()) << "going back takes the cut back";
  state_.perform(actions_, "film-close");
  EXPECT_FALSE(film.active());
}

TEST_F(HandleFilmTest, PlaysInItsTimeAndEndsWithItsCharts) {
  segment("torus", 1);
  state_.perform(actions_, "watch-handles");
  waitForFilm();
  const std::size_t steps = state_.film.steps();
  state_.perform(actions_, "film-seek 0");
  state_.perform(actions_, "film-play");
  state_.update(0.1);
  EXPECT_NEAR(static_cast<double>(state_.film.position()),
              0.1 * static_cast<double>(steps) / HandleFilm::kSeconds, 1.0);
  for (int i = 0; i < 100; ++i) state_.update(0.1);
  EXPECT_EQ(state_.film.position(), steps);
  EXPECT_FALSE(state_.film.playing());
  segment("sphere", 3);
  EXPECT_FALSE(state_.film.active());
}

TEST_F(HandleFilmTest, RefusesChartsWithoutHandles) {
  segment("torus", 1);
  EXPECT_FALSE(state_.perform(actions_, "watch-handles 7"));
  EXPECT_FALSE(state_.film.active());
}

}  // namespace
}  // namespace chartflood
