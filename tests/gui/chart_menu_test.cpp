// The menu of the right mouse button on the model, hiding charts, and a picture on the charts.

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/host/actions/chart_swap.h"
#include "app/host/files/session_view.h"
#include "render/scene/chart_palette.h"
#include "render/scene/image.h"
#include "tests/gui/headless_frame.h"
#include "tests/gui/pointer_source.h"
#include "tests/support/temporary_folder.h"

namespace chartflood {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ChartMenu : public ::testing::Test {
 protected:
  ChartMenu() {
    ui.setSource(&source);
    ui.openFlooded("sphere", 800);
  }
  AppState& state() { return ui.state(); }
  bool run(const std::string& line) { return state().perform(ui.actions(), line); }
  /// Presses and lets go of the right button in the middle of the view.
  Index rightClick() {
    const ImVec2 place = ui.item("view").center();
    ui.frames(40);
    ui.moveTo(place);
    ui.press(1);
    ui.release(1);
    ui.frames(3);
    const ImVec2 low = ui.item("view").min;
    return source.pick(static_cast<int>(place.x - low.x), static_cast<int>(place.y - low.y)).chart;
  }

  PointerSource source;
  HeadlessFrame ui;
};

TEST_F(ChartMenu, NamesTheChartUnderTheMouse) {
  const double distance = state().view.camera.distance;
  const Index chart = rightClick();
  const std::string number = std::to_string(chart);
  for (const char* line : {"isolate-chart ", "hide-chart ", "frame-selection ", "copy-figures "}) {
    EXPECT_TRUE(ui.has("menu/" + (line + number))) << line;
  }
  EXPECT_EQ(state().view.camera.distance, distance);  // a click is no drag
  ui.click("menu/isolate-chart " + number);
  EXPECT_EQ(state().selectedChart, chart);
  EXPECT_TRUE(state().view.isolate);
  ui.key("Alt+H");
  EXPECT_FALSE(state().view.isolate);
}

TEST_F(ChartMenu, HiddenChartsAreLeftOutUntilAllAreShown) {
  const Index chart = rightClick();
  ui.click("menu/hide-chart " + std::to_string(chart));
  EXPECT_THAT(state().view.hiddenCharts, ElementsAre(chart));
  EXPECT_THAT(sceneSettings(state(), 1).hiddenCharts, ElementsAre(chart));
  run("hide-chart 0");
  run("hide-chart 0");
  EXPECT_EQ(state().view.hiddenCharts.size(), chart == 0 ? 1u : 2u);
  EXPECT_TRUE(std::is_sorted(state().view.hiddenCharts.begin(), state().view.hiddenCharts.end()));
  run("show-all-charts");
  EXPECT_THAT(sceneSettings(state(), 1).hiddenCharts, IsEmpty());
  EXPECT_FALSE(run("show-all-charts"));
  EXPECT_FALSE(run("hide-chart 4000"));
  run("hide-chart 1");
  state().openSample("torus", 400);
  ui.frames(4);
  EXPECT_THAT(state().view.hiddenCharts, IsEmpty());
}

TEST_F(ChartMenu, GoesToTheTexture) {
  EXPECT_FALSE(run("chart-in-texture 1"));  // not laid flat yet
  run("unwrap");
  ui.frames(3);
  ASSERT_TRUE(run("chart-in-texture 1"));
  const UvCamera& camera = state().view.uvCamera;
  for (const glm::dvec2& uv : state().results().atlas->uv[1]) {
    EXPECT_LT(std::abs(uv.x - camera.center.x), camera.span / 2);
    EXPECT_LT(std::abs(uv.y - camera.center.y), camera.span / 2);
  }
  EXPECT_EQ(state().selectedChart, 1u);
  EXPECT_EQ(state().panels.rightTab, PanelState::RightTab::Uv);
}

/// With the colours that the model would have.
class SwapColours : public ChartMenu {
 protected:
  SwapColours() {
    const Results& results = state().results();
    pairs = neighbourCharts(*results.mesh, results.segmentation->label);
    state().view.chartColors =
        colorCharts(results.segmentation->chartCount, pairs, {}, chartPaletteTable()[0]);
  }
  std::vector<Index>& colors() { return state().view.chartColors; }

  std::vector<ChartPair> pairs;
};

TEST_F(SwapColours, PartnersKeepNeighboursApart) {
  const std::vector<Index> before = colors();
  for (Index chart = 0; chart < before.size(); ++chart) {
    colors() = before;
    const std::vector<Index> partners = colorPartners(state(), chart);
    for (const Index other : partners) {
      colors() = before;
      swapColors(state(), chart, other);
      EXPECT_EQ(colors()[chart], before[other]);
      EXPECT_EQ(colors()[other], before[chart]);
      for (const auto& [a, b] : pairs) EXPECT_NE(colors()[a], colors()[b]);
    }
  }
}

TEST_F(SwapColours, RefusesWhatWouldMakeNeighboursAlike) {
  const std::vector<Index> before = colors();
  const unsigned times = state().view.recolored;
  std::size_t refused = 0;
  for (Index other = 1; other < before.size(); ++other) {
    const std::vector<Index> partners = colorPartners(state(), 0);
    if (std::find(partners.begin(), partners.end(), other) != partners.end()) continue;
    EXPECT_FALSE(run("swap-colors 0 " + std::to_string(other)));
    ++refused;
  }
  EXPECT_GT(refused, 0u);
  EXPECT_FALSE(run("swap-colors 0 4000"));
  EXPECT_FALSE(run("swap-colors 0"));  // none is selected
  EXPECT_EQ(colors(), before);
  EXPECT_EQ(state().view.recolored, times);
}

TEST_F(SwapColours, StandsInTheMenuOfAChart) {
  const Index chart = rightClick();
  const std::vector<Index> before = colors(), partners = colorPartners(state(), chart);
  ASSERT_FALSE(partners.empty());
  ui.moveTo(ui.item("swap-colors/" + std::to_string(chart)).center());
  ui.frames(40);
  const std::string line =
      "swap-colors " + std::to_string(chart) + " " + std::to_string(partners[0]);
  ui.click("menu/" + line);
  EXPECT_EQ(ui.lastLine(), line);
  EXPECT_EQ(colors()[chart], before[partners[0]]);
}

class OwnPicture : public ChartMenu {
 protected:
  OwnPicture() {
    writePng(Image(8, 4, {10, 200, 30, 255}), folder / "green.png");
    std::ofstream(folder / "broken.png") << "no picture at all";
  }
  const TemporaryFolder folder;
};

TEST_F(OwnPicture, ADroppedOneLiesOnTheChartsUntilItIsTakenOff) {
  EXPECT_FALSE(run("use-checkerboard"));
  ASSERT_TRUE(run("open " + (folder / "green.png").string()));
  const RenderSettings& render = state().view.render;
  EXPECT_EQ(render.colorMode, ColorMode::Checkerboard);
  EXPECT_EQ(render.checkerKind, CheckerKind::Picture);
  ASSERT_TRUE(render.checkerPicture);
  EXPECT_EQ(render.checkerPicture->width(), 8);
  EXPECT_TRUE(state().hasMesh());  // the model stayed
  const SessionView values = viewValues(state().view);
  ViewSettings read;
  EXPECT_THAT(applyViewValues(values, read, folder.path()), IsEmpty());
  ASSERT_TRUE(read.render.checkerPicture);
  EXPECT_EQ(*read.render.checkerPicture, *render.checkerPicture);
  EXPECT_EQ(read.render.checkerKind, CheckerKind::Picture);
  run("checker-repeats 3");
  EXPECT_EQ(render.checkerRepeats, 3);
  ASSERT_TRUE(run("use-checkerboard"));
  EXPECT_EQ(render.checkerKind, CheckerKind::Squares);
  EXPECT_FALSE(run("checker-kind picture"));
}

TEST_F(OwnPicture, ABrokenOneIsToldAndChangesNothing) {
  const RenderSettings before = state().view.render;
  EXPECT_FALSE(run("open " + (folder / "broken.png").string()));
  EXPECT_THAT(state().notices.toasts().back().text, HasSubstr("broken.png"));
  EXPECT_FALSE(run("checker-picture " + (folder / "none.jpg").string()));
  EXPECT_EQ(state().view.render, before);
  // A session whose picture is gone says so and shows squares.
  run("open " + (folder / "green.png").string());
  SessionView values = viewValues(state().view);
  values["checker-picture"] = (folder / "gone.png").string();
  ViewSettings read;
  EXPECT_EQ(applyViewValues(values, read, folder.path()).size(), 1u);
  EXPECT_FALSE(read.render.checkerPicture);
}

TEST_F(OwnPicture, ASessionOpensNoneOutsideOfItsFolder) {
  run("open " + (folder / "green.png").string());
  SessionView values = viewValues(state().view);
  std::filesystem::create_directories(folder / "sessions/pictures");
  std::filesystem::copy_file(folder / "green.png", folder / "sessions/pictures/a.png");
  const auto left = [&](const std::string& name) {
    values["checker-picture"] = name;
    ViewSettings read;
    const std::vector<std::string> words = applyViewValues(values, read, folder / "sessions");
    EXPECT_EQ(read.render.checkerPicture == nullptr, !words.empty()) << name;
    EXPECT_EQ(read.render.checkerKind == CheckerKind::Picture, words.empty()) << name;
    return words.empty() ? "" : words[0];
  };
  EXPECT_EQ(left("pictures/a.png"), "");
  EXPECT_EQ(left((folder / "sessions/pictures/a.png").string()), "");
  EXPECT_EQ(
      left("../green.png"),
      "The picture ../green.png on the session's checkerboard was not opened: it lies outside "
      "of the file's folder; put it beside the file or below; squares are shown in its place.");
  EXPECT_THAT(left((folder / "green.png").string()), HasSubstr("lies outside"));
  std::filesystem::create_symlink("../green.png", folder / "sessions/link.png");
  EXPECT_THAT(left("link.png"), HasSubstr("lies outside"));
  ASSERT_EQ(::mkfifo((folder / "sessions/pipe.png").c_str(), 0600), 0);
  EXPECT_THAT(left("pipe.png"), HasSubstr("is a pipe"));
  std::filesystem::copy_file(std::filesystem::path(CHARTFLOOD_CASES) / "bomb-size.png",
                             folder / "sessions/bomb.png");
  EXPECT_EQ(left("bomb.png"),
            "The session's value of 'view/checker-picture' cannot be used and was left out.");
}

TEST_F(OwnPicture, HugeOnesAreOneSentenceAndChangeNothing) {
  const RenderSettings before = state().view.render;
  for (const char* name : {"bomb-huge.png", "bomb-size.png"}) {
    const std::string file = (std::filesystem::path(CHARTFLOOD_CASES) / name).string();
    for (const std::string& line : {"open " + file, "checker-picture " + file}) {
      EXPECT_FALSE(run(line)) << line;
      EXPECT_THAT(state().notices.toasts().back().text, HasSubstr("16384 x 16384 are the most"));
      EXPECT_EQ(state().view.render, before);
      EXPECT_TRUE(state().hasMesh());
    }
  }
}

}  // namespace
}  // namespace chartflood
