#include "app/gui/tools/scene_panel.h"

#include <cmath>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/tools/hints_tool.h"
#include "app/gui/tools/seeds_tool.h"
#include "app/gui/views/camera_control.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

bool usesSeeds(const Ui& ui, const SceneMouse& mouse) {
  return ui.state.panels.tool == PanelState::Tool::Seeds && mouse.pane.live();
}

/// Notes that the user moved the camera.
void moved(SceneMouse& mouse) {
  mouse.movedAt = ImGui::GetTime();
  mouse.framed = false;
}

void moveCamera(const Ui& ui, const ViewRectangle& view, SceneMouse& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 delta = io.MouseDelta;
  if (delta.x == 0 && delta.y == 0) return;
  const CameraMotion motion =
      motionOf(ui.state.preferences.navigation, mouse.button, io.KeyShift, io.KeyCtrl, io.KeyAlt);
  if (motion == CameraMotion::None) return;
  dragCamera(ui.state.view.camera, motion, view, {io.MousePos.x - delta.x, io.MousePos.y - delta.y},
             io.MousePos, ui.state.preferences);
  moved(mouse);
}

void click(const Ui& ui, SceneSource* source, const ViewRectangle& view, const SceneMouse& mouse) {
  const Pick pick = pickAt(source, view, ImGui::GetIO().MousePos);
  if (ImGui::GetIO().MouseDoubleClicked[0] && pick.hit()) return;
  std::string line = "select-chart";
  if (!mouse.pane.live()) line = "select-stored " + paneName(ui.state.compare, mouse.pane);
  ui.run(pick.chart == kNone ? line : line + ' ' + std::to_string(pick.chart));
}

/// The right button opens the menu of the chart under the mouse.
void openMenu(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  mouse.menuChart = pickAt(source, view, ImGui::GetIO().MousePos).chart;
  if (mouse.menuChart != kNone || !ui.state.view.hiddenCharts.empty()) {
    ImGui::OpenPopup("chart menu");
  }
}

void chartMenu(const Ui& ui, const SceneMouse& mouse) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(6)));
  if (ImGui::BeginPopup("chart menu")) {
    if (mouse.menuChart == kNone) {
      actionMenuItem(ui, "show-all-charts");
    } else {
      chartEntries(ui, mouse.menuChart);
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void hover(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  const ImVec2 place = ImGui::GetIO().MousePos;
  const bool same = place.x == mouse.pickedAt.x && place.y == mouse.pickedAt.y;
  if (same || source == nullptr) return;
  mouse.pickedAt = place;
  mouse.face = pickAt(source, view, place).face;
  const bool sameMesh = paneResults(ui.state, mouse.pane).mesh == ui.state.results().mesh;
  ui.state.hoveredFace = sameMesh ? mouse.face : kNone;
  ui.state.compare.underMouse = mouse.pane;
  if (mouse.pane.live()) {
    ui.state.hoveredSeed = usesSeeds(ui, mouse) ? seedAt(ui, source, view, place) : kNone;
  }
}

/// A drag moves the seed that it began on, or else the camera.
void dragInView(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  mouse.travelled += std::abs(delta.x) + std::abs(delta.y);
  if (ui.state.hintStroke) return dragBrush(ui, source, view);
  if (mouse.travelled < SceneMouse::kClickTravel) return;
  if (mouse.button == 0 && mouse.seed != kNone) {
    dragSeed(ui, source, view, mouse);
  } else {
    moveCamera(ui, view, mouse);
  }
}

void useMouse(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) {
    mouse.button = io.MouseDown[0] ? 0 : io.MouseDown[1] ? 1 : 2;
    mouse.travelled = 0;
    if (ui.state.panels.firstCard) ui.run("first-steps off");
    GImGui->NavDisableHighlight = true;  // the keyboard belongs to the view again
    if (ui.state.compare.showing()) activate(ui.state, mouse.pane);
    mouse.seed = kNone;
    if (mouse.pane.live()) pressSeed(ui, source, view, mouse);
    pressBrush(ui, source, view, mouse);
  }
  if (ImGui::IsItemActive() && mouse.button >= 0) dragInView(ui, source, view, mouse);
  if (ImGui::IsItemDeactivated()) {
    if (ui.state.hintStroke) {
      releaseBrush(ui);
    } else if (usesSeeds(ui, mouse) || mouse.seedDragged) {
      releaseSeed(ui, source, view, mouse);
    } else if (mouse.travelled < SceneMouse::kClickTravel) {
      if (mouse.button == 0) click(ui, source, view, mouse);
      if (mouse.button == 1 && mouse.pane.live()) openMenu(ui, source, view, mouse);
    }
    mouse.button = -1;
  }
  if (!ImGui::IsItemHovered()) {
    // Once, when the mouse leaves: the texture may be what is pointed at.
    if (mouse.hovering && ui.state.hoveredFace == mouse.face) ui.state.hoveredFace = kNone;
    if (mouse.pane.live()) ui.state.hoveredSeed = kNone;
    mouse.hovering = false;
    mouse.pickedAt = {-1, -1};
    return;
  }
  mouse.hovering = true;
  if (io.MouseDoubleClicked[0] && !usesSeeds(ui, mouse)) {
    if (const Pick pick = pickAt(source, view, io.MousePos); pick.hit()) {
      ui.state.view.camera.target = pick.point;
      moved(mouse);
    }
  }
  if (io.MouseWheel != 0) {
    if (ui.state.compare.showing()) activate(ui.state, mouse.pane);
    wheelCamera(ui.state.view.camera, view, io.MousePos, io.MouseWheel,
                ui.state.preferences.invertZoom);
    moved(mouse);
  }
  if (mouse.button < 0) hover(ui, source, view, mouse);
  if (ui.state.hoveredSeed != kNone) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

/// The model's axes at the bottom left, so that turning is never lost.
void drawAxes(const Ui& ui, const ViewRectangle& view) {
  struct Axis {
    const char* name;
    glm::dvec3 direction;
    ImU32 color;
  };
  const Palette& p = ui.theme.palette;
  const Axis axes[] = {
      {"x", {1, 0, 0}, p.axisX}, {"y", {0, 1, 0}, p.axisY}, {"z", {0, 0, 1}, p.axisZ}};
  const Camera& camera = ui.state.view.camera;
  const float length = ui.px(26);
  const ImVec2 center{view.min.x + ui.px(44), view.max.y - ui.px(56)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.theme.small);
  for (const Axis& axis : axes) {
    const auto x = static_cast<float>(glm::dot(axis.direction, camera.right()));
    const auto y = static_cast<float>(glm::dot(axis.direction, camera.upward()));
    const ImVec2 tip{center.x + length * x, center.y - length * y};
    list.AddLine(center, tip, axis.color, ui.px(1.6f));
    const ImVec2 size = ImGui::CalcTextSize(axis.name);
    list.AddText(
        {center.x + 1.32f * length * x - size.x / 2, center.y - 1.32f * length * y - size.y / 2},
        axis.color, axis.name);
  }
  ImGui::PopFont();
}

/// The gestures as lines of text from the bottom upwards; those of seeds in pieces that fit a
/// narrow view too.
std::vector<const char*> hintLines(const Ui& ui) {
  if (ui.state.seedDrag) return {"Let go: it stays here    Esc: puts it back"};
  if (ui.state.panels.tool == PanelState::Tool::Seeds) {
    return {
        "Right click: menu    Drag beside: turn    V: select charts",
        "Keys: Tab chooses a seed, arrows move it, Delete removes, Ctrl+L locks, Insert adds",
        "Click: add a seed    Drag a seed: move it    Ctrl+click: remove    Double click: lock"};
  }
  if (ui.state.panels.tool == PanelState::Tool::Hints) {
    return {"Drag on the model: paint edges    Drag beside: turn    V: select charts"};
  }
  switch (ui.state.preferences.navigation) {
  case NavigationStyle::Blender:
    return {"Middle: turn    Shift+middle: move    Wheel: closer    Click: select a chart"};
  case NavigationStyle::Maya:
    return {"Alt+left: turn    Alt+middle: move    Alt+right: closer    Click: select a chart"};
  case NavigationStyle::Simple:
    break;
  }
  return {"Drag: turn    Middle: move    Wheel: closer    Click: select    Right click: menu    H: "
          "keys"};
}

void drawHint(const Ui& ui, const ViewRectangle& view) {
  ImGui::PushFont(ui.theme.small);
  float y = view.max.y - ui.px(24);
  for (const char* text : hintLines(ui)) {
    const float width = ImGui::CalcTextSize(text).x;
    if (width + ui.px(24) < view.width()) {
      const ImVec2 at{std::round((view.min.x + view.max.x - width) / 2), y};
      const float pad = ui.px(6), height = ImGui::GetTextLineHeight();
      ImDrawList& list = *ImGui::GetWindowDrawList();
      list.AddRectFilled({at.x - pad, at.y - 1}, {at.x + width + pad, at.y + height + 1},
                         ui.theme.palette.veil, ui.px(3));
      list.AddText(at, ui.theme.palette.text, text);
    }
    y -= ImGui::GetTextLineHeight() + ui.px(2);
  }
  ImGui::PopFont();
}

/// What is missing before the colours can say what they shall.
void drawMissing(const Ui& ui, const ViewRectangle& view) {
  const ColorMode mode = ui.state.view.render.colorMode;
  if (!needsUnwrap(mode) || ui.state.results().atlas) return;
  std::string text =
      std::string(colorModeInfo(mode).label) + " can be seen when the charts are laid flat";
  const std::string key = ui.actions.shortcut("unwrap");
  if (!key.empty() && !ui.state.status().unwrapping) text += ": press " + key;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at{std::round((view.min.x + view.max.x - size.x) / 2), view.min.y + ui.px(62)};
  const ImVec2 pad{ui.px(10), ui.px(5)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x - pad.x, at.y - pad.y}, {at.x + size.x + pad.x, at.y + size.y + pad.y},
                     ui.theme.palette.bar, ui.px(4));
  list.AddText(at, ui.theme.palette.text, text.c_str());
}

/// Says that colours are not what they are, as long as they are not.
void drawVisionBadge(const Ui& ui, const ViewRectangle& view) {
  const ColorVision vision = ui.state.view.vision;
  if (vision == ColorVision::Full) return;
  const std::string text = std::string("Simulating ") + colorVisionInfo(vision).label +
                           ": saved pictures keep their colours";
  const ImVec2 pad{ui.px(10), ui.px(5)};
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at{std::round((view.min.x + view.max.x - size.x) / 2), view.min.y + ui.px(94)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 low{at.x - pad.x, at.y - pad.y}, high{at.x + size.x + pad.x, at.y + size.y + pad.y};
  list.AddRectFilled(low, high, ui.theme.palette.bar, ui.px(4));
  list.AddRect(low, high, ui.theme.palette.front, ui.px(4));
  list.AddText(at, ui.theme.palette.text, text.c_str());
  ui.probe.rectangle("vision-badge", low, high);
}

void drawInvitation(const Ui& ui, const ViewRectangle& view) {
  const char* text =
      ui.state.status().busy ? "Reading\u2026" : "Drop a model here, or press Ctrl+O";
  const ImVec2 size = ImGui::CalcTextSize(text);
  ImGui::GetWindowDrawList()->AddText({std::round((view.min.x + view.max.x - size.x) / 2),
                                       std::round((view.min.y + view.max.y - size.y) / 2)},
                                      ui.theme.palette.dim, text);
}

}  // namespace

void frameModel(AppState& state, const ViewRectangle& view, SceneMouse& mouse) {
  if (!state.view.pointsToFrame.empty()) {
    state.view.camera.frame(state.view.pointsToFrame, view.aspect(), 0.2);
    state.view.pointsToFrame.clear();
    moved(mouse);
  }
  const bool resized = mouse.framed && mouse.framedAspect != view.aspect();
  if (!state.hasMesh() || !(state.view.frameWhenLoaded || resized)) return;
  state.view.camera.frame(state.results().mesh->positions(), view.aspect());
  state.view.frameWhenLoaded = false;
  mouse.framed = true;
  mouse.framedAspect = view.aspect();
}

void sceneMouse(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse,
                const char* label) {
  ImGui::SetCursorScreenPos(view.min);
  ImGui::InvisibleButton(label, {view.max.x - view.min.x, view.max.y - view.min.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ui.probe.item(label);
  useMouse(ui, source, view, mouse);
  if (!mouse.pane.live()) return;
  seedMenu(ui, source, view, mouse);
  chartMenu(ui, mouse);
}

void scenePicture(const Ui& ui, SceneSource* source, const ViewRectangle& view,
                  const SceneMouse& mouse, float from, float to) {
  const double still = ImGui::GetTime() - mouse.movedAt;
  const bool moving = still < kSettleSeconds || ui.state.playback.playing() || ui.state.changing();
  if (still < kSettleSeconds) ui.wakeIn(kSettleSeconds - still);
  if (source == nullptr) return;
  const ImVec2 size{view.max.x - view.min.x, view.max.y - view.min.y};
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const ImTextureID picture =
      source->picture(ui.state, static_cast<int>(size.x * scale.x),
                      static_cast<int>(size.y * scale.y), ui.theme.scale, moving);
  ImGui::GetWindowDrawList()->AddImage(picture, {view.min.x + from * size.x, view.min.y},
                                       {view.min.x + to * size.x, view.max.y}, {from, 1}, {to, 0});
}

void scenePanel(const Ui& ui, SceneSource* source, SceneMouse& mouse) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (size.x < 8 || size.y < 8) return;
  const ViewRectangle view{low, {low.x + size.x, low.y + size.y}};
  frameModel(ui.state, view, mouse);
  mouse.pane = {};
  sceneMouse(ui, source, view, mouse, "view");
  scenePicture(ui, source, view, mouse);
  if (!ui.state.hasMesh()) return drawInvitation(ui, view);
  drawAxes(ui, view);
  drawMissing(ui, view);
  drawVisionBadge(ui, view);
  if (!ui.state.panels.firstCard) drawHint(ui, view);
}

}  // namespace chartflood
