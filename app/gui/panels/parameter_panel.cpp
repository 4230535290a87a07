// Presets, the live switch and the rows of the parameter table by section.

#include <string_view>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"

namespace chartflood {

namespace {

void presetRow(const Ui& ui) {
  const Parameters& values = ui.state.document().parameters;
  const char* shown = values == Parameters{} ? "Standard" : "Own settings";
  for (const Preset& preset : presetTable()) {
    if (values != Parameters{} && applyPreset(values, preset) == values) shown = preset.label;
  }
  const float side = ImGui::GetFrameHeight();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Preset");
  ImGui::SameLine(ui.px(78));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - side - ui.px(4));
  const bool open = ImGui::BeginCombo("##preset", shown);
  ui.probe.item("preset");
  if (open) {
    if (ImGui::Selectable("Standard", values == Parameters{})) ui.run("reset-all");
    ui.probe.item("preset/standard");
    for (const Preset& preset : presetTable()) {
      if (ImGui::Selectable(preset.label)) ui.run(std::string("preset ") + preset.id);
      ui.probe.item(std::string("preset/") + preset.id);
      tooltip(ui, preset.id, preset.label, preset.help);
    }
    ImGui::EndCombo();
  } else {
    tooltip(ui, "preset", "Preset", "Parameters for a purpose. \"Paper\" has the printed values.");
  }
  if (values == Parameters{}) return;
  ImGui::SameLine(0, ui.px(4));
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  iconButton(ui, Icon::Reset, "reset-all", {side, side});
  ImGui::PopStyleColor();
}

void liveRow(const Ui& ui) {
  const LiveMode mode = ui.state.preferences.live;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Live");
  ImGui::SameLine(ui.px(78));
  const float gap = ui.px(2);
  const float side = ImGui::GetFrameHeight() + ui.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - side - 2 * gap) / 3;
  for (LiveMode each : {LiveMode::Auto, LiveMode::On, LiveMode::Off}) {
    const std::string id = liveModeId(each);
    if (each != LiveMode::Auto) ImGui::SameLine(0, gap);
    const bool chosen = mode == each;
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
    const char* words = each == LiveMode::Auto ? "auto" : each == LiveMode::On ? "on" : "off";
    textButton(ui, words, "live " + id, {width, 0});
    if (chosen) ImGui::PopStyleColor();
  }
}

}  // namespace

void parameterPanel(const Ui& ui) {
  presetRow(ui);
  liveRow(ui);
  std::string_view group;
  bool open = true;
  for (const ParameterInfo& info : parameterTable()) {
    if (group != info.group) {
      group = info.group;
      open = section(ui, info.group, group == "Charts" || group == "Balance");
    }
    if (open) parameterRow(ui, info);
  }
}

}  // namespace chartflood
