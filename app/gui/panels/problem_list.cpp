// What deserves attention: a line that unfolds to a list; a click shows the next place of a kind.

#include <algorithm>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/panels/problem_key.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

/// Worse than untidy: paint will come out wrong.
bool serious(ProblemKind kind) {
  return kind != ProblemKind::DegenerateFaces && kind != ProblemKind::OpenSharpEdges &&
         kind != ProblemKind::NonManifoldEdges;
}

/// The line that folds and unfolds the list.
void foldLine(const Ui& ui, const std::string& words, ImU32 color, float width) {
  const float height = ImGui::GetFrameHeight();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("##problems", {width, height});
  ui.probe.item("problems");
  tooltip(ui, "problems", "Worth a look",
          "What deserves attention before the charts are painted on. A click on a line shows the "
          "next place; " +
              ui.actions.shortcut("problems") + " marks all of them on the model.");
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
  if (clicked) ui.run(ui.state.panels.problems ? "problem-list off" : "problem-list on");
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
  const float whole = ImGui::GetContentRegionAvail().x;
  for (const Problem& problem : *problems) problemRow(ui, problem, whole, "");
  ImGui::PopStyleVar();
  ImGui::Dummy({0, ui.px(2)});
}

}  // namespace chartflood
