#include "app/gui/panels/color_mode_combo.h"

#include <string>

#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

std::string modeLine(const ColorModeInfo& info) { return std::string("color-mode ") + info.id; }

/// A line of the opened box, with its key at the right end.
void modeEntry(const Ui& ui, const ColorModeInfo& info, bool chosen) {
  const std::string key = ui.actions.shortcut(modeLine(info));
  const float end = ImGui::GetContentRegionMax().x;
  if (ImGui::Selectable(info.label, chosen)) ui.run(modeLine(info));
  ui.probe.item(modeLine(info));
  tooltip(ui, modeLine(info), info.label, info.help);
  if (key.empty()) return;
  ImGui::SameLine(end - ImGui::CalcTextSize(key.c_str()).x - ui.px(4));
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextUnformatted(key.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void colorModeCombo(const Ui& ui, float width) {
  const ColorModeInfo& present = colorModeInfo(ui.state.view.render.colorMode);
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##color-mode", present.label, ImGuiComboFlags_HeightLargest);
  ui.probe.item("color-mode");
  if (!open) {
    tooltip(ui, "color-mode", "Colour",
            "What the colours of the model say. Keys 1 to 9, Q cycles.");
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), ui.px(4)));
  for (const ColorModeInfo& info : colorModeTable()) {
    modeEntry(ui, info, info.mode == present.mode);
  }
  ImGui::PopStyleVar();
  ImGui::EndCombo();
}

void colorModeMenu(const Ui& ui) {
  for (const ColorModeInfo& info : colorModeTable()) {
    actionMenuItem(ui, modeLine(info), info.label);
  }
}

}  // namespace chartflood
