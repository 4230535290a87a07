// The tabs that show why: bars, table, sphere and model point at the same chart.

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gui/panels/plot_widgets.h"
#include "app/host/insight/chart_csv.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// A frame with charts and a tab in front.
class WithTab : public HeadlessFrame {
 public:
  explicit WithTab(const char* tab, ImVec2 size = {1280, 800}, float scale = 1)
      : HeadlessFrame(size, scale) {
    openFlooded("torus", 1000);
    state().perform(actions(), std::string("right-tab ") + tab);
    frames(3);
  }
  std::size_t charts() { return state().results().chartStats->charts.size(); }
  /// Moves the mouse over the bar at a place of a plot, from the left.
  void overBar(std::string_view plot, std::size_t place) {
    const ProbedItem bars = item(std::string("bars/") + std::string(plot));
    const float step = (bars.max.x - bars.min.x) / static_cast<float>(charts());
    moveTo({bars.min.x + (static_cast<float>(place) + 0.5f) * step, bars.center().y});
    frames(2);
  }
};

TEST(Plots, AHoveredBarIsTheHoveredChart) {
  WithTab ui("plots");
  EXPECT_EQ(ui.state().hoveredChart(), kNone);
  ui.overBar("plot/charts", 5);
  EXPECT_EQ(ui.state().hoveredChart(), 5u);
  ui.overBar("plot/charts", 0);
  EXPECT_EQ(ui.state().hoveredChart(), 0u);
  ui.moveTo({5, 5});
  ui.frames(2);
  EXPECT_EQ(ui.state().hoveredChart(), kNone);
}

TEST(Plots, TheModelComesBeforeThePanels) {
  WithTab ui("plots");
  ui.state().hoveredFace = 17;
  EXPECT_EQ(ui.state().hoveredChart(), ui.state().results().segmentation->label[17]);
  ui.state().pointedChart = 3;
  EXPECT_EQ(ui.state().hoveredChart(), ui.state().results().segmentation->label[17]);
  ui.state().hoveredFace = kNone;
  EXPECT_EQ(ui.state().hoveredChart(), 3u);
}

TEST(Plots, AClickOnABarSelectsItsChart) {
  WithTab ui("plots");
  ui.overBar("plot/charts", 7);
  ui.press();
  ui.release();
  ui.frames(1);
  EXPECT_EQ(ui.lastLine(), "select-chart 7");
  EXPECT_EQ(ui.state().selectedChart, 7u);
}

TEST(Plots, LargestFirstIsAnActionAndReordersTheBars) {
  WithTab ui("plots");
  ui.click("bars-by-value");
  EXPECT_EQ(ui.lastLine(), "bars-by-value");
  const auto& charts = ui.state().results().chartStats->charts;
  std::size_t largest = 0;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    if (charts[c].gaussArea > charts[largest].gaussArea) largest = c;
  }
  ui.overBar("plot/charts", 0);
  EXPECT_EQ(ui.state().hoveredChart(), largest);
}

TEST(Plots, OrderByValuePutsMissingOnesLast) {
  EXPECT_THAT(barOrder({2, kMissing, 5, 2}, true), ElementsAre(2, 0, 3, 1));
  EXPECT_THAT(barOrder({2, kMissing, 5, 2}, false), ElementsAre(0, 1, 2, 3));
}

TEST(Plots, HistogramFollowsTheColourMode) {
  WithTab ui("plots", {1280, 1400});
  EXPECT_FALSE(ui.has("bars/plot/values"));
  ui.key("5");
  ui.frames(3);
  EXPECT_TRUE(ui.has("bars/plot/values"));
  EXPECT_FALSE(ui.has("bars/plot/values1"));
  ui.key("3");
  ui.frames(3);
  EXPECT_TRUE(ui.has("bars/plot/values2"));
}

TEST(Plots, AClickUsesATriedNumberOfPieces) {
  WithTab ui("plots", {1280, 1400});
  EXPECT_FALSE(ui.has("plot/counts")) << "nothing was tried";
  ui.state().perform(ui.actions(), "set relief-stretch 0");  // few pieces would do with cuts
  ui.state().perform(ui.actions(), "find-charts");
  ui.frames(4);
  const auto set = ui.state().results().chartRuns;
  ASSERT_TRUE(set);
  ASSERT_GE(set->runs.size(), 2u);
  const ProbedItem plot = ui.item("bars/plot/counts");
  // Equal ratios of pieces take equal widths.
  const float margin = 8, width = plot.max.x - plot.min.x - 2 * margin;
  const auto place = [&](std::size_t run) {
    const double first = std::log(set->runs.front().charts);
    const double span = std::log(set->runs.back().charts) - first;
    const double share = (std::log(set->runs[run].charts) - first) / span;
    return ImVec2{plot.min.x + margin + static_cast<float>(share) * width, plot.center().y};
  };
  for (const std::size_t run : {std::size_t{0}, set->runs.size() - 1}) {
    const std::string number = std::to_string(set->runs[run].charts);
    ui.moveTo(place(run));
    ui.frames(2);
    ui.press();
    ui.release();
    ui.frames(4);
    EXPECT_EQ(ui.lastLine(), "use-count " + number);
    EXPECT_EQ(ui.state().document().parameters.charts, static_cast<int>(set->runs[run].charts));
    EXPECT_EQ(ui.state().results().segmentation->chartCount, set->runs[run].charts);
  }
  ui.state().perform(ui.actions(), "undo");
  ui.frames(4);
  EXPECT_EQ(ui.state().document().parameters.charts, static_cast<int>(set->runs[0].charts));
}

TEST(Plots, ADoubleClickUsesARound) {
  WithTab ui("plots", {1280, 1400});
  ui.state().perform(ui.actions(), "iteration");
  ui.frames(6);
  ASSERT_GE(ui.state().results().history.size(), 2u);
  const ProbedItem plot = ui.item("bars/plot/spread");
  ui.moveTo({plot.min.x + 1, plot.center().y});
  ui.frames(1);
  for (int i = 0; i < 2; ++i) {
    ui.press();
    ui.release();
  }
  EXPECT_EQ(ui.lastLine(), "adopt 1");
}

TEST(ChartTable, HoverPointsAtTheChart) {
  WithTab ui("charts");
  ui.moveTo(ui.item("chart/4").center());
  ui.frames(2);
  EXPECT_EQ(ui.state().hoveredChart(), 4u);
}

TEST(ChartTable, RightClickCopiesTheFigures) {
  WithTab ui("charts");
  ui.moveTo(ui.item("chart/6").center());
  ui.press(1);
  ui.release(1);
  ui.frames(2);
  ui.click("menu/copy-figures 6");
  ASSERT_TRUE(ui.state().requests.clipboard.has_value());
  EXPECT_EQ(*ui.state().requests.clipboard, chartFigures(ui.state().results(), 6));
}

TEST(ChartTable, CopyAsCsv) {
  WithTab ui("charts");
  ui.click("copy-charts");
  EXPECT_EQ(*ui.state().requests.clipboard, chartsCsv(ui.state().results()));
  EXPECT_THAT(*ui.state().requests.clipboard, StartsWith("chart,faces,"));
}

TEST(Sphere, ShowsTheHoveredChartElseTheSelected) {
  WithTab ui("sphere");
  EXPECT_FALSE(ui.has("figure/Gauss area"));
  ui.key("]");
  ui.frames(2);
  EXPECT_TRUE(ui.has("figure/Gauss area"));
  EXPECT_TRUE(ui.has("figure/Against the mean"));
}

TEST(Sphere, ADragTurnsTheModelOrTheSphereAlone) {
  WithTab ui("sphere");
  const glm::dquat before = ui.state().view.camera.orientation;
  ui.drag("sphere", 0.4f, 0.6f);
  const glm::dquat linked = ui.state().view.camera.orientation;
  EXPECT_NE(linked, before);
  ui.click("sphere-linked");
  EXPECT_FALSE(ui.state().view.sphereLinked);
  EXPECT_EQ(ui.state().view.sphereCamera.orientation, linked);
  ui.drag("sphere", 0.4f, 0.6f);
  EXPECT_EQ(ui.state().view.camera.orientation, linked);
  EXPECT_NE(ui.state().view.sphereCamera.orientation, linked);
}

TEST(Tabs, KeyGoesRoundThemAndClicksSwitch) {
  WithTab ui("charts");
  ui.key("Shift+U");
  ui.frames(2);
  EXPECT_TRUE(ui.has("sphere"));
  ui.key("Shift+U");
  ui.frames(2);
  EXPECT_TRUE(ui.has("plot/charts"));
  ui.click("tab/sphere");
  ui.frames(2);
  EXPECT_EQ(ui.state().panels.rightTab, PanelState::RightTab::Sphere);
  EXPECT_FALSE(ui.has("plot/charts"));
}

TEST(ProblemList, KeyUnfoldsItAndAClickShowsThePlace) {
  HeadlessFrame ui;
  ui.openFlooded("cube", 300);
  Document document = ui.state().document();
  document.parameters.start = "flood";  // charts from creases leave no sharp edge open
  ui.state().changeDocument(document, "Start", "start", false);
  ui.frames(5);
  ui.key("P");
  ui.frames(3);
  EXPECT_TRUE(ui.state().panels.problems);
  EXPECT_TRUE(ui.state().view.render.problems);
  EXPECT_TRUE(ui.item("key/show-problem open-sharp-edges").whole());
  EXPECT_EQ(ui.state().panels.rightTab, PanelState::RightTab::Charts);
  const glm::dvec3 eye = ui.state().view.camera.eye();
  ui.click("show-problem open-sharp-edges");
  ui.frames(2);
  const auto problems = ui.state().insight().problems(ui.state().results());
  const auto& places = problems->back().places;
  EXPECT_EQ(ui.state().selectedChart, places[0].chart);
  EXPECT_NE(ui.state().view.camera.eye(), eye);
  if (places.size() > 1) {
    ui.click("show-problem open-sharp-edges");
    EXPECT_EQ(ui.state().selectedChart, places[1].chart);
  }
  ui.key("P");
  ui.frames(2);
  EXPECT_FALSE(ui.has("show-problem open-sharp-edges"));
}

TEST(ProblemList, FramingASelectedChartByKey) {
  WithTab ui("charts");
  ui.key("]");
  const double before = ui.state().view.camera.distance;
  ui.key("F");
  ui.frames(2);
  EXPECT_LT(ui.state().view.camera.distance, before);
  ui.key("A");
  ui.frames(2);
  EXPECT_GT(ui.state().view.camera.distance, 0.8 * before);
}

struct Pane {
  float width, scale;
};

class NarrowPane : public ::testing::TestWithParam<Pane> {};

/// 250 is the least width of the pane.
TEST_P(NarrowPane, NothingIsCutOff) {
  const Pane pane = GetParam();
  WithTab ui("plots", {1280 * pane.scale, 900 * pane.scale}, pane.scale);
  const ProbedItem grip = ui.item("splitter/right");
  ui.moveTo(grip.center());
  ui.press();
  ui.moveTo({grip.center().x + (340 - pane.width) * pane.scale, grip.center().y});
  ui.release();
  ui.frames(3);
  for (const char* tab : {"UV", "Charts", "sphere", "Plots"}) {
    EXPECT_TRUE(ui.item(std::string("tab/") + tab).whole()) << tab;
  }
  for (const char* plot : {"plot/charts", "plot/stretch", "plot/values", "plot/spread"}) {
    const ProbedItem item = ui.item(plot);
    EXPECT_GE(item.min.x, item.clipMin.x) << plot;
    EXPECT_LE(item.max.x, item.clipMax.x + 0.5f) << plot;
  }
  const ProbedItem bars = ui.item("bars/plot/charts"), box = ui.item("plot/charts");
  EXPECT_GT(bars.max.x - bars.min.x, 0.6f * (box.max.x - box.min.x));
  ui.click("tab/sphere");
  ui.key("]");
  ui.frames(3);
  EXPECT_TRUE(ui.item("sphere").whole());
  EXPECT_TRUE(ui.item("sphere-linked").whole());
  EXPECT_TRUE(ui.item("figure/Faces, creases, corners").whole());
  ui.click("tab/Charts");
  ui.frames(3);
  EXPECT_TRUE(ui.item("copy-charts").whole());
  EXPECT_LE(ui.item("problems").max.x, ui.item("copy-charts").min.x);
}

INSTANTIATE_TEST_SUITE_P(Sizes, NarrowPane,
                         ::testing::Values(Pane{250, 1}, Pane{250, 0.75f}, Pane{250, 2.5f},
                                           Pane{340, 1}, Pane{500, 1.5f}),
                         [](const auto& pane) {
                           return std::to_string(static_cast<int>(pane.param.width)) + "at" +
                                  std::to_string(static_cast<int>(100 * pane.param.scale));
                         });

}  // namespace
}  // namespace chartflood
