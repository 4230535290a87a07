// The box of presets above the parameters, the menu of the user's own, and the question for a name.

#include <algorithm>
#include <string>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/script/command.h"

namespace chartflood {

namespace {

std::string own(const char* action, const std::string& name) {
  return std::string(action) + ' ' + quotedArgument(name);
}

/// What the present values are called.
std::string presentName(const Ui& ui) {
  const Parameters& values = ui.state.document().parameters;
  if (values == Parameters{}) return "Standard";
  for (const UserPreset& preset : ui.state.preferences.presets) {
    std::string ignored;
    if (applyUserPreset(values, preset, ignored) == values) return preset.name;
  }
  for (const Preset& preset : presetTable()) {
    if (applyPreset(values, preset) == values) return preset.label;
  }
  return "Own settings";
}

void presetList(const Ui& ui, const std::string& present) {
  if (ImGui::Selectable("Standard", present == "Standard")) ui.run("reset-all");
  ui.probe.item("preset/standard");
  for (const Preset& preset : presetTable()) {
    if (ImGui::Selectable(preset.label, present == preset.label)) {
      ui.run(std::string("preset ") + preset.id);
    }
    ui.probe.item(std::string("preset/") + preset.id);
    tooltip(ui, preset.id, preset.label, preset.help);
  }
  ImGui::Separator();
  for (const UserPreset& preset : ui.state.preferences.presets) {
    ImGui::PushID(preset.name.c_str());
    const std::string line = own("own-preset", preset.name);
    if (ImGui::Selectable(preset.name.c_str(), present == preset.name)) ui.run(line);
    ImGui::PopID();
    ui.probe.item(line);
  }
  if (ImGui::Selectable("Save as a preset\u2026")) ui.run("name-preset");
  ui.probe.item("preset/save");
}

}  // namespace

void presetRow(const Ui& ui) {
  const Parameters& values = ui.state.document().parameters;
  const std::string present = presentName(ui);
  const float side = ImGui::GetFrameHeight();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Preset");
  ImGui::SameLine(ui.px(78));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - side - ui.px(4));
  const bool open = ImGui::BeginCombo("##preset", present.c_str(), ImGuiComboFlags_HeightLarge);
  ui.probe.item("preset");
  if (open) {
    presetList(ui, present);
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

void presetMenu(const Ui& ui) {
  if (!beginMenu(ui, "Presets")) return;
  actionMenuItem(ui, "name-preset", "Save as a preset\u2026");
  actionMenuItem(ui, "restore-preset");
  ImGui::Separator();
  // An entry may change the list.
  const std::vector<UserPreset> presets = ui.state.preferences.presets;
  for (const UserPreset& preset : presets) {
    if (!ImGui::BeginMenu(preset.name.c_str())) continue;
    actionMenuItem(ui, own("own-preset", preset.name), "Use");
    actionMenuItem(ui, own("name-preset", preset.name), "Rename\u2026");
    actionMenuItem(ui, own("delete-preset", preset.name), "Delete");
    ImGui::EndMenu();
  }
  ImGui::EndMenu();
}

void presetNameQuestion(const Ui& ui) {
  constexpr const char* kName = "Preset's name###preset-name";
  const bool asked = ui.state.panels.namesPreset;
  const bool appears = asked && !ImGui::IsPopupOpen(kName);
  if (appears) {
    ImGui::OpenPopup(kName);
    ui.memory.presetName = ui.state.panels.renamedPreset;
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(18), ui.px(14)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  const bool open =
      ImGui::BeginPopupModal(kName, nullptr,
                             ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
  if (!open) return;
  const std::string& before = ui.state.panels.renamedPreset;
  ImGui::PushFont(ui.theme.strong);
  ImGui::TextUnformatted(before.empty() ? "Name of the preset" : "New name of the preset");
  ImGui::PopFont();
  ImGui::SetNextItemWidth(ui.px(300));
  if (appears) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##name", &ui.memory.presetName, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.probe.item("preset-name");
  const std::string name = quotedArgument(ui.memory.presetName);
  const std::string line = before.empty() ? "save-preset " + name
                                          : "rename-preset " + quotedArgument(before) + ' ' + name;
  const ImVec2 button{ui.px(116), 0};
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  if (ImGui::Button(before.empty() ? "Save" : "Rename", button) || entered) ui.run(line);
  ui.probe.item("preset-name/done");
  ImGui::PopStyleColor();
  ImGui::SameLine();
  textButton(ui, "Cancel", "close-naming", button);
  if (asked && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    ui.run("close-naming");
  }
  if (!ui.state.panels.namesPreset) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace chartflood
