// Overlays, colour map and camera; texture and checkerboard.

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/script/command.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

/// Switches in two columns.
void switches(const Ui& ui, std::span<const char* const> lines) {
  const float half = ImGui::GetContentRegionAvail().x / 2;
  const float left = ImGui::GetCursorPosX();
  int column = 0;
  for (const char* line : lines) {
    if (column == 1) {
      ImGui::SameLine();
      ImGui::SetCursorPosX(left + half);
    }
    column = 1 - column;
    switchRow(ui, ui.actions.find(line)->title.c_str(), ui.actions.checked(line, ui.state), line);
  }
}

void colorMapRow(const Ui& ui) {
  const RenderSettings& settings = ui.state.view.render;
  const ColorMap* chosen = findColorMap(settings.colorMap);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Colour map");
  ImGui::SameLine(std::round(ImGui::GetWindowContentRegionMax().x * 0.5f));
  ImGui::SetNextItemWidth(-1);
  const bool open =
      ImGui::BeginCombo("##colormap", chosen == nullptr ? "Automatic" : chosen->label);
  ui.probe.item("colormap");
  if (!open) return;
  if (ImGui::Selectable("Automatic", chosen == nullptr)) ui.run("colormap auto");
  for (const ColorMap& map : colorMapTable()) {
    if (ImGui::Selectable(map.label, &map == chosen)) ui.run(std::string("colormap ") + map.id);
    if (!map.colorBlindSafe) {
      tooltip(ui, map.id, "", "Not readable with every kind of colour vision.");
    }
  }
  ImGui::EndCombo();
}

void checkerKindRow(const Ui& ui) {
  struct Kind {
    CheckerKind kind;
    const char* words;
  };
  static constexpr Kind kKinds[] = {{CheckerKind::Squares, "Squares"},
                                    {CheckerKind::Numbers, "Numbered"},
                                    {CheckerKind::Circles, "Circles"},
                                    {CheckerKind::Picture, "Picture"}};
  const CheckerKind present = ui.state.view.render.checkerKind;
  rowLabel("Checkerboard", 0.5f);
  ImGui::SetNextItemWidth(-1);
  const bool open =
      ImGui::BeginCombo("##checker-kind", kKinds[static_cast<std::size_t>(present)].words);
  ui.probe.item("checker-kind");
  if (!open) return tooltip(ui, "checker-kind", "", ui.actions.find("checker-kind")->help);
  for (const Kind& each : kKinds) {
    if (each.kind == CheckerKind::Picture && !ui.state.view.render.checkerPicture) continue;
    const std::string line = std::string("checker-kind ") + checkerKindId(each.kind);
    if (ImGui::Selectable(each.words, each.kind == present)) ui.run(line);
    ui.probe.item(line);
  }
  ImGui::EndCombo();
}

void pictureRepeatsRow(const Ui& ui) {
  constexpr double kMost = 16;  // of the slider; more can be typed
  const double repeats = double{ui.state.view.render.checkerRepeats};
  BarSlider slider;
  slider.label = "checker-repeats";
  slider.fraction = std::clamp((repeats - 1) / (kMost - 1), 0.0, 1.0);
  slider.text = std::to_string(std::lround(repeats));
  slider.changed = repeats != 1;
  const auto set = [&](double fraction) {
    const double wanted = 1 + (kMost - 1) * std::clamp(fraction, 0.0, 1.0);
    ui.run("checker-repeats " + std::to_string(std::lround(wanted)));
  };
  slider.moved = [&](double fraction, bool) { set(fraction); };
  slider.typed = [&](const std::string& text) {
    ui.run("checker-repeats " + quotedArgument(text));
  };
  slider.nudged = [&](int direction) { set(slider.fraction + direction / (kMost - 1)); };
  rowLabel("Pictures on the texture", 0.5f);
  barSlider(ui, slider, ImGui::GetContentRegionAvail().x);
  tooltip(ui, "checker-repeats", "Pictures", ui.actions.find("checker-repeats")->help);
}

void checkerSizeRow(const Ui& ui) {
  const RenderSettings& present = ui.state.view.render;
  if (present.checkerKind == CheckerKind::Picture && present.checkerPicture) {
    return pictureRepeatsRow(ui);
  }
  constexpr double kFewest = 4, kMost = 256;  // of the slider; more can be typed
  const RenderSettings& settings = ui.state.view.render;
  const double squares = double{settings.checkerSquares};
  BarSlider slider;
  slider.label = "checker-size";
  slider.fraction = std::clamp(std::log(squares / kFewest) / std::log(kMost / kFewest), 0.0, 1.0);
  slider.text = std::to_string(std::lround(squares));
  slider.changed = settings.checkerSquares != RenderSettings{}.checkerSquares;
  const auto set = [&](double fraction) {
    const double wanted = kFewest * std::pow(kMost / kFewest, std::clamp(fraction, 0.0, 1.0));
    ui.run("checker-size " + std::to_string(std::lround(wanted)));
  };
  slider.moved = [&](double fraction, bool) { set(fraction); };
  slider.typed = [&](const std::string& text) { ui.run("checker-size " + quotedArgument(text)); };
  slider.nudged = [&](int direction) { set(slider.fraction + 0.02 * direction); };
  rowLabel(settings.checkerInTexture ? "Squares on the texture" : "Squares on the model", 0.5f);
  barSlider(ui, slider, ImGui::GetContentRegionAvail().x);
  tooltip(ui, "checker-size", "Squares", ui.actions.find("checker-size")->help);
}

}  // namespace

void viewPanel(const Ui& ui) {
  static constexpr const char* kOverlays[] = {"seams",        "cuts",        "seeds",     "numbers",
                                              "edges",        "sharp-edges", "color-bar", "smooth",
                                              "orthographic", "isolate",     "problems"};
  static constexpr const char* kTexture[] = {"checker-in-texture", "checker-tint", "uv-fill",
                                             "uv-frame"};
  if (section(ui, "View")) {
    switches(ui, kOverlays);
    colorMapRow(ui);
  }
  if (section(ui, "Texture")) {
    checkerKindRow(ui);
    checkerSizeRow(ui);
    switches(ui, kTexture);
  }
}

}  // namespace chartflood
