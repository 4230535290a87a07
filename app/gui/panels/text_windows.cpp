// The windows of text: keys, log, about.

#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/panels/text_window.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

ImU32 levelColor(const Palette& palette, LogLevel level) {
  if (level == LogLevel::Error) return palette.error;
  if (level == LogLevel::Warning) return palette.warning;
  return level == LogLevel::Debug ? palette.dim : palette.text;
}

void keyRow(const Ui& ui, const Binding& binding) {
  const Command command = parseCommand(binding.line);
  const Action* action = ui.actions.find(command.action);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(ui.theme.strong);
  ImGui::TextUnformatted(chordText(binding.chord).c_str());
  ImGui::PopFont();
  ImGui::TableNextColumn();
  std::string title = action->title;
  if (const auto first = command.arguments.find("0"); first != command.arguments.end()) {
    title += ": " + first->second;
  }
  if (binding.place == KeyPlace::SeedsTool) title += " (seeds tool)";
  if (binding.place == KeyPlace::HandleFilm) title += " (film of a handle)";
  ImGui::TextWrapped("%s", title.c_str());
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextWrapped("%s", action->help.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void textWindow(const Ui& ui, const char* title, std::string_view line, ImVec2 size,
                const std::function<void()>& content) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 fitted{std::min(size.x, screen.x - ui.px(20)),
                      std::min(size.y, screen.y - ui.px(20))};
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(fitted, ImGuiCond_Appearing);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  bool open = true;
  if (ImGui::Begin(title, &open, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
    content();
  }
  const ImVec2 low = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
  ui.probe.rectangle(title, low, {low.x + extent.x, low.y + extent.y});
  const bool escaped = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  ImGui::End();
  ImGui::PopStyleVar(2);
  if (!open || escaped) ui.run(line);
}

void keysWindow(const Ui& ui) {
  if (!ui.state.panels.keys) return;
  textWindow(ui, "Keys", "keys off", {ui.px(720), ui.px(560)}, [&] {
    ImGui::TextWrapped(
        "Mouse in the 3D view: drag to turn, middle or Shift+drag to move, wheel or right drag to "
        "come closer, click to select a chart, double-click to turn about that place.");
    ImGui::Separator();
    if (!ImGui::BeginTable("keys", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY)) return;
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 1.1f);
    ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch, 1.5f);
    ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch, 3.2f);
    for (const Binding& binding : ui.actions.bindings()) keyRow(ui, binding);
    ImGui::EndTable();
  });
}

void logWindow(const Ui& ui) {
  if (!ui.state.panels.log) return;
  textWindow(ui, "Log", "log off", {ui.px(680), ui.px(360)}, [&] {
    ImGui::BeginChild("lines");
    for (const Notices::Line& line : ui.state.notices.log()) {
      ImGui::PushStyleColor(ImGuiCol_Text, levelColor(ui.theme.palette, line.level));
      ImGui::TextWrapped("%s", line.text.c_str());
      ImGui::PopStyleColor();
    }
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY()) ImGui::SetScrollHereY(1);
    ImGui::EndChild();
  });
}

void aboutWindow(const Ui& ui) {
  if (!ui.state.panels.about) return;
  textWindow(ui, "About", "about off", {ui.px(520), ui.px(300)}, [&] {
    ImGui::PushFont(ui.theme.strong);
    ImGui::TextUnformatted("chartflood " CHARTFLOOD_VERSION);
    ImGui::PopFont();
    ImGui::TextWrapped(
        "Cuts a surface mesh into charts that flatten well, by floods that race over the surface "
        "and avoid its curvature.");
    ImGui::Spacing();
    ImGui::TextWrapped(
        "The method: H. Yamauchi, S. Gumhold, R. Zayer, H.-P. Seidel, \"Mesh segmentation driven "
        "by Gaussian curvature\", The Visual Computer 21, 2005.");
    ImGui::Spacing();
    ImGui::TextWrapped(
        "Everything this window does is also on the command line: chartflood --help. A screen "
        "reader cannot read this window; the command line and the JSON report give the whole "
        "function.");
    ImGui::Spacing();
    ImGui::TextWrapped("Text is set in Inter, by Rasmus Andersson (SIL Open Font License).");
  });
}

}  // namespace chartflood
