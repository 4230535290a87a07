#include "app/gui/tools/hints_tool.h"

#include <string>
#include <utility>

#include "app/gui/tools/seeds_tool.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

void pressBrush(const Ui& ui, SceneSource* source, const ViewRectangle& view,
                const SceneMouse& mouse) {
  AppState& state = ui.state;
  state.hintStroke.reset();
  const bool paints = state.panels.tool == PanelState::Tool::Hints && mouse.pane.live();
  if (!paints || mouse.button != 0 || ImGui::GetIO().KeyAlt) return;
  const Pick pick = pickAt(source, view, ImGui::GetIO().MousePos);
  if (!pick.hit()) return;
  state.hintStroke.emplace();
  leadStroke(*state.results().mesh, *state.hintStroke,
             nearestCorner(*state.results().mesh, pick.triangle, pick.point));
}

void dragBrush(const Ui& ui, SceneSource* source, const ViewRectangle& view) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  if (moved.x == 0 && moved.y == 0) return;
  const Pick pick = pickAt(source, view, ImGui::GetIO().MousePos);
  if (!pick.hit()) return;
  const Mesh& mesh = *ui.state.results().mesh;
  leadStroke(mesh, *ui.state.hintStroke, nearestCorner(mesh, pick.triangle, pick.point));
}

void releaseBrush(const Ui& ui) {
  const HintStroke stroke = *std::exchange(ui.state.hintStroke, std::nullopt);
  if (stroke.vertices.size() < 2) return;
  const Mesh& mesh = *ui.state.results().mesh;
  std::string path;
  for (const Index vertex : stroke.vertices) {
    path += (path.empty() ? "" : ",") + std::to_string(mesh.inputVertex(vertex));
  }
  ui.run("paint " + hintBrushId(ui.state.panels.brush) + " path=" + path);
}

void brushSwitch(const Ui& ui) {
  const auto brush = [&](const char* words, HintBrush which) {
    const bool chosen = ui.state.panels.brush == which;
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? ui.theme.palette.accentSoft : 0);
    textButton(ui, words, "brush " + hintBrushId(which), {ui.px(68), 0});
    ImGui::PopStyleColor();
  };
  brush("Cut here", HintBrush::Cut);
  ImGui::SameLine(0, ui.px(2));
  brush("Never", HintBrush::Never);
  ImGui::SameLine(0, ui.px(2));
  brush("Erase", HintBrush::Erase);
}

}  // namespace chartflood
