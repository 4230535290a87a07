// Each widget emits its action; a drag is one undo step; single keys act only when nothing else
// owns the keyboard.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/mesh_formats.h"
#include "tests/gui/headless_frame.h"
#include "tests/support/temporary_folder.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Panels, SliderDragSetsTheParameterAndIsOneUndoStep) {
  HeadlessFrame ui;
  ui.drag("charts", 0.2f, 0.8f);
  const int charts = ui.state().document().parameters.charts;
  EXPECT_NEAR(charts, 40, 3);  // 100 to the power of 0.8
  EXPECT_EQ(ui.state().undoHistory().size(), 1u);
  EXPECT_EQ(ui.state().undoHistory().undoName(), "K 20 to " + std::to_string(charts));
  ui.key("Ctrl+Z");
  EXPECT_EQ(ui.state().document().parameters.charts, Parameters{}.charts);
  ui.key("Ctrl+Shift+Z");
  EXPECT_EQ(ui.state().document().parameters.charts, charts);
}

TEST(Panels, DragEmitsDragLinesAndOneFinalLine) {
  HeadlessFrame ui;
  ui.drag("sharp-angle", 0.25f, 0.5f);
  EXPECT_EQ(ui.lastLine(), "set sharp-angle 90");
  EXPECT_THAT(ui.state().journal().front(), HasSubstr("drag=on"));
}

TEST(Panels, TwoDragsAreTwoUndoSteps) {
  HeadlessFrame ui;
  ui.drag("charts", 0.2f, 0.8f);
  ui.drag("charts", 0.8f, 0.3f);
  EXPECT_EQ(ui.state().undoHistory().size(), 2u);
}

TEST(Panels, TypedValueMayLeaveTheSlider) {
  HeadlessFrame ui;
  ui.ctrlClick("charts");
  ui.type("150");
  ui.enter();
  EXPECT_EQ(ui.state().document().parameters.charts, 150);
}

TEST(Panels, TypedNonsenseIsRefusedWithAToast) {
  HeadlessFrame ui;
  ui.ctrlClick("charts");
  ui.type("many");
  ui.enter();
  EXPECT_EQ(ui.state().document().parameters.charts, Parameters{}.charts);
  ASSERT_EQ(ui.state().notices.toasts().size(), 1u);
  EXPECT_THAT(ui.state().notices.toasts()[0].text, HasSubstr("charts"));
}

TEST(Panels, SwitchAndResetOfARow) {
  HeadlessFrame ui;
  ui.click("section/Balance");
  ui.frames(2);
  EXPECT_FALSE(ui.has("reset offsets"));
  ui.click("offsets");
  EXPECT_EQ(ui.lastLine(), "set offsets off");
  EXPECT_FALSE(ui.state().document().parameters.offsets);
  ui.click("reset offsets");
  EXPECT_TRUE(ui.state().document().parameters.offsets);
}

TEST(Panels, PresetFromTheBox) {
  HeadlessFrame ui;
  ui.click("preset");
  ui.frames(2);
  ui.click("preset/paper");
  EXPECT_EQ(ui.lastLine(), "preset paper");
  EXPECT_DOUBLE_EQ(ui.state().document().parameters.offsetDamping, 0.9);
}

TEST(Panels, ColourModeFromTheBoxAndByKey) {
  HeadlessFrame ui;
  ui.click("color-mode");
  ui.frames(2);
  ui.click("color-mode balance");
  EXPECT_EQ(ui.state().view.render.colorMode, ColorMode::Balance);
  ui.key("3");
  EXPECT_EQ(ui.state().view.render.colorMode, ColorMode::Gauss);
  ui.key("Q");
  EXPECT_EQ(ui.state().view.render.colorMode, ColorMode::GaussVertex);
}

TEST(Panels, OverlaySwitches) {
  HeadlessFrame ui({1280, 1100});
  const bool before = ui.state().view.render.seams;
  ui.click("seams");
  EXPECT_EQ(ui.lastLine(), "seams");
  EXPECT_NE(ui.state().view.render.seams, before);
}

TEST(Panels, SpeedSliderEndsAtMax) {
  HeadlessFrame ui;
  ui.drag("speed", 0.5f, 0.99f);
  EXPECT_EQ(ui.lastLine(), "speed max");
  ui.drag("speed", 0.9f, 0.48f);
  EXPECT_NEAR(ui.state().playback.speed(), 1000, 120);
}

TEST(Panels, ScrubberSeeksInTheRecord) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  ASSERT_TRUE(ui.state().playback.complete());
  ui.drag("scrubber", 0.9f, 0.5f);
  const auto half = static_cast<double>(ui.state().playback.capacity()) / 2;
  EXPECT_NEAR(static_cast<double>(ui.state().playback.playhead()), half, 2);
  EXPECT_THAT(ui.lastLine(), StartsWith("seek "));
  EXPECT_FALSE(ui.state().showsFinal());
}

TEST(Panels, ToolBarStepsAndPlays) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  ui.click("first");
  EXPECT_EQ(ui.state().playback.playhead(), 0u);
  ui.click("step");
  EXPECT_EQ(ui.state().playback.playhead(), 1u);
  ui.click("back");
  EXPECT_EQ(ui.state().playback.playhead(), 0u);
  ui.click("play");
  EXPECT_EQ(ui.lastLine(), "play");
}

TEST(Panels, ChartTableSelectsAChart) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  ui.click("tab/Charts");
  ui.frames(2);
  ui.click("chart/3");
  EXPECT_EQ(ui.state().selectedChart, 3u);
  ui.key("]");
  EXPECT_EQ(ui.state().selectedChart, 4u);
}

TEST(Panels, PlotsTab) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  ui.click("tab/Plots");
  ui.frames(2);
  EXPECT_TRUE(ui.has("plot/spread"));
}

TEST(Panels, SectionsOfWhatIsOutOfDateCarryADot) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  const auto run = [&](const char* line) {
    ui.state().perform(ui.actions(), line);
    ui.frames(4);
  };
  const char* const kSections[] = {"Charts", "Balance", "Borders", "Cutting", "Unwrap"};
  run("unwrap");
  for (const char* section : kSections) {
    EXPECT_FALSE(ui.has(std::string("stale/") + section)) << section;
  }
  run("set margin 12");  // the packing alone
  EXPECT_FALSE(ui.has("stale/Charts"));
  run("unwrap");
  run("live off");
  run("set charts 9");  // nothing is flooded by itself now
  for (const char* section : kSections) {
    EXPECT_TRUE(ui.has(std::string("stale/") + section)) << section;
  }
  run("run");  // to the end, the texture too
  for (int i = 0; i < 500 && ui.state().status().busy; ++i) ui.frames(1);
  ASSERT_FALSE(ui.state().status().busy);
  for (const char* section : kSections) {
    EXPECT_FALSE(ui.has(std::string("stale/") + section)) << section;
  }
  run("set margin 20");
  EXPECT_TRUE(ui.has("stale/Unwrap"));
  EXPECT_FALSE(ui.has("stale/Charts"));
  EXPECT_FALSE(ui.has("stale/Borders"));
  run("unwrap");
  EXPECT_FALSE(ui.has("stale/Unwrap"));
}

TEST(Panels, TheTrackballTurnsFreelyAndComesUprightAgain) {
  HeadlessFrame ui;
  ui.openFlooded("cube", 300);
  const auto tilt = [&] {
    const Camera& camera = ui.state().view.camera;
    return std::abs(camera.right().y);  // 0 while the horizon is level
  };
  const auto turn = [&] {
    const ImVec2 low = ui.item("view").min;
    ui.frames(40);
    // Below what was told when the model was opened.
    ui.moveTo({low.x + 320, low.y + 220});
    ui.press();
    for (int i = 1; i < 8; ++i) {
      ui.moveTo(
          {low.x + 320 + 25 * static_cast<float>(i), low.y + 220 + 40 * static_cast<float>(i)});
    }
    ui.release();
    ui.frames(1);
  };
  turn();
  EXPECT_LT(tilt(), 1e-9);
  ui.state().perform(ui.actions(), "trackball on");
  turn();
  EXPECT_GT(tilt(), 0.02);
  ui.state().perform(ui.actions(), "trackball off");
  EXPECT_LT(tilt(), 1e-9);
}

TEST(Panels, ToastsCanBeClosed) {
  HeadlessFrame ui;
  ui.state().notices.add(Notice::Kind::Error, "Could not read a.obj: it is empty.");
  ui.frames(3);
  ui.click("close-toast 0");
  EXPECT_TRUE(ui.state().notices.toasts().empty());
}

TEST(Panels, KeysDoNotActWhileTyping) {
  HeadlessFrame ui;
  ui.ctrlClick("charts");
  const ColorMode before = ui.state().view.render.colorMode;
  ui.key("4");
  EXPECT_EQ(ui.state().view.render.colorMode, before);
}

TEST(Panels, AKeyClosesTheFirstCard) {
  HeadlessFrame ui;
  ui.state().panels.firstCard = true;
  ui.frames(2);
  EXPECT_TRUE(ui.has("first-steps"));
  ui.key("2");
  ui.frames(1);
  EXPECT_FALSE(ui.state().panels.firstCard);
}

TEST(Panels, DraggingTheViewTurnsTheCamera) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  const double before = ui.state().view.camera.azimuthDegrees();
  ui.drag("view", 0.3f, 0.5f);
  EXPECT_GT(std::abs(ui.state().view.camera.azimuthDegrees() - before), 10);
  EXPECT_EQ(ui.state().undoHistory().size(), 0u);
}

TEST(Panels, MenuRunsActions) {
  HeadlessFrame ui;
  ui.click("menu/View");
  ui.frames(2);
  ui.click("menu/Show");
  ui.frames(2);
  ui.click("menu/seams");
  EXPECT_EQ(ui.lastLine(), "seams");
}

TEST(Panels, ADoubleClickBringsTheDefault) {
  HeadlessFrame ui;
  ui.state().perform(ui.actions(), "set speed-power 3");
  ui.frames(2);
  const ProbedItem bar = ui.item("speed-power");
  ui.moveTo({bar.min.x + 0.8f * (bar.max.x - bar.min.x), bar.center().y});
  for (int i = 0; i < 2; ++i) {
    ui.press();
    ui.release();
  }
  EXPECT_EQ(ui.state().document().parameters.speedPower, Parameters{}.speedPower);
}

TEST(Panels, ArrowsMoveTheBarThatHasTheKeyboard) {
  HeadlessFrame ui;
  ui.state().perform(ui.actions(), "show-parameter charts");
  ui.frames(4);
  const int before = ui.state().document().parameters.charts;
  ui.arrow(ImGuiKey_RightArrow);
  EXPECT_EQ(ui.state().document().parameters.charts, before + 1) << "a step is one at least";
  ui.arrow(ImGuiKey_RightArrow);
  ui.arrow(ImGuiKey_LeftArrow);
  ui.arrow(ImGuiKey_LeftArrow);
  EXPECT_EQ(ui.state().document().parameters.charts, before) << "the keyboard stays with the bar";
}

TEST(Panels, ATooltipStandsBesideWhatItExplains) {
  HeadlessFrame ui;
  for (const char* label : {"speed-power", "run", "charts", "color-mode"}) {
    ui.moveTo({600, 400});
    ui.frames(3);
    ui.moveTo(ui.item(label).center());
    ui.frames(45);
    const ProbedItem tip = ui.item("tooltip"), item = ui.item(label);
    EXPECT_TRUE(tip.min.y >= item.max.y || tip.max.y <= item.min.y) << label;
    EXPECT_GE(tip.min.x, 0) << label;
    EXPECT_LE(tip.max.x, 1280) << label;
  }
}

TEST(Panels, BrowserOpensAndCloses) {
  HeadlessFrame ui;
  ui.key("Ctrl+O");
  ui.frames(3);
  EXPECT_TRUE(ui.has("browser-name"));
  ui.click("close-browser");
  ui.frames(1);
  EXPECT_FALSE(ui.has("browser-name"));
}

/// What can be read can be chosen.
TEST(Panels, BrowserShowsFilesOfEveryFormat) {
  const TemporaryFolder folder;
  for (const MeshFormat& format : meshFormats()) {
    folder.write(std::string("a.") + format.extension, "x");
    folder.write(std::string("B.") + format.extension + ".txt", "x");
  }
  HeadlessFrame ui;
  ui.state().preferences.recentFiles = {(folder / "a.obj").string()};
  ui.key("Ctrl+O");
  ui.frames(3);
  for (const MeshFormat& format : meshFormats()) {
    EXPECT_TRUE(ui.has(std::string("browser/a.") + format.extension)) << format.extension;
    EXPECT_FALSE(ui.has(std::string("browser/B.") + format.extension + ".txt"));
  }
}

TEST(Panels, HiddenPanelsLeaveTheModelAlone) {
  HeadlessFrame ui;
  ui.key("F10");
  ui.frames(2);
  EXPECT_FALSE(ui.has("charts"));
  ui.key("F10");
  ui.frames(2);
  EXPECT_TRUE(ui.has("charts"));
}

}  // namespace
}  // namespace chartflood
