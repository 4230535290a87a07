#include "app/gui/tools/uv_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/tools/scene_panel.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr double kZoomPerNotch = 1.2;  // closer by this per notch
constexpr double kQuietSeconds = 0.3;  // shorter work shows no bar

/// The rectangle of the texture's picture.
struct UvRectangle {
  ImVec2 min, max;
  glm::dvec2 size() const { return {max.x - min.x, max.y - min.y}; }
  glm::dvec2 pixel(ImVec2 place) const { return {place.x - min.x, place.y - min.y}; }
  ImVec2 place(const glm::dvec2& pixel) const {
    return {min.x + static_cast<float>(pixel.x), min.y + static_cast<float>(pixel.y)};
  }
};

Pick pickAt(const Ui& ui, UvSource& source, const UvRectangle& view, ImVec2 place) {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return source.pick(ui.state, static_cast<int>((place.x - view.min.x) * scale.x),
                     static_cast<int>((place.y - view.min.y) * scale.y));
}

void drag(const Ui& ui, const UvRectangle& view, UvMouse& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
  mouse.travelled += std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y);
  if (mouse.travelled < kClickTravel) return;
  const ImVec2 from{io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y};
  ui.state.view.uvCamera.pan(view.pixel(from), view.pixel(io.MousePos), view.size());
  mouse.movedAt = ImGui::GetTime();
}

void click(const Ui& ui, UvSource& source, const UvRectangle& view) {
  const Pick pick = pickAt(ui, source, view, ImGui::GetIO().MousePos);
  ui.run(pick.chart == kNone ? "select-chart" : "select-chart " + std::to_string(pick.chart));
}

void chartMenu(const Ui& ui, const UvMouse& mouse) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(6)));
  if (ImGui::BeginPopup("texture menu")) {
    chartEntries(ui, mouse.menuChart);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void useMouse(const Ui& ui, UvSource& source, const UvRectangle& view, UvMouse& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated()) {
    mouse.button = io.MouseDown[0] ? 0 : io.MouseDown[1] ? 1 : 2;
    mouse.travelled = 0;
    GImGui->NavDisableHighlight = true;  // the keyboard belongs to the views again
  }
  if (ImGui::IsItemActive() && mouse.button >= 0) drag(ui, view, mouse);
  const bool doubleClicked = ImGui::IsItemHovered() && io.MouseDoubleClicked[0];
  if (ImGui::IsItemDeactivated()) {
    if (mouse.button == 0 && mouse.travelled < kClickTravel) click(ui, source, view);
    if (mouse.button == 1 && mouse.travelled < kClickTravel) {
      mouse.menuChart = pickAt(ui, source, view, io.MousePos).chart;
      if (mouse.menuChart != kNone) ImGui::OpenPopup("texture menu");
    }
    mouse.button = -1;
  }
  if (doubleClicked) ui.run("frame-uv");
  if (!ImGui::IsItemHovered()) return leaveUv(ui, mouse);
  ui.state.panels.uvUnderMouse = true;
  if (io.MouseWheel != 0) {
    const double notches = static_cast<double>(io.MouseWheel);
    const double steps = ui.state.preferences.invertZoom ? -notches : notches;
    ui.state.view.uvCamera.zoom(std::pow(kZoomPerNotch, steps), view.pixel(io.MousePos),
                                view.size());
    mouse.pickedAt = {-1, -1};
    mouse.movedAt = ImGui::GetTime();
  }
  const bool same = io.MousePos.x == mouse.pickedAt.x && io.MousePos.y == mouse.pickedAt.y;
  if (mouse.button >= 0 || same) return;
  mouse.pickedAt = io.MousePos;
  mouse.face = pickAt(ui, source, view, io.MousePos).face;
  ui.state.hoveredFace = mouse.face;
}

/// The newest picture, where the present camera has it.
void drawPicture(const Ui& ui, UvSource& source, const UvRectangle& view, UvMotion motion) {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const glm::dvec2 size = view.size();
  const UvPicture picture =
      source.picture(ui.state, static_cast<int>(size.x * double{scale.x}),
                     static_cast<int>(size.y * double{scale.y}), ui.theme.scale, motion);
  if (picture.texture == nullptr) return;
  const UvCamera& camera = ui.state.view.uvCamera;
  const glm::dvec2 taken(picture.width, picture.height);
  const ImVec2 low = view.place(camera.toPixel(picture.camera.toUv({0, 0}, taken), size));
  const ImVec2 high = view.place(camera.toPixel(picture.camera.toUv(taken, taken), size));
  // Islands of earlier charts step back until the new ones are there.
  const ImU32 tint = ui.state.results().flat ? IM_COL32_WHITE : IM_COL32(255, 255, 255, 90);
  ImGui::GetWindowDrawList()->AddImage(picture.texture, low, high, {0, 1}, {1, 0}, tint);
}

/// The border of the chart and the face that are pointed at, here or on the model.
void drawHighlight(const Ui& ui, const UvHighlight& highlight, const UvRectangle& view) {
  const UvCamera& camera = ui.state.view.uvCamera;
  const glm::dvec2 size = view.size();
  const auto place = [&](const glm::vec2& uv) {
    return view.place(camera.toPixel(glm::dvec2(uv), size));
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i + 2 < highlight.face.size(); i += 3) {
    list.AddTriangleFilled(place(highlight.face[i]), place(highlight.face[i + 1]),
                           place(highlight.face[i + 2]), IM_COL32(255, 255, 255, 150));
  }
  const std::pair<ImU32, float> strokes[] = {{IM_COL32(14, 14, 16, 255), 4.4f},
                                             {IM_COL32(250, 250, 247, 255), 2.4f}};
  for (const auto& [color, width] : strokes) {
    for (std::size_t i = 0; i + 1 < highlight.outline.size(); i += 2) {
      list.AddLine(place(highlight.outline[i]), place(highlight.outline[i + 1]), color,
                   ui.px(10 * width) / 10);
    }
  }
}

/// How far the work on the next islands is, over the old ones.
void drawWork(const Ui& ui, const UvRectangle& view) {
  const WorkStatus& status = ui.state.status();
  if (ui.state.results().flat || !status.busy || status.seconds < kQuietSeconds) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = std::round(0.4f * (view.max.x - view.min.x)), height = ui.px(6);
  const ImVec2 low{std::round((view.min.x + view.max.x - width) / 2),
                   std::round((view.min.y + view.max.y - height) / 2)};
  const ImVec2 high{low.x + width, low.y + height};
  list.AddRectFilled(low, high, ui.theme.palette.control, height / 2);
  list.AddRectFilled(low, {low.x + width * status.fraction, high.y}, ui.theme.palette.accent,
                     height / 2);
  const std::string words =
      std::string(*status.phase == '\0' ? "Working" : status.phase) + "\u2026";
  const float text = ImGui::CalcTextSize(words.c_str()).x;
  list.AddText({std::round((view.min.x + view.max.x - text) / 2),
                low.y - ImGui::GetTextLineHeight() - ui.px(6)},
               ui.theme.palette.text, words.c_str());
  ui.probe.rectangle("uv/work", low, high);
}

/// A line in the middle of the present window.
void centredText(const Ui& ui, const char* text) {
  const float width = ImGui::CalcTextSize(text).x;
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, std::round((room - width) / 2)));
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
}

/// What to do when nothing is laid flat yet. The button is there once the program can unwrap.
void drawMissing(const Ui& ui) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool can = ui.actions.find("unwrap") != nullptr;
  const std::string key = can ? ui.actions.shortcut("unwrap") : std::string();
  ImGui::Dummy({0, std::round(0.34f * room.y)});
  const WorkStatus& status = ui.state.status();
  if (status.busy && *status.phase != '\0') {
    return centredText(ui, (std::string(status.phase) + "\u2026").c_str());
  }
  centredText(ui, "The charts lie flat here once they are unwrapped.");
  if (!can) return;
  if (!key.empty()) centredText(ui, ("Press Unwrap (" + key + ")").c_str());
  ImGui::Dummy({0, ui.px(4)});
  const float width = std::min(ui.px(130), room.x);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::round((room.x - width) / 2));
  textButton(ui, "Unwrap", "unwrap", {width, ui.px(32)});
}

std::string figures(const AppState& state) {
  const Results& results = state.results();
  if (!results.atlas) return "";
  if (!results.flat) return state.changing() || state.status().busy ? "" : "Out of date: press W";
  const Index chart = state.hoveredChart();
  const double own = texelDensity(*results.atlas, *results.mesh, chart);
  const double density = own > 0 ? own : texelDensity(*results.atlas, *results.mesh);
  char text[128];
  std::snprintf(text, sizeof text, "%.0f %% used   %.4g px/unit%s", 100 * results.atlas->efficiency,
                density, own > 0 ? (" (chart " + std::to_string(chart) + ")").c_str() : "");
  return text;
}

/// The texture's figures at the bottom left and what the mouse does at the right of it.
void drawCaption(const Ui& ui, const UvRectangle& view) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.theme.small);
  const std::string left = figures(ui.state);
  const char* right = "Wheel: closer   Drag: move   F: all";
  const float y = view.max.y - ui.px(19), pad = ui.px(8);
  list.AddRectFilled({view.min.x, y - ui.px(5)}, view.max,
                     (ui.theme.palette.panel & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 235));
  list.AddText({view.min.x + pad, y}, ui.theme.palette.dim, left.c_str());
  const float used = ImGui::CalcTextSize(left.c_str()).x, width = ImGui::CalcTextSize(right).x;
  if (view.min.x + used + width + 4 * pad < view.max.x) {
    list.AddText({view.max.x - width - pad, y}, ui.theme.palette.dim, right);
  }
  ImGui::PopFont();
}

}  // namespace

void leaveUv(const Ui& ui, UvMouse& mouse) {
  // Unless the model is pointed at by now.
  if (mouse.face != kNone && ui.state.hoveredFace == mouse.face) ui.state.hoveredFace = kNone;
  mouse.face = kNone;
  mouse.pickedAt = {-1, -1};
}

void uvPanel(const Ui& ui, UvSource* source, UvMouse& mouse, bool elsewhere) {
  if (source == nullptr || !source->ready(ui.state)) {
    leaveUv(ui, mouse);
    return drawMissing(ui);
  }
  const ImVec2 low = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (size.x < 8 || size.y < 8) return leaveUv(ui, mouse);
  const UvRectangle view{low, {low.x + size.x, low.y + size.y}};
  ImGui::InvisibleButton("uv", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ui.probe.item("uv");
  useMouse(ui, *source, view, mouse);
  chartMenu(ui, mouse);
  const double still = ImGui::GetTime() - mouse.movedAt;
  if (still < kSettleSeconds) ui.wakeIn(kSettleSeconds - still);
  const bool busy = elsewhere || ui.state.playback.playing() || ui.state.status().busy;
  const UvMotion motion = still < kSettleSeconds ? UvMotion::Own
                          : busy                 ? UvMotion::Elsewhere
                                                 : UvMotion::None;
  ImGui::PushClipRect(view.min, view.max, true);
  drawPicture(ui, *source, view, motion);
  if (ui.state.results().flat) drawHighlight(ui, source->highlight(ui.state), view);
  drawWork(ui, view);
  ImGui::PopClipRect();
  drawCaption(ui, view);
}

}  // namespace chartflood
