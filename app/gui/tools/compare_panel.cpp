#include "app/gui/tools/compare_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/gui/panels/pane_caption.h"
#include "app/host/state/compare_look.h"

namespace chartflood {

namespace {

constexpr float kGrip = 12, kLeastHeight = 70;
constexpr float kMostOfHeight = 0.45f;  // that captions take from the views

/// Captions of all halves of a width, and the height that the tallest needs.
struct Captions {
  std::vector<CaptionLayout> each;
  float height = 0;
};

Captions layOutCaptions(const Ui& ui, const std::vector<ComparePane>& panes, std::size_t count,
                        ImVec2 area) {
  Captions captions;
  const float width = area.x / static_cast<float>(count) - ui.px(2);
  for (std::size_t i = 0; i < count; ++i) {
    captions.each.push_back(layOutCaption(ui, panes[i], width));
    captions.height = std::max(captions.height, captions.each.back().height);
  }
  captions.height = std::round(std::min(captions.height, kMostOfHeight * area.y));
  return captions;
}

void sideBySide(const Ui& ui, SceneSource* source, CompareMouse& mouse, ImVec2 low, ImVec2 high,
                const std::vector<ComparePane>& panes) {
  const float width = (high.x - low.x) / static_cast<float>(panes.size());
  const Captions captions =
      layOutCaptions(ui, panes, panes.size(), {high.x - low.x, high.y - low.y});
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const auto number = static_cast<float>(i);
    // The ground shows between them.
    const float left = std::round(low.x + number * width) + (i == 0 ? 0 : ui.px(1));
    const float right = std::round(low.x + (number + 1) * width) - ui.px(1);
    const ViewRectangle view{{left, low.y}, {right, high.y - captions.height}};
    SceneMouse& hand = mouse.sides[i];
    hand.pane = panes[i];
    if (panes[i] == ui.state.compare.active || i == 0) frameModel(ui.state, view, hand);
    SceneSource* side = source == nullptr ? nullptr : source->side(ui.state, panes[i]);
    sceneMouse(ui, side, view, hand, ("view/" + paneName(ui.state.compare, panes[i])).c_str());
    // Linked cameras move together, and so does their smoothing.
    SceneMouse moved = hand;
    moved.movedAt = mouse.movedAt();
    scenePicture(ui, side, view, moved);
    paneCaption(ui, panes[i], captions.each[i], {left, view.max.y}, {right, high.y});
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
  const Captions captions = layOutCaptions(ui, panes, 2, {high.x - low.x, high.y - low.y});
  const ViewRectangle view{low, {high.x, high.y - captions.height}};
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
  paneCaption(ui, panes[0], captions.each[0], {low.x, view.max.y}, {middle - ui.px(1), high.y});
  paneCaption(ui, panes[1], captions.each[1], {middle + ui.px(1), view.max.y}, high);
}

}  // namespace

void comparePanel(const Ui& ui, SceneSource* source, CompareMouse& mouse) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (size.x < 8 || size.y < ui.px(kLeastHeight)) return;
  const ImVec2 high{low.x + size.x, low.y + size.y};
  const std::vector<ComparePane> panes = ui.state.compare.panes();
  if (ui.state.compare.layout == Compare::Layout::Wipe) {
    wipe(ui, source, mouse, low, high, panes);
  } else {
    sideBySide(ui, source, mouse, low, high, panes);
  }
}

}  // namespace chartflood
