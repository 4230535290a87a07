// Presets, the live switch and the rows of the parameter table by section.

#include <string>
#include <string_view>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/state/staleness.h"

namespace chartflood {

namespace {

void liveRow(const Ui& ui) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Live");
  ImGui::SameLine(ui.px(78));
  const float gap = ui.px(2);
  const float side = ImGui::GetFrameHeight() + ui.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - side - 2 * gap) / 3;
  bool first = true;
  for (const std::string& each : ui.actions.find("live")->arguments.front().choices) {
    if (!first) ImGui::SameLine(0, gap);
    first = false;
    const std::string line = "live " + each;
    const bool chosen = ui.actions.checked(line, ui.state);
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
    textButton(ui, each.c_str(), line, {width, 0});
    if (chosen) ImGui::PopStyleColor();
  }
  ImGui::PushFont(ui.theme.small);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::SetCursorPosX(ui.px(78));
  ImGui::TextUnformatted(ui.state.floodsWhileDragged() ? "Floods while a slider is dragged"
                                                       : "Floods when a slider is let go");
  ui.probe.item("live/applies");
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

/// What a section's dot means, "" for none.
std::string staleWords(const Ui& ui, std::string_view group) {
  const std::string_view line = bringsUpToDate(ui.state, group);
  if (line.empty()) return "";
  return "Out of date: press " + ui.actions.shortcut(line) + " (" + ui.actions.find(line)->title +
         ").";
}

}  // namespace

void parameterPanel(const Ui& ui) {
  presetRow(ui);
  liveRow(ui);
  const ParameterInfo* shown = findParameter(ui.state.panels.shownParameter);
  std::string_view group;
  bool open = true;
  for (const ParameterInfo& info : parameterTable()) {
    if (group != info.group) {
      group = info.group;
      open = section(ui, info.group, group == "Charts" || group == "Balance",
                     shown != nullptr && group == shown->group, staleWords(ui, group));
    }
    if (open) parameterRow(ui, info);
  }
}

}  // namespace chartflood
