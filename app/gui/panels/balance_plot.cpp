// Two plots: the spread of Gauss area over the rounds, and each chart's Gauss area against the
// mean.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"

namespace chartflood {

namespace {

struct Area {
  ImVec2 low, high;
  float width() const { return high.x - low.x; }
  float height() const { return high.y - low.y; }
};

std::string format(const char* pattern, double value) {
  char text[48];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// A caption, then an empty plot with a ground; returns where to draw.
Area beginPlot(const Ui& ui, const char* title, const char* label, float height) {
  ImGui::PushFont(ui.theme.strong);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton(label, {width, height});
  ui.probe.item(label);
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + height},
                                            ui.theme.palette.bar, ui.px(3));
  const float left = ui.px(44), other = ui.px(8);
  return {{low.x + left, low.y + other}, {low.x + width - other, low.y + height - ui.px(20)}};
}

/// Horizontal lines at 0, half and the top, with numbers.
void drawTicks(const Ui& ui, const Area& area, double top, const char* pattern) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.theme.small);
  for (int i = 0; i <= 2; ++i) {
    const float y = area.high.y - area.height() * static_cast<float>(i) / 2;
    list.AddLine({area.low.x, y}, {area.high.x, y}, ui.theme.palette.line);
    const std::string text = format(pattern, top * i / 2);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddText({area.low.x - size.x - ui.px(6), y - size.y / 2}, ui.theme.palette.dim,
                 text.c_str());
  }
  ImGui::PopFont();
}

void drawCentered(const Ui& ui, const Area& area, const char* text) {
  ImGui::PushFont(ui.theme.small);
  const ImVec2 size = ImGui::CalcTextSize(text);
  ImGui::GetWindowDrawList()->AddText(
      {std::round((area.low.x + area.high.x - size.x) / 2), area.high.y + ui.px(4)},
      ui.theme.palette.dim, text);
  ImGui::PopFont();
}

/// The smallest of 1, 2, 5 times a power of ten that is not below.
double niceTop(double value) {
  const double power = std::pow(10, std::floor(std::log10(std::max(value, 1e-12))));
  for (double factor : {1.0, 2.0, 5.0}) {
    if (value <= factor * power) return factor * power;
  }
  return 10 * power;
}

void spreadOverRounds(const Ui& ui) {
  const Results& results = ui.state.results();
  const Area area = beginPlot(ui, "Spread over the rounds", "plot/spread", ui.px(150));
  tooltip(ui, "plot/spread", "Spread over the rounds",
          "Standard deviation of the charts' Gauss areas over their mean. Lower is more even. The "
          "bright point is the best round.");
  double most = 1e-9;
  for (const IterationSummary& round : results.history) most = std::max(most, round.stdOverMean);
  const double top = results.history.empty() ? 1 : niceTop(most);
  drawTicks(ui, area, 100 * top, "%.3g %%");
  drawCentered(ui, area, results.history.empty() ? "no round finished yet" : "round");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> points;
  const std::size_t rounds = results.history.size();
  for (std::size_t i = 0; i < rounds; ++i) {
    const float x = rounds < 2 ? 0.5f : static_cast<float>(i) / static_cast<float>(rounds - 1);
    const auto y = static_cast<float>(results.history[i].stdOverMean / top);
    points.push_back({area.low.x + x * area.width(), area.high.y - y * area.height()});
  }
  list.AddPolyline(points.data(), static_cast<int>(points.size()), ui.theme.palette.accent, 0,
                   ui.px(2));
  if (results.bestIteration < points.size()) {
    list.AddCircleFilled(points[results.bestIteration], ui.px(4), ui.theme.palette.front);
  }
}

void areaOfCharts(const Ui& ui) {
  const ChartStats* stats = ui.state.results().chartStats.get();
  const Area area = beginPlot(ui, "Gauss area of each chart", "plot/charts", ui.px(150));
  const bool any = stats != nullptr && !stats->charts.empty();
  double most = 1e-9;
  if (any) {
    for (const ChartFigures& chart : stats->charts) most = std::max(most, chart.gaussArea);
  }
  const double top = any ? niceTop(most) : 1;
  drawTicks(ui, area, top, "%.3g");
  drawCentered(ui, area, any ? "chart (line: mean, steradians)" : "no charts yet");
  if (!any) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float step = area.width() / static_cast<float>(stats->charts.size());
  const float mouse = ImGui::GetIO().MousePos.x;
  for (std::size_t i = 0; i < stats->charts.size(); ++i) {
    const float x = area.low.x + static_cast<float>(i) * step;
    const float y =
        area.high.y - area.height() * static_cast<float>(stats->charts[i].gaussArea / top);
    const bool under = ImGui::IsItemHovered() && mouse >= x && mouse < x + step;
    const bool chosen = ui.state.selectedChart == i;
    const float gap = step > 4 ? 1.0f : 0.0f;
    list.AddRectFilled({x + gap, std::min(y, area.high.y - 1)}, {x + step - gap, area.high.y},
                       under || chosen ? ui.theme.palette.text : ui.theme.palette.accent);
    if (under) {
      tooltip(ui, "plot/chart" + std::to_string(i), "Chart " + std::to_string(i),
              format("%.3f sr", stats->charts[i].gaussArea));
      if (ImGui::IsMouseClicked(0)) ui.run("select-chart " + std::to_string(i));
    }
  }
  const float mean = area.high.y - area.height() * static_cast<float>(stats->gaussMean / top);
  list.AddLine({area.low.x, mean}, {area.high.x, mean}, ui.theme.palette.front, ui.px(1.5f));
}

}  // namespace

void balancePlot(const Ui& ui) {
  spreadOverRounds(ui);
  ImGui::Dummy({0, ui.px(6)});
  areaOfCharts(ui);
}

}  // namespace chartflood
