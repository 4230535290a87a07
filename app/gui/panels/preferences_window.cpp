// What the user likes, kept from run to run: every row is an action of the registry.

#include <cmath>
#include <span>
#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/panels/text_window.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

/// A line of a box that opens, and what choosing it runs.
struct Choice {
  std::string words, line;
};

void choiceRow(const Ui& ui, const char* label, std::span<const Choice> choices) {
  const Choice* present = nullptr;
  for (const Choice& each : choices) {
    if (ui.actions.checked(each.line, ui.state)) present = &each;
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(std::round(ImGui::GetWindowContentRegionMax().x * 0.42f));
  ImGui::SetNextItemWidth(-1);
  const std::string id = std::string("##") + label;
  const bool open = ImGui::BeginCombo(id.c_str(), present == nullptr ? "" : present->words.c_str());
  ui.probe.item(std::string("likes/") + label);
  if (!open) return;
  for (const Choice& each : choices) {
    if (ImGui::Selectable(each.words.c_str(), &each == present)) ui.run(each.line);
    ui.probe.item("likes/" + each.line);
  }
  ImGui::EndCombo();
}

/// The choices of an action's first argument, by their labels.
void choicesOf(const Ui& ui, const char* action, const char* label = nullptr) {
  const Action& found = *ui.actions.find(action);
  const ArgumentInfo& argument = found.arguments.front();
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < argument.choices.size(); ++i) {
    choices.push_back({argument.labels[i], std::string(action) + ' ' + argument.choices[i]});
  }
  choiceRow(ui, label == nullptr ? found.title.c_str() : label, choices);
}

void switchOf(const Ui& ui, const char* action) {
  switchRow(ui, ui.actions.find(action)->title.c_str(), ui.actions.checked(action, ui.state),
            action);
}

void lookRows(const Ui& ui) {
  choicesOf(ui, "theme");
  std::vector<Choice> sizes = {{"As the screen proposes", "ui-scale auto"}};
  for (const char* percent : {"75", "100", "125", "150", "175", "200", "250"}) {
    sizes.push_back({std::string(percent) + " %", std::string("ui-scale ") + percent});
  }
  choiceRow(ui, "Size of the interface", sizes);
}

void mouseRows(const Ui& ui) {
  choicesOf(ui, "navigation");
  if (ui.state.preferences.navigation == NavigationStyle::Maya) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
    ImGui::TextWrapped("Some window managers keep Alt+drag for themselves.");
    ImGui::PopStyleColor();
  }
  static const Choice kAxes[] = {{"Y", "up-axis y"}, {"Z", "up-axis z"}};
  choiceRow(ui, "Upright axis of this model", kAxes);
  for (const char* line : {"trackball", "invert-zoom", "invert-turn-x", "invert-turn-y"}) {
    switchOf(ui, line);
  }
}

void habitRows(const Ui& ui) {
  choicesOf(ui, "live", "Flood while dragging");
  switchOf(ui, "ask-unsaved");
}

void heading(const Ui& ui, const char* words) {
  ImGui::Spacing();
  ImGui::PushFont(ui.theme.strong);
  ImGui::TextUnformatted(words);
  ImGui::PopFont();
}

}  // namespace

void preferencesWindow(const Ui& ui) {
  if (!ui.state.panels.preferences) return;
  textWindow(ui, "Preferences", "preferences off", {ui.px(500), ui.px(430)}, [&] {
    heading(ui, "Look");
    lookRows(ui);
    heading(ui, "Mouse and camera");
    mouseRows(ui);
    heading(ui, "Habits");
    habitRows(ui);
  });
}

}  // namespace chartflood
