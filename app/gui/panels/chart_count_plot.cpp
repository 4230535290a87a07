#include "app/gui/panels/chart_count_plot.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/panels/plot_widgets.h"
#include "app/gui/widgets/widgets.h"
#include "core/session/pipeline/run_set.h"

namespace chartflood {

namespace {

/// Places of the runs: equal ratios of charts take equal widths.
std::vector<float> placesOf(const PlotArea& area, const std::vector<Run>& runs, float margin) {
  const auto place = [](const Run& run) { return std::log(static_cast<float>(run.charts)); };
  const float first = place(runs.front()), span = place(runs.back()) - first;
  std::vector<float> x;
  for (const Run& run : runs) {
    const float share = span > 0 ? (place(run) - first) / span : 0.5f;
    x.push_back(area.low.x + margin + share * (area.width() - 2 * margin));
  }
  return x;
}

std::size_t nearest(const std::vector<float>& x, float mouse) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (std::abs(x[i] - mouse) < std::abs(x[best] - mouse)) best = i;
  }
  return best;
}

std::string readout(const RunSet& set, std::size_t run) {
  const Run& r = set.runs[run];
  const std::string stretch =
      r.stretch ? "stretch " + formatted("%.3f", *r.stretch) + ", " : std::string();
  return std::to_string(r.charts) + (r.charts == 1 ? " chart: " : " charts: ") + stretch +
         "seams " + formatted("%.2f \u221aarea", r.seams) +
         (r.stretch ? "" : " before relief cuts: too long") +
         (run == set.chosen ? ", the shortest within the limit" : "");
}

/// A line through the runs that have a value.
void curve(const Ui& ui, const std::vector<std::optional<ImVec2>>& points, ImU32 color,
           std::size_t marked) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> line;
  for (const auto& point : points) {
    if (point) line.push_back(*point);
  }
  list.AddPolyline(line.data(), static_cast<int>(line.size()), color, 0, ui.px(2));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i]) list.AddCircleFilled(*points[i], ui.px(i == marked ? 4.5f : 2.5f), color);
  }
}

}  // namespace

void chartCountPlot(const Ui& ui, float height) {
  const auto set = ui.state.results().chartRuns;
  if (!set || set->runs.empty()) return;
  const std::vector<Run>& runs = set->runs;
  double mostStretch = 1.02, mostSeams = 1e-9;
  for (const Run& run : runs) {
    mostStretch = std::max(mostStretch, run.stretch.value_or(1));
    mostSeams = std::max(mostSeams, run.seams);
  }
  std::size_t& under = ui.memory.runUnderMouse;
  const std::size_t shown = under < runs.size() ? under : set->chosen;
  const PlotWords words{"Stretch and seams over the number of charts", "plot/counts",
                        "L2 stretch of the whole model, 1 is none, and dashed what is allowed in "
                        "each chart; length of all seams, relief cuts counted, on a scale of its "
                        "own. Click a number to use it.",
                        readout(*set, shown)};
  const ValueAxis axis{1, 1 + niceTop(mostStretch - 1), "%.3g"};
  const ValueAxis seamAxis{0, niceTop(mostSeams), "%.3g"};
  const PlotArea area = beginPlot(ui, words, axis, height);
  const std::vector<float> x = placesOf(area, runs, ui.px(8));
  const std::size_t now = area.hovered ? nearest(x, ImGui::GetIO().MousePos.x) : UiMemory::kNowhere;
  if (now != under) ui.wakeIn(0);  // the readout stands above
  under = now;
  std::vector<std::optional<ImVec2>> stretch, seams;
  std::vector<PlotTick> ticks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    stretch.emplace_back();
    if (runs[i].stretch) stretch.back() = ImVec2{x[i], axis.y(area, *runs[i].stretch)};
    seams.push_back(ImVec2{x[i], seamAxis.y(area, runs[i].seams)});
    ticks.push_back({x[i], std::to_string(runs[i].charts)});
  }
  const double limit = ui.state.document().parameters.maxStretch;
  if (limit < axis.high) levelLine(ui, area, axis.y(area, limit));
  curve(ui, seams, legibleOn(ui.theme.palette.bar, ui.theme.palette.warning), set->chosen);
  curve(ui, stretch, ui.theme.palette.accent, set->chosen);
  if (under < runs.size()) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const auto& points : {seams, stretch}) {
      if (!points[under]) continue;
      list.AddCircle(*points[under], ui.px(6), ui.theme.palette.text, 0, ui.px(1.5f));
    }
    if (ImGui::IsMouseClicked(0)) ui.run("use-count " + std::to_string(runs[under].charts));
  }
  bottomTicks(ui, area, ticks, ui.px(3));
}

}  // namespace chartflood
