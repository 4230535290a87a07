// Values answered with finished charts, as the window's state does it.

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "core/samples/samples.h"
#include "render/scene/chart_palette.h"

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

TEST(ExploreBesideAWorker, FinishedChartsStayUntilTheNextAreThere) {
  const ActionRegistry actions = makeActionRegistry();
  AppState state(Session::Worker::Threaded);
  state.playback.setSpeed(2 * Playback::kFastest);
  state.openSample("bumps", 3000);
  const auto rest = [&](bool watched) {
    do {
      state.update(1.0 / 60);
      if (!watched) continue;
      EXPECT_TRUE(state.showsFinal());
      EXPECT_TRUE(state.results().segmentation->complete);
      EXPECT_TRUE(state.results().atlas) << "there is a texture to look at";
    } while (state.status().busy || state.playback.playing());
  };
  while (!state.results().flat) rest(false);
  for (const char* line : {"set charts 9 drag=on", "set charts 11 drag=on", "set charts 11",
                           "set sharp-angle 30", "undo", "set speed-power 2", "undo", "redo"}) {
    ASSERT_TRUE(state.perform(actions, line));
    rest(true);
  }
  EXPECT_TRUE(state.results().flat);
  EXPECT_FALSE(state.results().sketch);
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

TEST_F(Explore, OneKeyIsOneSmallStepWhileWatching) {
  perform("explore off");
  open();
  ASSERT_TRUE(state_.playback.complete());
  const std::size_t rounds = state_.results().history.size();
  for (std::size_t step = 1; step <= 3; ++step) {
    perform("step");
    EXPECT_EQ(state_.playback.playhead(), step) << "of the next round";
    EXPECT_EQ(state_.results().history.size(), rounds);
    EXPECT_FALSE(state_.results().finished);
  }
  perform("set speed-power 2");
  perform("step");
  EXPECT_FALSE(state_.results().finished);
}

/// Of the faces that a chart shares with one before, where that is half of both: how many have the
/// colour that they had.
struct Kept {
  std::size_t faces = 0, kept = 0;
};
Kept keptColors(const Segmentation& before, std::span<const Index> colorBefore,
                const Segmentation& after, std::span<const Index> colorAfter) {
  std::map<std::pair<Index, Index>, std::size_t> shared;
  std::vector<std::size_t> size(after.chartCount, 0), old(before.chartCount, 0);
  for (std::size_t f = 0; f < after.label.size(); ++f) {
    ++shared[{before.label[f], after.label[f]}];
    ++size[after.label[f]];
    ++old[before.label[f]];
  }
  Kept sum;
  for (const auto& [pair, faces] : shared) {
    if (2 * faces < std::max(size[pair.second], old[pair.first])) continue;
    sum.faces += faces;
    if (colorBefore[pair.first] == colorAfter[pair.second]) sum.kept += faces;
  }
  return sum;
}

/// The share of colours kept over 50 small steps of p.
double keptOverSteps(const std::shared_ptr<const Mesh>& mesh, Session::Answer answer) {
  Session session(Session::Worker::Inline);
  session.openMesh(mesh);
  Document document;
  session.setDocument(document, Session::Answer::Finished);
  std::shared_ptr<const Segmentation> before = session.results()->segmentation;
  const auto paint = [&](const Segmentation& labels, std::span<const Index> previous) {
    return colorCharts(labels.chartCount, neighbourCharts(*mesh, labels.label), previous,
                       chartPaletteTable()[0]);
  };
  std::vector<Index> colors = paint(*before, {});
  Kept sum;
  for (int step = 1; step <= 50; ++step) {
    document.parameters.speedPower = 1 + 0.02 * step;
    session.setDocument(document, answer);
    const std::shared_ptr<const Segmentation> after = session.results()->segmentation;
    const std::vector<Index> now = paint(
        *after, inheritedColors(*mesh, before->label, colors, after->label, after->chartCount));
    const Kept kept = keptColors(*before, colors, *after, now);
    sum.faces += kept.faces;
    sum.kept += kept.kept;
    before = after;
    colors = now;
  }
  return static_cast<double>(sum.kept) / static_cast<double>(sum.faces);
}

TEST(ChartColors, AreAMovementOverSmallSteps) {
  const std::shared_ptr<const Mesh> mesh = buildMesh(makeSample("bumps", 4000));
  for (const Session::Answer answer : {Session::Answer::Sketch, Session::Answer::Finished}) {
    const double kept = keptOverSteps(mesh, answer);
    RecordProperty("kept", std::to_string(kept));
    EXPECT_GE(kept, 0.95);
  }
}

TEST(ChartColors, AreAMovementOnTheBunny) {
  const std::filesystem::path file = CHARTFLOOD_MESHES "/stanford-bunny.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const std::shared_ptr<const Mesh> mesh = buildMesh(readMesh(file));
  const double kept = keptOverSteps(mesh, Session::Answer::Sketch);
  RecordProperty("kept", std::to_string(kept));
  EXPECT_GE(kept, 0.95);
}

}  // namespace
}  // namespace chartflood
