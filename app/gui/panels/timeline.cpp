// The strip of rounds (one bar each, its height the imbalance) and the scrubber over the present
// flood's record.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"

namespace chartflood {

namespace {

/// A heading and its figure behind it, in one line of the given width.
void caption(const Ui& ui, const char* title, const std::string& figure, float width) {
  ImGui::PushFont(ui.theme.strong);
  ImGui::TextUnformatted(title);
  const float used = ImGui::CalcTextSize(title).x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::PopFont();
  ImGui::SameLine();
  fittedText(ui, figure, width - used, ui.theme.palette.dim);
}

std::string percent(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * value);
  return text;
}

double worstBalance(const Results& results) {
  double worst = 1e-9;
  for (const IterationSummary& round : results.history) worst = std::max(worst, round.stdOverMean);
  return worst;
}

void roundTooltip(const Ui& ui, const IterationSummary& round, bool best) {
  std::string text = "Spread " + percent(round.stdOverMean) + ", " +
                     std::to_string(round.movedSeeds) + " seeds moved";
  if (best) text += "\nBest so far";
  tooltip(ui, "round " + std::to_string(round.iteration + 1),
          "Round " + std::to_string(round.iteration + 1), text + "\nDouble-click to use it.");
}

void roundStrip(const Ui& ui, float width, float height) {
  const Results& results = ui.state.results();
  const Palette& p = ui.theme.palette;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##rounds", {width, height});
  ui.probe.item("rounds");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, p.bar, ui.px(3));
  const std::size_t rounds = results.history.size();
  if (rounds == 0) return;
  const float step = std::min(ui.px(16), width / static_cast<float>(rounds));
  const double worst = worstBalance(results);
  const float mouse = ImGui::GetIO().MousePos.x - low.x;
  const bool hovered = ImGui::IsItemHovered();
  for (std::size_t i = 0; i < rounds; ++i) {
    const IterationSummary& round = results.history[i];
    const float x = low.x + static_cast<float>(i) * step;
    const float full = height - ui.px(8);
    const float bar = std::max(ui.px(2), full * static_cast<float>(round.stdOverMean / worst));
    const bool best = i == results.bestIteration;
    const bool under = hovered && mouse >= static_cast<float>(i) * step &&
                       mouse < static_cast<float>(i + 1) * step;
    const ImU32 color = under ? p.text : best ? p.front : p.accent;
    const float gap = step > 4 ? 1.0f : 0.0f;
    list.AddRectFilled({x + gap, low.y + height - bar}, {x + step - gap, low.y + height}, color,
                       step > 6 ? 2.0f : 0.0f);
    if (under) roundTooltip(ui, round, best);
    if (under && ImGui::IsMouseDoubleClicked(0)) ui.run("adopt " + std::to_string(i + 1));
  }
}

void scrubber(const Ui& ui, float width, float height) {
  const Playback& playback = ui.state.playback;
  const Palette& p = ui.theme.palette;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##scrubber", {width, height});
  ui.probe.item("scrubber");
  const bool active = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = low.y + height / 2;
  const float half = ui.px(5);
  const auto capacity = static_cast<double>(std::max<std::size_t>(1, playback.capacity()));
  const auto place = [&](std::size_t count) {
    return low.x + width * static_cast<float>(static_cast<double>(count) / capacity);
  };
  const float played = place(playback.playhead()), recorded = place(playback.recorded());
  list.AddRectFilled({low.x, middle - half}, {low.x + width, middle + half}, p.bar, half);
  list.AddRectFilled({low.x, middle - half}, {std::max(recorded, low.x), middle + half}, p.control,
                     half);
  if (played - low.x > 1) {
    list.AddRectFilled({low.x, middle - half}, {played, middle + half}, p.accent, half);
  }
  const float knobX = std::clamp(played, low.x + half, low.x + width - half);
  const bool hot = active || ImGui::IsItemHovered();
  list.AddCircleFilled({knobX, middle}, ui.px(hot ? 9.0f : 8.0f), p.text);
  list.AddCircleFilled({knobX, middle}, ui.px(hot ? 6.5f : 5.5f), p.accentSoft);
  if (active && playback.recorded() > 0) {
    const double share =
        std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - low.x) / width), 0.0, 1.0);
    const auto count =
        std::min(playback.recorded(), static_cast<std::size_t>(std::lround(share * capacity)));
    if (count != playback.playhead()) ui.run("seek " + std::to_string(count));
  }
  tooltip(ui, "scrubber", "Flood", "Drag to any moment of this flood. Nothing is computed again.");
}

std::string roundFigure(const Results& results) {
  const std::size_t rounds = results.history.size();
  if (rounds == 0) return "none finished";
  const IterationSummary& best = results.history[results.bestIteration];
  return std::to_string(rounds) + " of at most " +
         std::to_string(results.parameters.maxIterations) + "   best " +
         std::to_string(results.bestIteration + 1) + " with spread " + percent(best.stdOverMean) +
         (results.segmentation && results.segmentation->refined ? " before tidying" : "");
}

}  // namespace

void timeline(const Ui& ui) {
  const Playback& playback = ui.state.playback;
  const float width = ImGui::GetContentRegionAvail().x;
  const float gap = ui.px(24);
  const float left = std::round((width - gap) * 0.42f), right = width - gap - left;
  const float height = ImGui::GetContentRegionAvail().y - ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginGroup();
  caption(ui, "Rounds", roundFigure(ui.state.results()), left);
  roundStrip(ui, left, height);
  ImGui::EndGroup();
  ImGui::SameLine(0, gap);
  ImGui::BeginGroup();
  caption(ui, "Flood",
          grouped(playback.playhead()) + " of " + grouped(playback.capacity()) + " faces", right);
  scrubber(ui, right, height);
  ImGui::EndGroup();
}

}  // namespace chartflood
