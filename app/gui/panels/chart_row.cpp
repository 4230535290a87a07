// What a row of the chart table does beside being clicked.

#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"

namespace chartflood {

void linkChartRow(const Ui& ui, Index chart) {
  const std::string number = std::to_string(chart);
  if (ImGui::IsItemHovered()) ui.pointAt(chart);
  if (ui.state.hoveredChart() == chart) {
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, ui.theme.palette.controlHovered);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(6)));
  if (ImGui::BeginPopupContextItem(("row/" + number).c_str())) {
    ui.pointAt(chart);
    actionMenuItem(ui, "copy-figures " + number, "Copy figures of chart " + number);
    actionMenuItem(ui, "copy-charts", "Copy all as CSV");
    ImGui::Separator();
    actionMenuItem(ui, "frame-selection " + number, "Show it");
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace chartflood
