// What can be done with one chart: the menu of the right mouse button on its row, on the model and
// in the texture.

#include <string>
#include <vector>

#include "app/gui/panels/panels.h"
#include "app/gui/panels/plot_widgets.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/actions/chart_swap.h"

namespace chartflood {

void swapEntries(const Ui& ui, Index chart) {
  const std::string number = std::to_string(chart);
  const bool known = ui.state.view.chartColors.size() > chart;
  const bool open = ImGui::BeginMenu("Swap colours with", known);
  ui.probe.item("swap-colors/" + number);
  if (!open) return;
  const std::vector<Index> partners = colorPartners(ui.state, chart);
  for (const Index other : partners) {
    const float side = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + side, low.y + side},
                                              chartColor(ui, other), ui.px(2));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side + ui.px(8));
    const std::string with = std::to_string(other);
    actionMenuItem(ui, ("swap-colors " + number + " ").append(with), "Chart " + with);
    if (ImGui::IsItemHovered()) ui.pointAt(other);
  }
  if (partners.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
    ImGui::TextUnformatted("None: neighbours would have one colour");
    ImGui::PopStyleColor();
  }
  ImGui::EndMenu();
}

void chartEntries(const Ui& ui, Index chart) {
  const std::string number = std::to_string(chart);
  ui.pointAt(chart);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::Text("Chart %u", chart);
  ImGui::PopStyleColor();
  actionMenuItem(ui, "isolate-chart " + number, "Show it alone");
  actionMenuItem(ui, "hide-chart " + number, "Hide it");
  actionMenuItem(ui, "show-all-charts");
  ImGui::Separator();
  actionMenuItem(ui, "frame-selection " + number, "Come close to it");
  actionMenuItem(ui, "chart-in-texture " + number);
  swapEntries(ui, chart);
  ImGui::Separator();
  actionMenuItem(ui, "copy-figures " + number, "Copy its figures");
  actionMenuItem(ui, "copy-charts", "Copy all as CSV");
}

void linkChartRow(const Ui& ui, Index chart) {
  const std::string number = std::to_string(chart);
  if (ImGui::IsItemHovered()) ui.pointAt(chart);
  if (ui.state.hoveredChart() == chart) {
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, ui.theme.palette.controlHovered);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(6)));
  if (ImGui::BeginPopupContextItem(("row/" + number).c_str())) {
    chartEntries(ui, chart);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace chartflood
