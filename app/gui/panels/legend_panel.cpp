// The legend of the colours: the bar in the picture can be clicked, and opens an editor beside it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <string>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/script/command.h"
#include "render/scene/color_map.h"
#include "render/scene/scalar_range.h"

namespace chartflood {

namespace {

constexpr float kEditorWidth = 320;

constexpr ImGuiWindowFlags kFloating = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing;

/// Whether pictures carry a scale of colours now.
bool hasBar(const AppState& state) {
  const RenderSettings& render = state.view.render;
  if (!state.hasMesh() || state.film.ready() || *colorModeInfo(render.colorMode).colorMap == '\0') {
    return false;
  }
  return !needsUnwrap(render.colorMode) || state.results().atlas;
}

/// The range as it is shown, once it is known; none where each kind of element has its own.
std::optional<ScalarRange> shownRange(const Ui& ui) {
  const AppState& state = ui.state;
  const auto plots = state.insight().histograms(
      state.results(), {state.shownStats(), state.playback.record(), state.playback.playhead()},
      state.view.render);
  if (!plots || plots->size() != 1) return std::nullopt;
  return plots->front().range;
}

/// The label of a row; the control follows in the right part.
void gradient(const ColorMap& map, bool inverted, ImVec2 low, ImVec2 size) {
  constexpr int kPieces = 24;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int i = 0; i < kPieces; ++i) {
    const float t = (static_cast<float>(i) + 0.5f) / kPieces;
    const glm::vec3 c = map.at(inverted ? 1 - t : t);
    const float from = std::round(low.x + size.x * static_cast<float>(i) / kPieces);
    const float to = std::round(low.x + size.x * static_cast<float>(i + 1) / kPieces);
    list.AddRectFilled({from, low.y}, {to, low.y + size.y},
                       ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1}));
  }
}

/// A map that can be chosen: its colours, then its name.
void mapEntry(const Ui& ui, const ColorMap& map, const std::string& line, const char* words) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float strip = ui.px(64), height = ImGui::GetTextLineHeight();
  const std::string label = "##" + line;
  if (ImGui::Selectable(label.c_str(), ui.actions.checked(line, ui.state))) ui.run(line);
  ui.probe.item("legend/" + line);
  if (!map.colorBlindSafe) {
    tooltip(ui, line, "", "Not readable with every kind of colour vision.");
  }
  gradient(map, ui.state.view.render.invertColorMap, {low.x, low.y + ui.px(2)},
           {strip, height - ui.px(4)});
  ImGui::GetWindowDrawList()->AddText({low.x + strip + ui.px(8), low.y}, ui.theme.palette.text,
                                      words);
}

void mapRow(const Ui& ui) {
  const RenderSettings& render = ui.state.view.render;
  const ColorMap* own = findColorMap(colorModeInfo(render.colorMode).colorMap);
  const ColorMap* chosen = findColorMap(render.colorMap);
  rowLabel("Colours", 0.34f);
  ImGui::SetNextItemWidth(-1);
  const bool open =
      ImGui::BeginCombo("##legend-map", chosen == nullptr ? "Automatic" : chosen->label);
  ui.probe.item("legend/colormap");
  if (!open) return;
  if (own != nullptr) mapEntry(ui, *own, "colormap auto", "Automatic");
  for (const ColorMap& map : colorMapTable()) {
    mapEntry(ui, map, std::string("colormap ") + map.id, map.label);
  }
  ImGui::EndCombo();
}

/// Alternatives side by side over the rest of the line.
struct Alternative {
  const char *words, *line;
};
void alternatives(const Ui& ui, std::span<const Alternative> list) {
  const float gap = ui.px(2);
  const auto count = static_cast<float>(list.size());
  const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    const bool chosen = ui.actions.checked(list[i].line, ui.state);
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
    textButton(ui, list[i].words, list[i].line, {width, 0});
    if (chosen) ImGui::PopStyleColor();
  }
}

std::string numberText(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.5g", value);
  return text.data();
}

/// A field that takes a number when Enter is pressed or it is left.
template <typename Take>
void numberField(const Ui& ui, const char* label, double value, float width, Take take) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%s", numberText(value).c_str());
  ImGui::SetNextItemWidth(width);
  const std::string id = std::string("##") + label;
  const bool entered =
      ImGui::InputText(id.c_str(), text.data(), text.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.probe.item(label);
  if (entered || ImGui::IsItemDeactivatedAfterEdit()) take(std::string(text.data()));
}

void rangeRows(const Ui& ui) {
  const RenderSettings& render = ui.state.view.render;
  const std::optional<ScalarRange> range = shownRange(ui);
  const std::string hold =
      range ? "legend-range " + numberText(range->min) + ' ' + numberText(range->max) : "";
  rowLabel("Range", 0.34f);
  const float gap = ui.px(2);
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const auto button = [&](const char* words, const std::string& line, bool chosen) {
    if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
    textButton(ui, words, line, {half, 0});
    if (chosen) ImGui::PopStyleColor();
  };
  button("Automatic", "legend-range auto", !render.range);
  ui.probe.item("legend/auto");
  ImGui::SameLine(0, gap);
  button("Fixed", hold.empty() ? "legend-range 0 1" : hold, render.range.has_value());
  ui.probe.item("legend/fixed");
  if (!range) return;
  rowLabel("From, to", 0.34f);
  const double low = render.range ? render.range->first : range->min;
  const double high = render.range ? render.range->second : range->max;
  const auto set = [&](const std::string& from, const std::string& to) {
    ui.run("legend-range " + quotedArgument(from) + ' ' + quotedArgument(to));
  };
  numberField(ui, "legend/low", low, half,
              [&](const std::string& text) { set(text, numberText(high)); });
  ImGui::SameLine(0, gap);
  numberField(ui, "legend/high", high, half,
              [&](const std::string& text) { set(numberText(low), text); });
}

void stepsRow(const Ui& ui) {
  const int steps = ui.state.view.render.colorSteps;
  BarSlider slider;
  slider.label = "legend/steps";
  slider.fraction = steps == 0 ? 0 : std::min((steps - 1) / 15.0, 1.0);
  slider.text = steps == 0 ? "smooth" : std::to_string(steps);
  slider.changed = steps != 0;
  const auto set = [&](double fraction) {
    const long wanted = std::lround(std::clamp(fraction, 0.0, 1.0) * 15) + 1;
    ui.run("legend-steps " + std::to_string(wanted < 2 ? 0 : wanted));
  };
  slider.moved = [&](double fraction, bool) { set(fraction); };
  slider.typed = [&](const std::string& text) { ui.run("legend-steps " + quotedArgument(text)); };
  slider.nudged = [&](int direction) { set(slider.fraction + direction / 15.0); };
  rowLabel("Steps", 0.34f);
  barSlider(ui, slider, ImGui::GetContentRegionAvail().x);
  tooltip(ui, "legend/steps", "Steps", ui.actions.find("legend-steps")->help);
}

void switches(const Ui& ui) {
  const float left = ImGui::GetCursorPosX(), half = ImGui::GetContentRegionAvail().x / 2;
  switchRow(ui, "Invert", ui.state.view.render.invertColorMap, "invert-colors");
  ImGui::SameLine();
  ImGui::SetCursorPosX(left + half);
  switchRow(ui, "Clamp to the ends", ui.state.view.render.clampColors, "legend-clamp");
  if (ui.state.compare.showing()) {
    switchRow(ui, "One range for all halves", ui.state.compare.linkRange, "link-range");
  }
}

void editor(const Ui& ui) {
  const ColorModeInfo& info = colorModeInfo(ui.state.view.render.colorMode);
  ImGui::PushFont(ui.theme.strong);
  fittedText(ui,
             std::string(info.title) + (*info.unit == '\0' ? "" : std::string(", ") + info.unit),
             ImGui::GetContentRegionAvail().x, ui.theme.palette.text);
  ImGui::PopFont();
  mapRow(ui);
  rangeRows(ui);
  rowLabel("Scale", 0.34f);
  static constexpr Alternative kScales[] = {{"auto", "legend-scale auto"},
                                            {"linear", "legend-scale linear"},
                                            {"root", "legend-scale root"},
                                            {"log", "legend-scale log"}};
  alternatives(ui, kScales);
  stepsRow(ui);
  switches(ui);
  const float half = (ImGui::GetContentRegionAvail().x - ui.px(4)) / 2;
  textButton(ui, "Reset", "legend-reset", {half, 0});
  ImGui::SameLine(0, ui.px(4));
  textButton(ui, "Close", "legend off", {half, 0});
}

/// What the mouse can click on: the bar with its numbers.
void handle(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax) {
  const float height = scalarBarHeight(areaMax.y - areaMin.y, ui.theme.scale) + ui.px(44);
  const float width = std::min(ui.px(kScalarBarWidth), (areaMax.x - areaMin.x) / 2);
  ImGui::SetNextWindowPos({areaMax.x - width, areaMax.y - height});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::Begin("legend", nullptr, kFloating | ImGuiWindowFlags_NoBackground);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("legend", {width, height});
  ui.probe.item("legend");
  tooltip(ui, "legend", "Legend   " + ui.actions.shortcut("legend"),
          "A click opens range, scale and colours.");
  if (ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::GetWindowDrawList()->AddRect({low.x + 1, low.y + 1},
                                        {low.x + width - ui.px(2), low.y + height - ui.px(2)},
                                        ui.theme.palette.dim, ui.px(5));
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  if (clicked) ui.run("legend");
}

}  // namespace

void legendPanel(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax) {
  if (!hasBar(ui.state)) return;
  if (ui.state.view.render.scalarBar) handle(ui, areaMin, areaMax);
  if (!ui.state.panels.legend) return;
  const float width = std::min(ui.px(kEditorWidth), ImGui::GetIO().DisplaySize.x - ui.px(20));
  const float right = std::max(areaMax.x - ui.px(kScalarBarWidth + 6), width + ui.px(8));
  ImGui::SetNextWindowPos({right, areaMax.y - ui.px(12)}, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.popup);
  ImGui::Begin("legend editor", nullptr, kFloating);
  editor(ui);
  const ImVec2 low = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
  ui.probe.rectangle("legend-editor", low, {low.x + extent.x, low.y + extent.y});
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace chartflood
