// Nothing is lost: the mark of unsaved changes, the question, session files and what a crash left.

#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/actions.h"
#include "app/host/files/session_view.h"
#include "tests/gui/headless_frame.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using testing::HasSubstr;

class Work : public testing::Test {
 protected:
  Work() { ui_.openFlooded("bumps", 2000); }
  AppState& state() { return ui_.state(); }
  void run(const std::string& line) {
    EXPECT_TRUE(state().perform(ui_.actions(), line)) << line;
    ui_.frames(3);
  }
  std::string path(const char* name) const { return (folder_.path() / name).string(); }
  std::vector<Index> labels() { return state().results().segmentation->label; }
  std::string lastToast() { return state().notices.toasts().back().text; }
  std::filesystem::path states() const { return folder_.path() / "state"; }
  std::vector<std::string> copies() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(states())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  /// A copy as a process that is gone leaves it.
  std::filesystem::path leaveCopy(const char* name) {
    const auto copy = states() / name;
    std::filesystem::create_directories(states());
    run("set charts 11");
    run("save-session file=" + copy.string());
    run("sample sphere triangles=500");
    return copy;
  }

  TemporaryFolder folder_;
  HeadlessFrame ui_;
};

TEST_F(Work, OnlyChangesAreUnsaved) {
  EXPECT_FALSE(state().unsaved()) << "it was only opened";
  run("run");
  run("color-mode balance");
  run("view top");
  EXPECT_FALSE(state().unsaved()) << "it was only looked at";
  run("set charts 9");
  EXPECT_TRUE(state().unsaved());
  run("undo");
  EXPECT_FALSE(state().unsaved());
  run("add-seed face=9");
  EXPECT_TRUE(state().unsaved());
  run("save-session file=" + path("a.chartflood"));
  EXPECT_FALSE(state().unsaved());
}

TEST_F(Work, ASavedSessionComesBackAsItWas) {
  run("iteration");
  run("add-seed face=9");
  run("lock-seed seed=20");
  run("set speed-power 2");
  run("color-mode balance");
  run("view top");
  run("numbers on");
  const Document document = state().document();
  const std::vector<Index> label = labels();
  const ViewSettings view = state().view;
  run("save-session file=" + path("a.chartflood"));
  run("sample sphere triangles=500");
  run("reset-all");
  run("color-mode charts");
  run("view front");
  state().preferences.askUnsaved = false;
  run("open " + path("a.chartflood"));
  EXPECT_EQ(state().modelName(), "bumps");
  EXPECT_EQ(state().document(), document);
  EXPECT_EQ(labels(), label);
  EXPECT_EQ(state().view.render, view.render);
  EXPECT_EQ(state().view.camera, view.camera);
  EXPECT_FALSE(state().unsaved());
  EXPECT_EQ(state().preferences.recentFiles.front(), path("a.chartflood"));
}

TEST_F(Work, TheFirstSaveAsksForAName) {
  ui_.key("Ctrl+S");
  ui_.frames(3);
  EXPECT_EQ(state().panels.browse, PanelState::Browse::SaveSession);
  EXPECT_TRUE(ui_.has("browser-name"));
  run("close-browser");
  run("save-session file=" + path("a"));
  EXPECT_TRUE(std::filesystem::exists(path("a.chartflood"))) << "the ending is added";
  run("set charts 7");
  ui_.key("Ctrl+S");
  ui_.frames(2);
  EXPECT_EQ(state().panels.browse, PanelState::Browse::Nothing) << "the name is known";
  EXPECT_FALSE(state().unsaved());
  ui_.key("Ctrl+Shift+S");
  EXPECT_EQ(state().panels.browse, PanelState::Browse::SaveSession);
}

TEST_F(Work, BrokenSessionsChangeNothing) {
  run("set charts 9");
  const Document document = state().document();
  const std::vector<Index> label = labels();
  writeAll(path("b.chartflood"), "{\"chartflood-session\": 1");
  state().preferences.askUnsaved = false;
  EXPECT_FALSE(state().perform(ui_.actions(), "open " + path("b.chartflood")));
  EXPECT_THAT(lastToast(), HasSubstr("Could not read"));
  ui_.frames(3);
  EXPECT_EQ(state().document(), document);
  EXPECT_EQ(labels(), label);
}

TEST_F(Work, AFailedSaveIsToldAndLeavesItUnsaved) {
  run("set charts 9");
  EXPECT_FALSE(state().perform(ui_.actions(), "save-session file=" + path("no/where.chartflood")));
  EXPECT_THAT(lastToast(), HasSubstr("Could not write"));
  EXPECT_TRUE(state().unsaved());
}

TEST_F(Work, QuittingAsksAndCancelStays) {
  run("set charts 9");
  ui_.key("Ctrl+Q");
  ui_.frames(3);
  EXPECT_FALSE(state().requests.quit);
  ui_.click("answer cancel");
  ui_.frames(2);
  EXPECT_FALSE(ui_.has("answer cancel"));
  EXPECT_FALSE(state().requests.quit);
  ui_.key("Ctrl+Q");
  ui_.frames(3);
  ui_.escape();
  EXPECT_FALSE(ui_.has("answer cancel"));
  EXPECT_FALSE(state().requests.quit);
}

TEST_F(Work, QuittingWithoutSavingOrAfterSaving) {
  run("set charts 9");
  run("quit");
  ui_.click("answer discard");
  EXPECT_TRUE(state().requests.quit);
  state().requests.quit = false;
  run("quit");
  ui_.click("answer save");
  ui_.frames(3);
  EXPECT_TRUE(ui_.has("browser-name")) << "it has no name yet";
  EXPECT_FALSE(state().requests.quit);
  run("save-session file=" + path("q.chartflood"));
  EXPECT_TRUE(state().requests.quit) << "goes on after it was saved";
}

TEST_F(Work, ACancelledSaveForgetsTheQuestion) {
  run("set charts 9");
  run("quit");
  run("answer save");
  run("close-browser");
  run("save-session file=" + path("q.chartflood"));
  EXPECT_FALSE(state().requests.quit);
}

TEST_F(Work, NothingIsAskedWithoutChangesOrWhenUnwanted) {
  run("quit");
  EXPECT_TRUE(state().requests.quit);
  state().requests.quit = false;
  run("set charts 9");
  run("quit");
  ui_.click("ask-unsaved");
  EXPECT_FALSE(state().preferences.askUnsaved);
  ui_.click("answer cancel");
  run("quit");
  EXPECT_TRUE(state().requests.quit);
}

TEST_F(Work, OpeningAnotherModelAsksToo) {
  run("set charts 9");
  run("sample sphere triangles=500");
  EXPECT_EQ(state().modelName(), "bumps");
  run("answer discard");
  EXPECT_EQ(state().modelName(), "sphere");
  EXPECT_FALSE(state().unsaved());
}

TEST_F(Work, ACopyFollowsTheChangesAndGoesWithThem) {
  state().keeper.recovery.begin(states());
  ui_.frames(60);
  EXPECT_EQ(copies().size(), 1u) << "nothing to lose: only the lock";
  run("set charts 9");
  EXPECT_LT(state().keeper.dueIn(), 1);
  EXPECT_LE(ui_.frame().wakeIn(), 1) << "a resting window wakes for it";
  const auto copy = state().keeper.recovery.file();
  for (int i = 0; i < 2000 && !std::filesystem::exists(copy); ++i) {
    ui_.frames(1);
    usleep(1000);
  }
  EXPECT_EQ(readSession(copy).parameters.charts, 9);
  EXPECT_GT(state().keeper.dueIn(), 1e6) << "then it rests";
  run("undo");
  EXPECT_FALSE(std::filesystem::exists(copy));
}

TEST_F(Work, ARunAfterTheChangeIsInTheCopyToo) {
  state().keeper.recovery.begin(states());
  run("set charts 9");
  run("run");
  const auto copy = state().keeper.recovery.file();
  const auto isThere = [&] {
    return std::filesystem::exists(copy) && readSession(copy).charts.finished;
  };
  for (int i = 0; i < 2000 && !isThere(); ++i) {
    ui_.frames(1);
    usleep(1000);
  }
  EXPECT_TRUE(isThere());
}

TEST_F(Work, ACleanEndLeavesNothing) {
  {
    Recovery recovery;
    recovery.begin(states());
    recovery.write("text");
    recovery.drop();
    recovery.write("text");
    recovery.end();
    EXPECT_FALSE(recovery.on());
  }
  EXPECT_TRUE(copies().empty());
}

TEST_F(Work, AnEndByAnExceptionLeavesTheCopy) {
  try {
    Recovery recovery;
    recovery.begin(states());
    recovery.write("text");
    throw std::bad_alloc();
  } catch (const std::bad_alloc&) {
  }
  EXPECT_THAT(copies(), testing::Contains(testing::EndsWith(".chartflood")));
  Recovery next;
  next.begin(states());
  EXPECT_EQ(next.left().size(), 1u) << "and the next start offers it";
}

TEST_F(Work, WhateverAnActionThrowsTheWorkStays) {
  ActionRegistry actions = makeActionRegistry();
  actions.add({.id = "run-out-of-memory",
               .title = "",
               .help = "",
               .arguments = {},
               .refusal = {},
               .run = [](AppState&, const Arguments&) { throw std::bad_alloc(); }});
  actions.add({.id = "break",
               .title = "",
               .help = "",
               .arguments = {},
               .refusal = {},
               .run = [](AppState&, const Arguments&) { throw std::out_of_range("vector"); }});
  run("set charts 9");
  EXPECT_FALSE(state().perform(actions, "run-out-of-memory"));
  EXPECT_THAT(lastToast(), HasSubstr("not enough memory"));
  EXPECT_FALSE(state().perform(actions, "break"));
  EXPECT_THAT(lastToast(), HasSubstr("inside the program (vector)"));
  EXPECT_TRUE(state().unsaved());
  EXPECT_EQ(state().document().parameters.charts, 9);
}

TEST_F(Work, WhatIsLeftIsOfferedAndRestored) {
  const auto copy = leaveCopy("running-1.chartflood");
  state().keeper.recovery.begin(states());
  ui_.frames(2);
  ASSERT_TRUE(ui_.has("recovery-card"));
  EXPECT_EQ(state().modelName(), "sphere") << "never forced";
  ui_.click("restore-session");
  ui_.frames(4);
  EXPECT_EQ(state().modelName(), "bumps");
  EXPECT_EQ(state().document().parameters.charts, 11);
  EXPECT_TRUE(state().unsaved());
  EXPECT_TRUE(state().keeper.file().empty());
  EXPECT_FALSE(ui_.has("recovery-card"));
  EXPECT_FALSE(std::filesystem::exists(copy));
  EXPECT_TRUE(std::filesystem::exists(state().keeper.recovery.file())) << "a copy at any moment";
  run("save-session file=" + path("r.chartflood"));
  EXPECT_FALSE(std::filesystem::exists(state().keeper.recovery.file()));
}

TEST_F(Work, WhatIsLeftCanBeForgotten) {
  const auto copy = leaveCopy("running-1.chartflood");
  state().keeper.recovery.begin(states());
  ui_.frames(2);
  ui_.click("forget-session");
  ui_.frames(2);
  EXPECT_FALSE(ui_.has("recovery-card"));
  EXPECT_FALSE(std::filesystem::exists(copy));
  EXPECT_EQ(state().modelName(), "sphere");
}

TEST_F(Work, ABrokenCopyIsToldAndCanBeForgotten) {
  std::filesystem::create_directories(states());
  writeAll(states() / "running-1.chartflood", "{");
  state().keeper.recovery.begin(states());
  ui_.frames(2);
  ui_.click("restore-session");
  ui_.frames(2);
  EXPECT_THAT(lastToast(), HasSubstr("Could not read"));
  EXPECT_EQ(state().modelName(), "bumps");
  ui_.click("forget-session");
  EXPECT_TRUE(state().keeper.recovery.left().empty());
}

TEST_F(Work, CopiesOfRunningProgramsAreLeftAlone) {
  Recovery first, second;
  first.begin(states());
  first.write("one");
  second.begin(states());
  EXPECT_NE(first.file(), second.file()) << "one for each";
  EXPECT_TRUE(second.left().empty());
  writeAll(states() / "running-77.chartflood", "{}");
  const int lock = ::open((states() / "running-77.lock").c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
  Recovery third;
  third.begin(states());
  EXPECT_TRUE(third.left().empty());
  ::close(lock);
  Recovery fourth;
  fourth.begin(states());
  ASSERT_EQ(fourth.left().size(), 1u);
  EXPECT_EQ(fourth.left()[0].filename(), "running-77.chartflood");
}

TEST(SessionView, UnknownAndUnusableValuesAreNamed) {
  ViewSettings view;
  const ViewSettings before = view;
  const SessionView values = {{"seams", 3.0},
                              {"color-by", std::string("rainbow")},
                              {"camera", std::vector<double>(9, 0.0)},
                              {"range", std::vector<double>{2, 1}},
                              {"background", std::vector<double>(7, 2.0)},
                              {"hologram", true}};
  const std::vector<std::string> left = applyViewValues(values, view);
  EXPECT_EQ(left.size(), values.size());
  EXPECT_EQ(view.render, before.render);
  EXPECT_EQ(view.camera, before.camera);
  EXPECT_TRUE(view.frameWhenLoaded);
}

TEST(SessionView, ComesBackToTheLastDigit) {
  ViewSettings view;
  view.frameWhenLoaded = false;
  view.camera.orbit(0.7, 0.3);
  view.camera.target = {0.1, 1.0 / 3, -0.7};
  view.camera.orthographic = true;
  view.render.range = {0.1, 0.7};
  view.render.background.transparent = true;
  view.render.sharpEdges = true;
  view.render.cuts = false;
  view.render.checkerKind = CheckerKind::Circles;
  view.render.checkerSquares = 17;
  view.render.checkerTint = 0.25f;
  view.render.checkerInTexture = true;
  view.uv.frame = false;
  view.uvCamera = {{0.25, 1.0 / 3}, 0.5};
  view.sphereLinked = false;
  view.sphereCamera.orbit(0.3, -0.2);
  ViewSettings again;
  EXPECT_TRUE(applyViewValues(viewValues(view), again).empty());
  EXPECT_EQ(again.render, view.render);
  EXPECT_EQ(viewValues(again), viewValues(view));
  EXPECT_EQ(again.camera.orientation, view.camera.orientation);
  EXPECT_EQ(again.camera.target, view.camera.target);
  EXPECT_EQ(again.uv, view.uv);
  EXPECT_EQ(again.uvCamera, view.uvCamera);
  EXPECT_FALSE(again.sphereLinked);
  EXPECT_EQ(again.sphereCamera.orientation, view.sphereCamera.orientation);
}

}  // namespace
}  // namespace chartflood
