// The strip of rounds (one bar each, its height the imbalance) and the scrubber over the flood of
// the round shown, or over the refinement of borders that follows.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"

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
          "Round " + std::to_string(round.iteration + 1),
          text + "\nClick or drag to look at it, double-click to use it.");
}

/// Where the rounds stand in the strip: a cell each, and one for the finished charts.
struct Cells {
  ImVec2 low;
  float height = 0, step = 0;
  std::size_t count = 0;

  float left(std::size_t cell) const { return low.x + static_cast<float>(cell) * step; }
  std::size_t under(float x) const {
    const float cell = std::floor((x - low.x) / std::max(step, 1e-3f));
    return static_cast<std::size_t>(std::clamp(cell, 0.0f, static_cast<float>(count - 1)));
  }
};

/// The moment within what the scrubber goes through: steps, those there are, and all to come.
struct Reel {
  const char* title;
  std::size_t step = 0, recorded = 0, capacity = 0;
  const char* action;  ///< goes to a step
  const char* help;

  double share(std::size_t count) const {
    return capacity == 0 ? 0 : static_cast<double>(count) / static_cast<double>(capacity);
  }
};

Reel reelOf(const Playback& playback) {
  if (playback.showsBorders()) {
    const std::size_t steps = playback.borderSteps();
    return {"Borders",
            playback.borderStep(),
            steps,
            steps,
            "go-to-border",
            "After the last round the borders of the kept one are laid anew, pair by pair of "
            "charts. Drag to any of these steps."};
  }
  return {"Flood",
          playback.playhead(),
          playback.recorded(),
          playback.capacity(),
          "seek",
          "Drag to any moment of this flood. Nothing is computed again."};
}

/// True when the last cell is shown: the refinement of borders or the finished charts.
bool behindFloods(const Playback& playback) { return playback.atFinal() || playback.inBorders(); }

/// The frame round the cell that is shown, and a tick at the moment within it.
void momentMark(const Ui& ui, const Cells& cells) {
  const Playback& playback = ui.state.playback;
  const Palette& p = ui.theme.palette;
  const std::size_t cell = behindFloods(playback) ? playback.rounds() : playback.round();
  const float left = cells.left(cell), right = left + cells.step;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRect({left, cells.low.y}, {right, cells.low.y + cells.height}, p.text, ui.px(2), 0,
               ui.px(1.5f));
  const Reel reel = reelOf(playback);
  if (playback.atFinal() || reel.capacity == 0) return;
  const float x = left + static_cast<float>(reel.share(reel.step)) * cells.step, size = ui.px(4);
  list.AddTriangleFilled({x - size, cells.low.y}, {x + size, cells.low.y},
                         {x, cells.low.y + 1.4f * size}, p.text);
}

/// A flag: the finished charts.
void finalCell(const Ui& ui, const Cells& cells) {
  const float x = std::round((cells.left(cells.count - 1) + cells.left(cells.count)) / 2);
  const float y = cells.low.y + cells.height / 2, r = std::min(ui.px(5), 0.35f * cells.step);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddQuadFilled({x, y - r}, {x + r, y}, {x, y + r}, {x - r, y}, ui.theme.palette.front);
}

/// Goes to the round under the mouse while the button is down; double-click uses it.
void dragRounds(const Ui& ui, const Cells& cells, std::size_t rounds) {
  const Playback& playback = ui.state.playback;
  const std::size_t cell = cells.under(ImGui::GetIO().MousePos.x);
  const std::size_t shown = behindFloods(playback) ? playback.rounds() : playback.round();
  if (ImGui::IsMouseDoubleClicked(0) && ImGui::IsItemHovered() && cell < rounds) {
    return ui.run("adopt " + std::to_string(cell + 1));
  }
  if (!ImGui::IsItemActive() || cell == shown) return;
  ui.run(cell >= playback.rounds() ? std::string("run-end")
                                   : "go-to-round " + std::to_string(cell + 1));
}

void roundStrip(const Ui& ui, float width, float height) {
  const Results& results = ui.state.results();
  const Playback& playback = ui.state.playback;
  const Palette& p = ui.theme.palette;
  Cells cells{ImGui::GetCursorScreenPos(), height};
  ImGui::InvisibleButton("##rounds", {width, height});
  ui.probe.item("rounds");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(cells.low, {cells.low.x + width, cells.low.y + height}, p.bar, ui.px(3));
  const std::size_t rounds = results.history.size();
  cells.count = playback.rounds() + (playback.hasFinal() ? 1 : 0);
  if (cells.count == 0) return;
  cells.step = std::min(ui.px(16), width / static_cast<float>(cells.count));
  const double worst = worstBalance(results);
  const bool hovered = ImGui::IsItemHovered();
  const std::size_t under = cells.under(ImGui::GetIO().MousePos.x);
  const bool onCell = hovered && ImGui::GetIO().MousePos.x < cells.left(cells.count);
  for (std::size_t i = 0; i < rounds; ++i) {
    const IterationSummary& round = results.history[i];
    const float full = height - ui.px(8);
    const float bar = std::max(ui.px(2), full * static_cast<float>(round.stdOverMean / worst));
    const bool best = i == results.bestIteration;
    const ImU32 color = onCell && under == i ? p.text : best ? p.front : p.accent;
    const float gap = cells.step > 4 ? 1.0f : 0.0f;
    list.AddRectFilled({cells.left(i) + gap, cells.low.y + height - bar},
                       {cells.left(i + 1) - gap, cells.low.y + height}, color,
                       cells.step > 6 ? 2.0f : 0.0f);
    if (onCell && under == i) roundTooltip(ui, round, best);
  }
  if (playback.hasFinal()) finalCell(ui, cells);
  momentMark(ui, cells);
  if (onCell && under >= rounds) {
    tooltip(ui, "round end", under >= playback.rounds() ? "Finished charts" : "Round under way",
            under >= playback.rounds() ? "The kept round after its borders were laid anew." : "");
  }
  dragRounds(ui, cells, rounds);
}

void scrubber(const Ui& ui, const Reel& reel, float width, float height) {
  const Palette& p = ui.theme.palette;
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##scrubber", {width, height});
  ui.probe.item("scrubber");
  const bool active = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = low.y + height / 2;
  const float half = ui.px(5);
  const auto place = [&](std::size_t count) {
    return low.x + width * static_cast<float>(reel.share(count));
  };
  const float played = place(reel.step), recorded = place(reel.recorded);
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
  if (active && reel.recorded > 0) {
    const double share =
        std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - low.x) / width), 0.0, 1.0);
    const auto count =
        std::min(reel.recorded,
                 static_cast<std::size_t>(std::lround(share * static_cast<double>(reel.capacity))));
    if (count != reel.step) ui.run(std::string(reel.action) + ' ' + std::to_string(count));
  }
  tooltip(ui, "scrubber", reel.title, reel.help);
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

/// The step of the refinement that is shown, and between which charts it went.
std::string borderFigure(const Results& results, std::size_t step, std::size_t steps) {
  if (step == 0) return "of round " + std::to_string(results.recordIteration + 1) + ", as flooded";
  const std::string count = grouped(step) + " of " + grouped(steps) + " laid anew";
  if (step == steps || !results.seamRecord) return count + "   finished charts";
  const SeamStep& last = results.seamRecord->steps[step - 1];
  return count + "   charts " + std::to_string(last.a) + " and " + std::to_string(last.b);
}

std::string momentFigure(const AppState& state) {
  const Playback& playback = state.playback;
  if (playback.showsBorders()) {
    return borderFigure(state.results(), playback.borderStep(), playback.borderSteps());
  }
  const std::string of = "round " + std::to_string(playback.round() + 1) + "   ";
  if (playback.atFinal()) return of + "finished charts";
  if (playback.missingRound()) return of + "is flooded once more";
  return (playback.rounds() > 0 ? of : std::string()) + grouped(playback.playhead()) + " of " +
         grouped(playback.capacity()) + " faces";
}

}  // namespace

void timeline(const Ui& ui) {
  const Reel reel = reelOf(ui.state.playback);
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
  caption(ui, reel.title, momentFigure(ui.state), right);
  scrubber(ui, reel, right, height);
  ImGui::EndGroup();
}

}  // namespace chartflood
