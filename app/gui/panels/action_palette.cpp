// The search for actions: a field, the best matches below it, and what the chosen one does.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/actions/action_search.h"

namespace chartflood {

namespace {

constexpr std::size_t kMostRows = 10;

/// Arrow keys move the choice while the field has the keyboard.
int onArrow(ImGuiInputTextCallbackData* data) {
  UiMemory& memory = *static_cast<UiMemory*>(data->UserData);
  if (data->EventKey == ImGuiKey_DownArrow) ++memory.searchRow;
  if (data->EventKey == ImGuiKey_UpArrow && memory.searchRow > 0) --memory.searchRow;
  return 0;
}

/// Returns whether Enter was pressed.
bool searchField(const Ui& ui) {
  UiMemory& memory = ui.memory;
  const std::string before = memory.searched;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::GetActiveID() != ImGui::GetID("##search")) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint(
      "##search", "What do you want to do?   charts 30, stretch, theme light \u2026",
      &memory.searched, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory,
      onArrow, &memory);
  ui.probe.item("search");
  if (memory.searched != before) memory.searchRow = 0;
  return entered;
}

/// One line; returns whether it was clicked.
bool row(const Ui& ui, const FoundAction& found, std::size_t number, bool chosen) {
  const Palette& p = ui.theme.palette;
  const float height = ImGui::GetFrameHeight(), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(number));
  const bool clicked = ImGui::InvisibleButton("row", {width, height});
  ImGui::PopID();
  ui.probe.item("search/" + found.line);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hovered = ImGui::IsItemHovered();
  if (chosen || hovered) {
    list.AddRectFilled(low, {low.x + width, low.y + height}, chosen ? p.accentSoft : p.control,
                       ui.px(4));
  }
  const float y = low.y + (height - ImGui::GetFontSize()) / 2, pad = ui.px(8);
  const std::string right = found.reason.empty() ? found.key : "not now";
  const ImVec2 size = ImGui::CalcTextSize(right.c_str());
  const float end = low.x + width - pad - size.x;
  list.AddText({end, y}, p.dim, right.c_str());
  const ImVec2 title = ImGui::CalcTextSize(found.title.c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, found.reason.empty() ? p.text : p.dim);
  ImGui::RenderTextEllipsis(&list, {low.x + pad, y}, {end - pad, y + size.y}, end - pad, end - pad,
                            found.title.c_str(), nullptr, &title);
  ImGui::PopStyleColor();
  return clicked;
}

/// What the chosen line does or why it cannot; always two lines high, so that nothing jumps.
void explain(const Ui& ui, const FoundAction* found) {
  const float height = 2 * ImGui::GetTextLineHeight() + ui.px(4);
  ImGui::BeginChild("explain", {0, height}, false, ImGuiWindowFlags_NoScrollbar);
  const bool refused = found != nullptr && !found->reason.empty();
  ImGui::PushStyleColor(ImGuiCol_Text, refused ? ui.theme.palette.warning : ui.theme.palette.dim);
  const std::string text = found == nullptr ? "Nothing is called like that."
                           : refused        ? found->reason
                                            : found->help;
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
  ImGui::EndChild();
}

/// The field and its lines; the line that is to be run, "" for none.
std::string content(const Ui& ui) {
  UiMemory& memory = ui.memory;
  const bool entered = searchField(ui);
  const std::vector<FoundAction> all = searchActions(ui.actions, ui.state, memory.searched);
  const std::size_t last = all.empty() ? 0 : all.size() - 1;
  memory.searchRow = std::min(memory.searchRow, last);
  const std::size_t first = memory.searchRow < kMostRows ? 0 : memory.searchRow - kMostRows + 1;
  std::string wanted;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (std::size_t i = first; i < std::min(all.size(), first + kMostRows); ++i) {
    if (row(ui, all[i], i, i == memory.searchRow)) wanted = all[i].line;
  }
  ImGui::PopStyleVar();
  ImGui::Spacing();
  explain(ui, all.empty() ? nullptr : &all[memory.searchRow]);
  if (entered && !all.empty()) wanted = all[memory.searchRow].line;
  return wanted;
}

}  // namespace

void actionPalette(const Ui& ui) {
  UiMemory& memory = ui.memory;
  if (!ui.state.panels.search) {
    memory.searchOpen = false;
    return;
  }
  const bool opened = !std::exchange(memory.searchOpen, true);
  if (opened) {
    memory.searched.clear();
    memory.searchRow = 0;
    ImGui::SetNextWindowFocus();
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float width = std::min(ui.px(560), screen.x - ui.px(20));
  ImGui::SetNextWindowPos({std::round((screen.x - width) / 2), ui.px(60)});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(10)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.popup);
  ImGui::Begin("find an action", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings);
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  const std::string line = content(ui);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ui.probe.rectangle("action-palette", low, {low.x + size.x, low.y + size.y});
  const bool elsewhere = !opened && ImGui::IsMouseClicked(0) &&
                         !ImGui::IsMouseHoveringRect(low, {low.x + size.x, low.y + size.y}, false);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
  if (line.empty() && !escaped && !elsewhere) return;
  ui.run("find-action off");
  ImGui::ClearActiveID();
  GImGui->NavDisableHighlight = true;  // single keys act again
  if (!line.empty()) ui.run(line);
}

}  // namespace chartflood
