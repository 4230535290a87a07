#include "app/gui/panels/compare_panel.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/gui/widgets.h"
#include "app/host/compare_look.h"

namespace chartflood {

namespace {

constexpr float kCaptionHeight = 62, kGrip = 12;

/// The letter on a plate, so that it is found at once.
void badge(const Ui& ui, const std::string& name) {
  const ImVec2 text = ImGui::CalcTextSize(name.c_str());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float pad = ui.px(5);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + text.x + 2 * pad, at.y + text.y}, ui.theme.palette.accentSoft,
                     ui.px(3));
  list.AddText({at.x + pad, at.y}, ui.theme.palette.text, name.c_str());
  ImGui::Dummy({text.x + 2 * pad, text.y});
}

/// What stands under a half, between two corners.
void caption(const Ui& ui, ComparePane pane, ImVec2 low, ImVec2 high) {
  const PaneCaption words = paneCaption(ui.state, pane);
  const std::string name = paneName(ui.state.compare, pane);
  const float pad = ui.px(8), button = pane.live() ? 0 : ui.px(64);
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, ui.theme.palette.panel);
  ImGui::SetCursorScreenPos({low.x + pad, low.y + ui.px(6)});
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), ui.px(1)));
  const float room = high.x - low.x - 2 * pad;
  badge(ui, name);
  ImGui::SameLine();
  ImGui::PushFont(ui.theme.strong);
  const float used = ImGui::GetCursorScreenPos().x - low.x - pad;
  fittedText(ui, words.heading, room - button - used, ui.theme.palette.text);
  ImGui::PopFont();
  // Below the button, over the whole width.
  ImGui::SetCursorScreenPos({low.x + pad, low.y + ui.px(29)});
  ImGui::PushFont(ui.theme.small);
  fittedText(ui, words.figures, room, ui.theme.palette.text);
  fittedText(ui, words.differing, room, ui.theme.palette.dim);
  ImGui::PopFont();
  ImGui::PopStyleVar();
  ImGui::EndGroup();
  ui.probe.item("caption/" + name);
  if (pane.live()) return;
  ImGui::SetCursorScreenPos({high.x - pad - button + ui.px(8), low.y + ui.px(3)});
  textButton(ui, ("Use " + name).c_str(), "use " + name, {button - ui.px(8), ui.px(24)});
}

void sideBySide(const Ui& ui, SceneSource* source, CompareMouse& mouse, ImVec2 low, ImVec2 high,
                const std::vector<ComparePane>& panes) {
  const float width = (high.x - low.x) / static_cast<float>(panes.size());
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const auto number = static_cast<float>(i);
    // The ground shows between them.
    const float left = std::round(low.x + number * width) + (i == 0 ? 0 : ui.px(1));
    const float right = std::round(low.x + (number + 1) * width) - ui.px(1);
    const ViewRectangle view{{left, low.y}, {right, high.y - ui.px(kCaptionHeight)}};
    SceneMouse& hand = mouse.sides[i];
    hand.pane = panes[i];
    if (panes[i] == ui.state.compare.active || i == 0) frameModel(ui.state, view, hand);
    SceneSource* side = source == nullptr ? nullptr : source->side(ui.state, panes[i]);
    sceneMouse(ui, side, view, hand, ("view/" + paneName(ui.state.compare, panes[i])).c_str());
    // Linked cameras move together, and so does their smoothing.
    SceneMouse moved = hand;
    moved.movedAt = mouse.movedAt();
    scenePicture(ui, side, view, moved);
    caption(ui, panes[i], {left, view.max.y}, {right, high.y});
  }
}

/// The line that is dragged; first of all, so that it lies over the halves for the mouse.
void wipeGrip(const Ui& ui, const ViewRectangle& view, float line) {
  ImGui::SetCursorScreenPos({line - ui.px(kGrip) / 2, view.min.y});
  ImGui::InvisibleButton("wipe", {ui.px(kGrip), view.max.y - view.min.y});
  ui.probe.item("wipe-line");
  const bool held = ImGui::IsItemActive();
  if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (!held || ImGui::GetIO().MouseDelta.x == 0) return;
  const float share = (ImGui::GetIO().MousePos.x - view.min.x) / (view.max.x - view.min.x);
  char text[48];
  std::snprintf(text, sizeof text, "wipe-at %.4f",
                std::clamp(static_cast<double>(share), 0.02, 0.98));
  ui.run(text);
}

void drawWipeLine(const Ui& ui, const ViewRectangle& view, float line) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = std::round((view.min.y + view.max.y) / 2), size = ui.px(7);
  list.AddRectFilled({line - ui.px(1) - 1, view.min.y}, {line + ui.px(1) + 1, view.max.y},
                     IM_COL32(0, 0, 0, 160));
  list.AddRectFilled({line - 1, view.min.y}, {line + 1, view.max.y}, ui.theme.palette.text);
  list.AddCircleFilled({line, middle}, ui.px(13), ui.theme.palette.bar);
  list.AddCircle({line, middle}, ui.px(13), ui.theme.palette.text, 0, ui.px(1));
  for (const float side : {-1.0f, 1.0f}) {
    const float x = line + side * ui.px(3);
    list.AddTriangleFilled({x, middle - size / 2 - 1}, {x, middle + size / 2 + 1},
                           {x + side * size, middle}, ui.theme.palette.text);
  }
}

void wipe(const Ui& ui, SceneSource* source, CompareMouse& mouse, ImVec2 low, ImVec2 high,
          const std::vector<ComparePane>& panes) {
  const ViewRectangle view{low, {high.x, high.y - ui.px(kCaptionHeight)}};
  const auto share = static_cast<float>(ui.state.compare.wipe);
  const float line = std::round(low.x + share * (view.max.x - view.min.x));
  wipeGrip(ui, view, line);
  frameModel(ui.state, view, mouse.sides[0]);

  for (std::size_t i = 0; i < 2; ++i) {
    SceneMouse& hand = mouse.sides[i];
    hand.pane = panes[i];
    SceneSource* side = source == nullptr ? nullptr : source->side(ui.state, panes[i]);
    const float from = i == 0 ? 0 : (line - low.x) / (view.max.x - view.min.x);
    const float to = i == 0 ? (line - low.x) / (view.max.x - view.min.x) : 1;
    // Only the half under the mouse may take it; one that holds a button keeps it.
    ImGui::PushClipRect({low.x + from * (view.max.x - view.min.x), low.y},
                        {low.x + to * (view.max.x - view.min.x), view.max.y}, true);
    sceneMouse(ui, side, view, hand, ("view/" + paneName(ui.state.compare, panes[i])).c_str());
    ImGui::PopClipRect();
    SceneMouse moved = hand;
    moved.movedAt = mouse.movedAt();
    scenePicture(ui, side, view, moved, from, to);
  }
  drawWipeLine(ui, view, line);
  const float middle = std::round((low.x + high.x) / 2);
  caption(ui, panes[0], {low.x, view.max.y}, {middle - ui.px(1), high.y});
  caption(ui, panes[1], {middle + ui.px(1), view.max.y}, high);
}

}  // namespace

void comparePanel(const Ui& ui, SceneSource* source, CompareMouse& mouse) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (size.x < 8 || size.y < ui.px(kCaptionHeight) + 8) return;
  const ImVec2 high{low.x + size.x, low.y + size.y};
  const std::vector<ComparePane> panes = ui.state.compare.panes();
  if (ui.state.compare.layout == Compare::Layout::Wipe) {
    wipe(ui, source, mouse, low, high, panes);
  } else {
    sideBySide(ui, source, mouse, low, high, panes);
  }
}

}  // namespace chartflood
