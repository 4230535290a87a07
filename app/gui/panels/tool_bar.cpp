// The transport, the speed, the colour mode and the picture button, in one line.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/gui/panels/color_mode_combo.h"
#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr double kMaxShare = 0.96;  // the last part of the speed slider means "max"

double speedFraction(const Playback& playback) {
  const double speed = playback.speed();
  if (speed > Playback::kFastest) return 1;
  return kMaxShare * std::log(speed) / std::log(Playback::kFastest);
}

std::string speedLine(double fraction) {
  if (fraction >= kMaxShare) return "speed max";
  const double speed = std::pow(Playback::kFastest, fraction / kMaxShare);
  char text[48];
  std::snprintf(text, sizeof text, "speed %.0f", std::fmax(1.0, speed));
  return text;
}

std::string speedText(const Playback& playback) {
  const double speed = playback.speed();
  if (speed > Playback::kFastest) return "as fast as can be";
  return grouped(static_cast<std::size_t>(std::lround(speed))) + " faces/s";
}

void speedSlider(const Ui& ui, float width) {
  const Playback& playback = ui.state.playback;
  BarSlider slider;
  slider.label = "speed";
  slider.fraction = speedFraction(playback);
  slider.text = speedText(playback);
  slider.changed = false;
  slider.moved = [&](double fraction, bool) { ui.run(speedLine(fraction)); };
  slider.typed = [&](const std::string& text) { ui.run("speed " + text); };
  barSlider(ui, slider, width);
  tooltip(ui, "speed", "Speed",
          "Triangles played per second. At first a whole flood takes 3 seconds. Ctrl+click to type "
          "a number, \"auto\" or \"max\".");
}

void transport(const Ui& ui, float height) {
  const ImVec2 size{std::round(height * 1.15f), height};
  const float tight = ui.px(2);
  iconButton(ui, Icon::ToStart, "first", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::StepBack, "back", size);
  ImGui::SameLine(0, tight);
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  iconButton(ui, ui.state.playback.playing() ? Icon::Pause : Icon::Play, "play",
             {std::round(height * 1.7f), height});
  ImGui::PopStyleColor();
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::StepForward, "step", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::StepChart, "step-chart", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::StepMany, "step-many", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::ToEnd, "finish", size);
  ImGui::SameLine(0, ui.px(12));
  iconButton(ui, Icon::NextRound, "iteration", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::RunToEnd, "run", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::Stop, "stop", size);
}

}  // namespace

void toolBar(const Ui& ui) {
  const float height = ImGui::GetContentRegionAvail().y;
  const float frame = ImGui::GetFrameHeight();
  ImGui::PushStyleVar(
      ImGuiStyleVar_FramePadding,
      ImVec2(ui.px(8), ImGui::GetStyle().FramePadding.y + std::round((height - frame) / 2)));
  transport(ui, height);
  ImGui::SameLine(0, ui.px(16));
  const float end = ImGui::GetWindowContentRegionMax().x;
  const float camera = std::round(height * 1.15f), gap = ui.px(8);
  const float room = end - camera - 3 * gap - ImGui::GetCursorPosX();  // for slider and box
  const float combo = std::clamp(std::round(room * 0.55f), ui.px(110), ui.px(210));
  speedSlider(ui, std::clamp(room - combo, ui.px(70), ui.px(220)));
  ImGui::SameLine(end - combo - camera - gap);
  colorModeCombo(ui, combo);
  ImGui::SameLine(0, gap);
  iconButton(ui, Icon::Camera, "screenshot", {camera, height});
  ImGui::PopStyleVar();
}

}  // namespace chartflood
