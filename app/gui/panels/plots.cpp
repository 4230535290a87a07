// Plots of what the charts carry: Gauss area and stretch of each, the values behind the colours,
// the spread over the rounds. Bars, table and model point at the same chart.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "app/gui/panels/chart_count_plot.h"
#include "app/gui/panels/histogram_plot.h"
#include "app/gui/panels/panels.h"
#include "app/gui/panels/plot_widgets.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr float kLeastPlotHeight = 92, kMostPlotHeight = 190;

/// The chart that figures are given of: pointed at, else selected, else kNone.
Index chartInFocus(const AppState& state, std::size_t charts) {
  const Index hovered = state.hoveredChart();
  const Index chart = hovered != kNone ? hovered : state.selectedChart;
  return chart < charts ? chart : kNone;
}

std::string areaReadout(const AppState& state, const ChartStats& stats) {
  const Index chart = chartInFocus(state, stats.charts.size());
  if (chart == kNone) {
    std::string text = "mean " + formatted("%.3g sr", stats.gaussMean);
    if (stats.balanceDefined) text += ", spread " + formatted("%.1f %%", 100 * stats.stdOverMean());
    return text;
  }
  const double area = stats.charts[chart].gaussArea;
  std::string text = "chart " + std::to_string(chart) + ": " + formatted("%.3g sr", area);
  if (stats.balanceDefined) {
    text += ", " + formatted("%.0f %% of the mean", 100 * area / stats.gaussMean);
  }
  return text;
}

void areaOfCharts(const Ui& ui, float height) {
  const ChartStats* stats = ui.state.shownStats().get();
  const bool any = stats != nullptr && !stats->charts.empty();
  PlotWords words{"Gauss area of each chart", "plot/charts",
                  "How much the surface of each chart turns, in steradians. Dashed: the mean. Even "
                  "bars are a good balance.",
                  any ? areaReadout(ui.state, *stats) : ""};
  ChartBars bars;
  double most = 0;
  if (any) {
    for (const ChartFigures& chart : stats->charts) {
      bars.values.push_back(chart.gaussArea);
      most = std::max(most, chart.gaussArea);
    }
    bars.level = stats->gaussMean;
    bars.hasLevel = true;
  }
  const ValueAxis axis{0, most > 0 ? niceTop(most) : 1, "%.3g sr"};
  if (!any) return emptyPlot(ui, words, "No charts yet. Press Space.");
  const PlotArea area = beginPlot(ui, words, axis, height);
  drawChartBars(ui, area, axis, bars);
}

/// L2 stretch of each chart, NaN where it is not laid flat; empty when none belongs to the charts.
std::vector<double> stretchOfCharts(const Results& results) {
  std::vector<double> values;
  if (!results.flat || !results.unwrap || !results.chartStats) return values;
  if (results.unwrap->charts.size() != results.chartStats->charts.size()) return values;
  for (const ChartUv& chart : results.unwrap->charts) {
    values.push_back(chart.uv.empty() ? std::numeric_limits<double>::quiet_NaN()
                                      : chart.distortion.l2);
  }
  return values;
}

std::string stretchReadout(const AppState& state, const std::vector<double>& values) {
  const Index chart = chartInFocus(state, values.size());
  if (chart != kNone) {
    const std::string name = "chart " + std::to_string(chart) + ": ";
    return name + (std::isnan(values[chart]) ? std::string("not laid flat")
                                             : formatted("stretch %.3f", values[chart]));
  }
  double worst = 0;
  std::size_t flat = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    worst = std::max(worst, value);
    ++flat;
  }
  if (flat == 0) return "";
  return "worst " + formatted("%.3f", worst) + ", " + std::to_string(flat) + " of " +
         std::to_string(values.size()) + " laid flat";
}

std::string unwrapHint(const Ui& ui) {
  if (ui.actions.find("unwrap") == nullptr) return "The charts are not laid flat.";
  const std::string key = ui.actions.shortcut("unwrap");
  return "Shown once the charts lie flat: Unwrap" + (key.empty() ? "." : " (" + key + ").");
}

void stretchPlot(const Ui& ui, float height) {
  ChartBars bars;
  bars.values = stretchOfCharts(ui.state.results());
  PlotWords words{"Stretch of each chart", "plot/stretch",
                  "L2 stretch of the unwrap. 1 is no stretch at all; twice the height above 1 is "
                  "twice as bad. A gap: not laid flat.",
                  stretchReadout(ui.state, bars.values)};
  double most = 1.02;
  for (const double value : bars.values) {
    if (value > most) most = value;
  }
  const ValueAxis axis{1, 1 + niceTop(most - 1), "%.3g"};
  if (bars.values.empty()) return emptyPlot(ui, words, unwrapHint(ui));
  const PlotArea area = beginPlot(ui, words, axis, height);
  drawChartBars(ui, area, axis, bars);
}

std::string roundReadout(const Results& results, std::size_t round) {
  const IterationSummary& r = results.history[round];
  std::string text = "round " + std::to_string(round + 1) + ": spread " +
                     formatted("%.1f %%", 100 * r.stdOverMean);
  if (round == results.bestIteration) text += ", the best";
  if (round == 0) return text;
  return text + ", " + std::to_string(r.movedSeeds) + (r.movedSeeds == 1 ? " seed" : " seeds") +
         " moved";
}

std::vector<PlotTick> roundTicks(const PlotArea& area, std::size_t rounds, float room) {
  std::vector<PlotTick> ticks;
  const float step = rounds < 2 ? 0 : area.width() / static_cast<float>(rounds - 1);
  std::size_t stride = 1;
  for (std::size_t i = 0; step * static_cast<float>(stride) < room && i < 30; ++i) {
    stride = i % 3 == 1 ? stride * 5 / 2 : stride * 2;
  }
  for (std::size_t i = 0; i < rounds; i += stride) {
    const float x = rounds < 2 ? area.width() / 2 : static_cast<float>(i) * step;
    ticks.push_back({area.low.x + x, std::to_string(i + 1)});
  }
  return ticks;
}

/// The round whose point is nearest to the mouse.
std::size_t roundUnderMouse(const PlotArea& area, std::size_t rounds) {
  const float share = (ImGui::GetIO().MousePos.x - area.low.x) / std::max(1.0f, area.width());
  const float place = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(rounds - 1);
  return static_cast<std::size_t>(std::lround(place));
}

void spreadOverRounds(const Ui& ui, float height) {
  const Results& results = ui.state.results();
  const std::size_t rounds = results.history.size();
  double most = 1e-9;
  for (const IterationSummary& round : results.history) most = std::max(most, round.stdOverMean);
  const ValueAxis axis{0, rounds == 0 ? 100 : 100 * niceTop(most), "%.3g %%"};
  std::size_t& under = ui.memory.roundUnderMouse;
  const std::size_t shown = under < rounds ? under : results.bestIteration;
  PlotWords words{"Spread over the rounds", "plot/spread",
                  "Standard deviation of the charts' Gauss areas over their mean. Lower is more "
                  "even. The bright point is the best round; double-click a round to use it.",
                  shown < rounds ? roundReadout(results, shown) : ""};
  if (rounds == 0) return emptyPlot(ui, words, "No round finished yet. Press L.");
  const PlotArea area = beginPlot(ui, words, axis, height);
  const std::size_t now = area.hovered ? roundUnderMouse(area, rounds) : UiMemory::kNowhere;
  if (now != under) ui.wakeIn(0);  // the readout stands above
  under = now;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < rounds; ++i) {
    const float x = rounds < 2 ? 0.5f : static_cast<float>(i) / static_cast<float>(rounds - 1);
    points.push_back(
        {area.low.x + x * area.width(), axis.y(area, 100 * results.history[i].stdOverMean)});
  }
  list.AddPolyline(points.data(), static_cast<int>(points.size()), ui.theme.palette.accent, 0,
                   ui.px(2));
  if (results.bestIteration < rounds) {
    list.AddCircleFilled(points[results.bestIteration], ui.px(4.5f), ui.theme.palette.front);
  }
  if (under < rounds) {
    list.AddCircle(points[under], ui.px(6), ui.theme.palette.text, 0, ui.px(1.5f));
    if (ImGui::IsMouseDoubleClicked(0)) ui.run("adopt " + std::to_string(under + 1));
  }
  bottomTicks(ui, area, roundTicks(area, rounds, ui.px(28)), ui.px(3));
}

/// Height of each full plot so that all fill the tab, or scroll.
float plotHeight(const Ui& ui, int full, int empty) {
  const float gap = ImGui::GetStyle().ItemSpacing.y, line = ImGui::GetTextLineHeight();
  const float words = line + ui.theme.small->FontSize + 3 * gap;
  const float boxes = static_cast<float>(empty) * (3 * line + 2 * gap + ui.px(16));
  const float room =
      (ImGui::GetContentRegionAvail().y - boxes) / static_cast<float>(std::max(1, full)) - words;
  return std::round(std::clamp(room, ui.px(kLeastPlotHeight), ui.px(kMostPlotHeight)));
}

}  // namespace

void plotsPanel(const Ui& ui) {
  switchRow(ui, "Largest first", ui.state.panels.barsByValue, "bars-by-value");
  const Playback& playback = ui.state.playback;
  const auto histograms = ui.state.insight().histograms(
      ui.state.results(), {ui.state.shownStats(), playback.record(), playback.playhead()},
      ui.state.view.render);
  const int inMode = histograms ? static_cast<int>(histograms->size()) : 0;
  ImGui::BeginChild("plots", {0, 0}, false, ImGuiWindowFlags_NoNav);
  const Results& results = ui.state.results();
  const auto& stats = ui.state.shownStats();
  const int full = (stats && !stats->charts.empty() ? 1 : 0) +
                   (stretchOfCharts(results).empty() ? 0 : 1) + inMode +
                   (results.history.empty() ? 0 : 1) + (results.chartRuns ? 1 : 0);
  const int empty = 3 + std::max(1, inMode) + (results.chartRuns ? 1 : 0) - full;
  const float height = plotHeight(ui, full, empty);
  areaOfCharts(ui, height);
  stretchPlot(ui, height);
  if (inMode == 0) {
    emptyHistogram(ui);
  } else {
    for (std::size_t i = 0; i < histograms->size(); ++i) {
      histogramPlot(ui, (*histograms)[i], i, height);
    }
  }
  spreadOverRounds(ui, height);
  chartCountPlot(ui, height);
  ImGui::EndChild();
}

}  // namespace chartflood
