// Presets, the live switch and the rows of the parameter table by section.

#include <string>
#include <string_view>
#include <vector>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/state/staleness.h"

namespace chartflood {

namespace {

/// A button that says in words what its script line does.
struct NamedLine {
  std::string words, line;
};

/// A row of buttons of which the one that is in force is marked.
void choiceRow(const Ui& ui, const char* label, const std::vector<NamedLine>& choices,
               bool (*inForce)(const Ui& ui, const std::string& line)) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(ui.px(78));
  const float gap = ui.px(2), side = ImGui::GetFrameHeight() + ui.px(4);
  const auto count = static_cast<float>(choices.size());
  const float width = (ImGui::GetContentRegionAvail().x - side - (count - 1) * gap) / count;
  for (const NamedLine& each : choices) {
    if (&each != &choices.front()) ImGui::SameLine(0, gap);
    const bool chosen = inForce(ui, each.line);
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
    textButton(ui, each.words.c_str(), each.line, {width, 0});
    if (chosen) ImGui::PopStyleColor();
  }
}

/// What values are answered with: finished charts, or floods to be watched.
void lookRow(const Ui& ui) {
  choiceRow(ui, "Look", {{"Explore", "explore on"}, {"Watch", "explore off"}},
            [](const Ui& ui, const std::string& line) {
              return ui.state.preferences.explore == (line == "explore on");
            });
}

void liveRow(const Ui& ui) {
  std::vector<NamedLine> choices;
  for (const std::string& each : ui.actions.find("live")->arguments.front().choices) {
    choices.push_back({each, "live " + each});
  }
  choiceRow(ui, "Live", choices, [](const Ui& ui, const std::string& line) {
    return ui.actions.checked(line, ui.state);
  });
}

const char* answerWords(const AppState& state) {
  if (state.preferences.explore) {
    return state.answersDrags() ? "Previews while dragged, finishes when let go"
                                : "Too large for previews: finishes when let go";
  }
  return state.answersDrags() ? "Floods while a slider is dragged"
                              : "Floods when a slider is let go";
}

/// When a slider is answered, and with what.
void answerRow(const Ui& ui) {
  ImGui::PushFont(ui.theme.small);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::SetCursorPosX(ui.px(78));
  fittedText(ui, answerWords(ui.state), ImGui::GetContentRegionAvail().x, ui.theme.palette.dim);
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
  lookRow(ui);
  if (!ui.state.preferences.explore) liveRow(ui);
  answerRow(ui);
  const ParameterInfo* shown = findParameter(ui.state.panels.shownParameter);
  std::string_view group;
  bool open = true;
  for (const ParameterInfo& info : parameterTable()) {
    if (group != info.group) {
      group = info.group;
      open = section(ui, info.group, group == "Charts" || group == "Borders" || group == "Unwrap",
                     shown != nullptr && group == shown->group, staleWords(ui, group));
    }
    if (open) parameterRow(ui, info);
  }
}

}  // namespace chartflood
