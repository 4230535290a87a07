// What is asked about the work: before unsaved changes are lost, and after a crash.

#include <algorithm>
#include <cmath>
#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

void recoveryCard(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax) {
  if (ui.state.keeper.recovery.left().empty()) return;
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::SetNextWindowPos({areaMin.x + ui.px(12), areaMin.y + ui.px(56)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(14), ui.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.bar);
  ImGui::Begin("recovery card", nullptr, kFlags);
  ImGui::PushTextWrapPos(std::min(ui.px(300), areaMax.x - areaMin.x - ui.px(52)));
  ImGui::TextUnformatted("The last session ended unexpectedly.");
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextUnformatted(ui.state.keeper.recovery.leftTitle().c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  const ImVec2 button{ui.px(96), 0};
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  textButton(ui, "Restore", "restore-session", button);
  ImGui::PopStyleColor();
  ImGui::SameLine();
  textButton(ui, "Forget", "forget-session", button);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ui.probe.rectangle("recovery-card", low, {low.x + size.x, low.y + size.y});
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

void unsavedQuestion(const Ui& ui) {
  constexpr const char* kName = "Save the changes?###unsaved";
  const bool asked = ui.state.panels.unsavedQuestion;
  if (asked && !ImGui::IsPopupOpen(kName)) ImGui::OpenPopup(kName);
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
  if (!asked) {
    ImGui::CloseCurrentPopup();
    return ImGui::EndPopup();
  }
  ImGui::PushFont(ui.theme.strong);
  ImGui::Text("Save the changes to %s?", ui.state.modelName().c_str());
  ImGui::PopFont();
  ImGui::TextUnformatted("Parameters or seeds were changed since it was opened or saved.");
  ImGui::Spacing();
  switchRow(ui, "Do not ask again", !ui.state.preferences.askUnsaved, "ask-unsaved");
  ImGui::Spacing();
  const ImVec2 button{ui.px(116), 0};
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  textButton(ui, "Save", "answer save", button);
  ImGui::PopStyleColor();
  ImGui::SameLine();
  textButton(ui, "Do not save", "answer discard", button);
  ImGui::SameLine();
  textButton(ui, "Cancel", "answer cancel", button);
  const bool answered = !ui.state.panels.unsavedQuestion;
  if (!answered && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    ui.run("answer cancel");
  }
  if (!ui.state.panels.unsavedQuestion) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace chartflood
