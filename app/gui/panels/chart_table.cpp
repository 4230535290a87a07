// Figures of each chart, sortable by column; a click selects the chart.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

enum Column { kChart, kFaces, kGauss, kShare, kPerimeter, kStretch, kDisk, kColumns };

/// What the table shows; the charts after cutting where they are laid flat.
struct Figures {
  const ChartStats& stats;
  const ChartSet* charts = nullptr;
  const Unwrap* unwrap = nullptr;

  bool whole = false;    ///< figures of borders are known: the finished charts are shown
  int borderDigits = 2;  ///< behind the point, so that the longest border has three in all

  explicit Figures(const AppState& state) : stats(*state.shownStats()), whole(state.showsFinal()) {
    double longest = 0;
    for (const ChartFigures& chart : stats.charts) longest = std::max(longest, chart.perimeter);
    if (longest > 0) {
      borderDigits = static_cast<int>(std::clamp(2 - std::floor(std::log10(longest)), 0.0, 9.0));
    }
    const Results& results = state.results();
    if (!results.flat || !whole) return;
    charts = results.charts.get();
    unwrap = results.unwrap.get();
  }
  bool disk(std::size_t chart) const {
    return charts != nullptr ? charts->charts[chart].disk() : stats.charts[chart].disk;
  }
  /// L2 stretch; 0 for a chart that is not laid flat.
  double stretch(std::size_t chart) const {
    if (unwrap == nullptr || unwrap->charts[chart].uv.empty()) return 0;
    return unwrap->charts[chart].distortion.l2;
  }
};

double cell(const Figures& all, std::size_t chart, int column) {
  const ChartFigures& figures = all.stats.charts[chart];
  switch (column) {
  case kFaces:
    return static_cast<double>(figures.faces);
  case kGauss:
  case kShare:
    return figures.gaussArea;
  case kPerimeter:
    return figures.perimeter;
  case kStretch:
    return all.stretch(chart);
  case kDisk:
    return all.disk(chart) ? 1 : 0;
  default:
    return static_cast<double>(chart);
  }
}

std::vector<std::size_t> sortedCharts(const Figures& figures) {
  std::vector<std::size_t> order(figures.stats.charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (specs == nullptr || specs->SpecsCount == 0) return order;
  const int column = specs->Specs[0].ColumnIndex;
  const bool down = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double x = cell(figures, a, column), y = cell(figures, b, column);
    return down ? y < x : x < y;
  });
  return order;
}

/// Words at the right edge of their cell.
void rightText(const char* text) {
  const float width = ImGui::CalcTextSize(text).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                       std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
  ImGui::TextUnformatted(text);
}

void rightText(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  rightText(text);
}

void tableRow(const Ui& ui, const Figures& all, std::size_t chart) {
  const ChartStats& stats = all.stats;
  const ChartFigures& figures = stats.charts[chart];
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const bool selected = ui.state.selectedChart == chart;
  const bool closed = ui.state.closedOff(static_cast<Index>(chart));
  const std::string name = std::to_string(chart) + (closed ? " closed" : "");
  if (ImGui::Selectable((name + "###" + std::to_string(chart)).c_str(), selected,
                        ImGuiSelectableFlags_SpanAllColumns)) {
    ui.run("select-chart " + std::to_string(chart));
  }
  ui.probe.item("chart/" + std::to_string(chart));
  linkChartRow(ui, static_cast<Index>(chart));
  ImGui::TableNextColumn();
  rightText("%.0f", static_cast<double>(figures.faces));
  ImGui::TableNextColumn();
  rightText("%.3f", figures.gaussArea);
  ImGui::TableNextColumn();
  rightText("%.0f %%", stats.balanceDefined ? 100 * figures.gaussArea / stats.gaussMean : 0);
  ImGui::TableNextColumn();
  if (all.whole) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", all.borderDigits, figures.perimeter);
    rightText(text);
  }
  ImGui::TableNextColumn();
  if (const double stretch = all.stretch(chart); stretch > 0) rightText("%.3f", stretch);
  ImGui::TableNextColumn();
  if (all.whole) ImGui::TextUnformatted(all.disk(chart) ? "yes" : "no");
}

void headers(const Ui& ui) {
  const ImGuiTableColumnFlags fixed = ImGuiTableColumnFlags_WidthStretch;
  ImGui::TableSetupColumn("#", fixed | ImGuiTableColumnFlags_DefaultSort, 0.7f);
  ImGui::TableSetupColumn("Faces", fixed | ImGuiTableColumnFlags_PreferSortDescending, 1.15f);
  ImGui::TableSetupColumn("Gauss sr", fixed | ImGuiTableColumnFlags_PreferSortDescending, 1.45f);
  ImGui::TableSetupColumn("Share", fixed | ImGuiTableColumnFlags_PreferSortDescending, 1.1f);
  ImGui::TableSetupColumn("Border", fixed | ImGuiTableColumnFlags_PreferSortDescending, 1.3f);
  ImGui::TableSetupColumn("Stretch", fixed | ImGuiTableColumnFlags_PreferSortDescending, 1.3f);
  ImGui::TableSetupColumn("Disk", fixed, 0.85f);
  ImGui::TableSetupScrollFreeze(0, 1);
  static const char* const kHelp[kColumns] = {
      "Number of the chart.",
      "Faces of the model in the chart.",
      "Gauss area in steradians: how much the chart's surface turns.",
      "Gauss area against the mean of all charts: 100 % is balanced.",
      "Length of the chart's border in units of the model.",
      "How much the chart stretches when it lies flat (L2): 1 is none at all.",
      "Whether the chart, with its cuts, hangs together, has one border and can lie flat."};
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int column = 0; column < kColumns; ++column) {
    ImGui::TableSetColumnIndex(column);
    const char* name = ImGui::TableGetColumnName(column);
    // The library's own words keep room for the arrow in every column and are cut short by it.
    const ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::TableHeader((std::string("##") + name).c_str());
    ImFont& font = *ui.theme.small;
    const float middle = (ImGui::GetItemRectSize().y - font.FontSize) / 2;
    ImGui::GetWindowDrawList()->AddText(&font, font.FontSize,
                                        {place.x, ImGui::GetItemRectMin().y + middle},
                                        ImGui::GetColorU32(ImGuiCol_Text), name);
    ui.probe.item(std::string("column/") + name);
    tooltip(ui, std::string("column/") + name, "", kHelp[column]);
  }
}

}  // namespace

void chartTable(const Ui& ui) {
  const auto& stats = ui.state.shownStats();
  if (!stats || stats->charts.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
    ImGui::TextWrapped("The charts appear here after the first flood. Press Space to play it.");
    ImGui::PopStyleColor();
    return;
  }
  problemList(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(ui.px(4), ui.px(2)));
  const ImGuiTableFlags flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_RowBg |
                                ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
  if (ImGui::BeginTable("charts", kColumns, flags)) {
    headers(ui);
    const Figures figures(ui.state);
    const std::vector<std::size_t> order = sortedCharts(figures);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(order.size()));
    while (clipper.Step()) {
      for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
        tableRow(ui, figures, order[static_cast<std::size_t>(row)]);
      }
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

}  // namespace chartflood
