#include "app/gui/panels/problem_key.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "app/gui/widgets/widgets.h"
#include "app/host/insight/problem_marks.h"
#include "app/host/state/compare_look.h"

namespace chartflood {

namespace {

constexpr ImU32 kChip = IM_COL32(26, 26, 28, 255);

/// Stripes through a square: `dx` and `dy` lead from one end of a stripe to the other.
void stripes(ImDrawList& list, ImVec2 low, float side, float dx, float dy, ImU32 color) {
  const float step = side / 2;
  for (int i = -2; i <= 4; ++i) {
    const float at = step * (static_cast<float>(i) + 0.5f);
    const ImVec2 from = dx != 0 && dy != 0 ? ImVec2{low.x + at, dy > 0 ? low.y : low.y + side}
                                           : ImVec2{low.x, low.y + at};
    list.AddLine(from, {from.x + dx * side, from.y + dy * side}, color, side / 5);
  }
}

void dots(ImDrawList& list, ImVec2 low, float side, ImU32 color) {
  for (const float x : {0.27f, 0.73f}) {
    for (const float y : {0.27f, 0.73f}) {
      list.AddCircleFilled({low.x + x * side, low.y + y * side}, 0.17f * side, color);
    }
  }
}

void line(ImDrawList& list, ImVec2 low, float side, const ProblemLook& look, ImU32 color) {
  const float y = std::round(low.y + side / 2), thick = side * look.width / 14;
  const auto piece = [&](float from, float to) {
    list.AddRectFilled({low.x + from * side, y - thick}, {low.x + to * side, y + thick}, color);
  };
  if (!look.dashed) return piece(0, 1);
  piece(0.08f, 0.42f);
  piece(0.58f, 0.92f);
}

/// Kinds that at least one half of a comparison has; null: not known yet of any.
std::optional<std::vector<ProblemKind>> comparedKinds(const Ui& ui) {
  std::optional<std::vector<ProblemKind>> kinds;
  for (const ComparePane& pane : ui.state.compare.panes()) {
    const auto problems = paneInsight(ui.state, pane).problems(paneResults(ui.state, pane));
    if (!problems) continue;
    if (!kinds) kinds.emplace();
    for (const Problem& each : *problems) kinds->push_back(each.kind);
  }
  if (!kinds) return kinds;
  std::sort(kinds->begin(), kinds->end());
  kinds->erase(std::unique(kinds->begin(), kinds->end()), kinds->end());
  return kinds;
}

float nameWidth(const Ui& ui, const std::string& words) {
  return ImGui::CalcTextSize(words.c_str()).x + ui.px(34);
}

/// What a mark means; counts stand under the halves.
void kindRow(const Ui& ui, ProblemKind kind) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), side = ui.px(14);
  const std::string words = problemName(kind);
  ImGui::Dummy({nameWidth(ui, words), height});
  const std::string label = std::string("key/") + problemId(kind);
  ui.probe.item(label);
  tooltip(ui, label, "", problemHelp(kind));
  const float middle = low.y + height / 2;
  problemSwatch(ui, kind, {low.x + ui.px(5), std::round(middle - side / 2)}, side);
  ImGui::GetWindowDrawList()->AddText({low.x + ui.px(26), middle - ImGui::GetFontSize() / 2},
                                      ui.theme.palette.text, words.c_str());
}

}  // namespace

void problemSwatch(const Ui& ui, ProblemKind kind, ImVec2 low, float side) {
  const ProblemLook look = problemLook(kind);
  const ImU32 color = ImGui::ColorConvertFloat4ToU32({look.color.x, look.color.y, look.color.z, 1});
  const ImVec2 high{low.x + side, low.y + side};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, kChip, ui.px(2));
  list.PushClipRect(low, high, true);
  switch (look.mark) {
  case TriangleMark::None:
    line(list, low, side, look, color);
    break;
  case TriangleMark::Lattice:
    stripes(list, low, side, 1, 1, color);
    stripes(list, low, side, 1, -1, color);
    break;
  case TriangleMark::Stripes:
    stripes(list, low, side, 1, -1, color);
    break;
  case TriangleMark::Bars:
    stripes(list, low, side, 1, 0, color);
    break;
  case TriangleMark::Dots:
    dots(list, low, side, color);
    break;
  }
  list.PopClipRect();
  list.AddRect(low, high, ui.theme.palette.line, ui.px(2));
}

void problemRow(const Ui& ui, const Problem& problem, float width, const char* scope) {
  const std::string line = std::string("show-problem ") + problemId(problem.kind);
  const std::string label = scope + line;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), side = ui.px(14);
  const bool clicked = ImGui::InvisibleButton(label.c_str(), {width, height});
  ui.probe.item(label);
  tooltip(ui, label, "", std::string(problemHelp(problem.kind)) + "\nA click shows the next one.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) {
    list.AddRectFilled(low, {low.x + width, low.y + height}, ui.theme.palette.control, ui.px(4));
  }
  const float middle = low.y + height / 2, indent = ui.px(26);
  problemSwatch(ui, problem.kind, {low.x + ui.px(5), std::round(middle - side / 2)}, side);
  const std::string words = problemText(problem);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  ImGui::RenderTextEllipsis(&list, {low.x + indent, middle - size.y / 2},
                            {low.x + width, middle + size.y}, low.x + width, low.x + width,
                            words.c_str(), nullptr, &size);
  if (clicked) ui.run(line);
}

void problemKey(const Ui& ui, ImVec2 areaMin) {
  if (!ui.state.view.render.problems || !ui.state.hasMesh() || ui.state.film.ready()) return;
  const bool comparing = ui.state.compare.showing();
  const auto problems = ui.state.insight().problems(ui.state.results());
  const auto kinds = comparing ? comparedKinds(ui) : std::nullopt;
  const bool known = comparing ? kinds.has_value() : problems != nullptr;
  const bool none = known && (comparing ? kinds->empty() : problems->empty());
  const char* title = !known ? "No charts to look at yet" : none ? "No problems found" : "";
  float width = 0;
  if (known && !comparing) {
    for (const Problem& each : *problems) {
      width = std::max(width, nameWidth(ui, problemText(each)));
    }
  }
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::SetNextWindowPos({areaMin.x + ui.px(12), areaMin.y + ui.px(52)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(3), ui.px(3)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(5));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.bar);
  ImGui::Begin("problem key", nullptr, kFlags);
  if (*title != '\0') {
    ImGui::SetCursorPosX(ui.px(8));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(title);
    ui.probe.item("problem-key");
  } else if (comparing) {
    for (const ProblemKind kind : *kinds) kindRow(ui, kind);
  } else {
    for (const Problem& each : *problems) problemRow(ui, each, width, "key/");
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace chartflood
