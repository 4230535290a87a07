// What deserves attention: a line that unfolds to a list; a click shows the next place of a kind.

#include <algorithm>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"

namespace chartflood {

namespace {

/// Worse than untidy: paint will come out wrong.
bool serious(ProblemKind kind) {
  return kind != ProblemKind::DegenerateFaces && kind != ProblemKind::OpenSharpEdges;
}

/// The line that folds and unfolds the list.
void foldLine(const Ui& ui, const std::string& words, ImU32 color, float width) {
  const float height = ImGui::GetFrameHeight();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("##problems", {width, height});
  ui.probe.item("problems");
  tooltip(ui, "problems", "Worth a look   " + ui.actions.shortcut("problems"),
          "What deserves attention before the charts are painted on. A click on a line shows the "
          "next place.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) {
    list.AddRectFilled(low, {low.x + width, low.y + height}, ui.theme.palette.control, ui.px(4));
  }
  const float font = ImGui::GetFontSize();
  ImGui::RenderArrow(&list, {low.x + ui.px(4), low.y + (height - font) / 2}, color,
                     ui.state.panels.problems ? ImGuiDir_Down : ImGuiDir_Right, 0.8f);
  const ImVec2 at{low.x + ui.px(8) + font, low.y + (height - font) / 2};
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::RenderTextEllipsis(&list, at, {low.x + width, at.y + size.y}, low.x + width, low.x + width,
                            words.c_str(), nullptr, &size);
  ImGui::PopStyleColor();
  if (clicked) ui.run(ui.state.panels.problems ? "problems off" : "problems on");
}

void problemRow(const Ui& ui, const Problem& problem) {
  const std::string line = std::string("show-problem ") + problemId(problem.kind);
  const float indent = ui.px(22);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), width = ImGui::GetContentRegionAvail().x;
  const bool clicked = ImGui::InvisibleButton(line.c_str(), {width, height});
  ui.probe.item(line);
  tooltip(ui, line, "", problemHelp(problem.kind));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& p = ui.theme.palette;
  if (ImGui::IsItemHovered()) {
    list.AddRectFilled(low, {low.x + width, low.y + height}, p.control, ui.px(4));
  }
  const ImU32 color = serious(problem.kind) ? p.warning : p.dim;
  const float middle = low.y + height / 2;
  list.AddCircleFilled({low.x + ui.px(11), middle}, ui.px(3.5f), color);
  const std::string words = problemText(problem);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  ImGui::RenderTextEllipsis(&list, {low.x + indent, middle - size.y / 2},
                            {low.x + width, middle + size.y}, low.x + width, low.x + width,
                            words.c_str(), nullptr, &size);
  if (clicked) ui.run(line);
}

}  // namespace

void problemList(const Ui& ui) {
  const auto problems = ui.state.insight().problems(ui.state.results());
  const Palette& p = ui.theme.palette;
  const float copy = ImGui::CalcTextSize("Copy as CSV").x + 2 * ImGui::GetStyle().FramePadding.x;
  const float width = ImGui::GetContentRegionAvail().x - copy - ImGui::GetStyle().ItemSpacing.x;
  const bool any = problems && !problems->empty();
  const bool bad = any && std::any_of(problems->begin(), problems->end(),
                                      [](const Problem& one) { return serious(one.kind); });
  const std::string words =
      any ? "Worth a look: " + std::to_string(problems->size()) : "Nothing to look at";
  foldLine(ui, words, bad ? p.warning : any ? p.text : p.dim, width);
  ImGui::SameLine();
  textButton(ui, "Copy as CSV", "copy-charts");
  if (!any || !ui.state.panels.problems) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (const Problem& problem : *problems) problemRow(ui, problem);
  ImGui::PopStyleVar();
  ImGui::Dummy({0, ui.px(2)});
}

}  // namespace chartflood
