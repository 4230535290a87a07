// What can be done with one chart: the menu of the right mouse button on its row, on the model and
// in the texture.

#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"

namespace chartflood {

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
