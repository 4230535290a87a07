// State of work with a bar and a way to cancel, what is under the mouse, figures of the result.

#include <cstdio>
#include <optional>
#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/state/compare_look.h"

namespace chartflood {

namespace {

constexpr double kQuietSeconds = 0.3;  // shorter work shows no bar

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// What is being done, how far it is, and a way to give up.
void workBar(const Ui& ui, const std::string& words, float fraction) {
  ImGui::TextUnformatted(words.c_str());
  ImGui::SameLine();
  const float height = ui.px(6), width = ui.px(90);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = at.y + (ImGui::GetFrameHeight() - height) / 2;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x, y}, {at.x + width, y + height}, ui.theme.palette.control, height / 2);
  list.AddRectFilled({at.x, y}, {at.x + width * fraction, y + height}, ui.theme.palette.accent,
                     height / 2);
  ImGui::Dummy({width, 0});
  ui.probe.item("progress");
  ImGui::SameLine();
  // As high as the words' frame, so that both stand on one line.
  const ImVec2 padding(ui.px(6), ImGui::GetStyle().FramePadding.y);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  textButton(ui, "Stop", "stop");
  ImGui::PopStyleVar();
}

/// What the work is for, where it is an answer to new values: what is shown until then is not it.
std::string answering(const AppState& state) {
  if (!state.preferences.explore || !state.changing() || !state.results().segmentation) return "";
  return state.results().sketch ? "Preview, settling: " : "Settling: ";
}

void workState(const Ui& ui) {
  if (const PictureRow& row = ui.state.pictureRow; row.running()) {
    const std::string what = row.row == PictureRequest::Row::Turntable ? "Turntable " : "Film ";
    return workBar(ui, what + std::to_string(row.done) + '/' + std::to_string(row.count),
                   static_cast<float>(row.done) / static_cast<float>(row.count));
  }
  const WorkStatus& status = ui.state.status();
  if (status.busy && status.seconds > kQuietSeconds) {
    const std::string phase = *status.phase == '\0' ? "Working" : status.phase;
    return workBar(ui, answering(ui.state) + phase, status.fraction);
  }
  if (ui.state.methodRuns.running()) {
    const MethodRuns::State runs = ui.state.methodRuns.state();
    return workBar(ui, runs.words, runs.fraction);
  }
  const Playback& playback = ui.state.playback;
  const char* words = "Open a model to begin";
  if (playback.playing()) {
    words = "Playing";
  } else if (ui.state.results().sketch) {
    words = "Preview";
  } else if (ui.state.results().stale) {
    words = ui.state.preferences.explore ? "Out of date: press Enter" : "Out of date: press Play";
  } else if (ui.state.hasMesh()) {
    words = ui.state.results().stopReason != StopReason::NotStopped ? "Finished" : "Ready";
  }
  ImGui::TextUnformatted(words);
}

/// A way to sentences that went by unread.
void missedErrors(const Ui& ui) {
  if (ui.state.panels.log) ui.state.notices.forgetMissed();
  const std::size_t missed = ui.state.notices.missedErrors();
  if (missed == 0) return;
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.error);
  textButton(ui, (grouped(missed) + (missed == 1 ? " error" : " errors")).c_str(), "log");
  ImGui::PopStyleColor();
}

/// Chart of a face as shown in the half under the mouse, kNone when it is dry.
Index shownChart(const AppState& state, Index face) {
  const Compare& compare = state.compare;
  const ComparePane pane = compare.showing() ? compare.underMouse : ComparePane{};
  if (pane.live() || pane.stored >= compare.stored.size()) return state.chartOfFace(face);
  const Segmentation* labels = paneResults(state, pane).segmentation.get();
  return labels == nullptr || face >= labels->label.size() ? kNone : labels->label[face];
}

std::string underMouse(const AppState& state) {
  const Results& results = state.results();
  const Index face = state.hoveredFace;
  if (face == kNone || !results.mesh || face >= results.mesh->faceCount()) return "";
  std::string text = "Face " + std::to_string(results.mesh->inputFace(face));
  if (const Index chart = shownChart(state, face); chart != kNone) {
    text += "   Chart " + std::to_string(chart);
  }
  if (results.gaussArea) {
    double area = 0;
    for (Index t = results.mesh->triangleBegin(face); t < results.mesh->triangleBegin(face + 1);
         ++t) {
      area += results.gaussArea->triangle[t];
    }
    text += "   Gauss area " + format("%.3g sr", area);
  }
  return text;
}

/// " (+1.2)", "" where nothing changed as far as is shown.
std::string difference(const char* pattern, std::optional<double> before,
                       std::optional<double> after, double factor = 1) {
  if (!before || !after) return "";
  const std::string zero = format(pattern, 0), nil = format(pattern, -0.0);
  const std::string text = format(pattern, factor * (*after - *before));
  return text == zero || text == nil ? "" : " (" + text + ")";
}

/// Figures of the finished charts, with what the last change did to them.
std::string finishedFigures(const AppState& state) {
  const CompareFigures& now = state.liveFigures();
  const CompareFigures before = state.earlierFigures().value_or(now);
  std::string text;
  if (now.seams) {
    text += "   seams " + format("%.2f", *now.seams) + difference("%+.2f", before.seams, now.seams);
  }
  if (now.stretch) {
    text += "   stretch " + format("%.3f", *now.stretch) +
            difference("%+.3f", before.stretch, now.stretch);
  }
  return text;
}

std::string figures(const AppState& state) {
  const Results& results = state.results();
  if (!results.mesh) return "";
  std::string text;
  if (const auto& shown = state.shownStats(); shown && !shown->charts.empty()) {
    const ChartStats& stats = *shown;
    text += std::to_string(stats.charts.size()) + " charts";
    if (stats.balanceDefined) {
      const double spread = stats.stdOverMean();
      text += "   spread " + format("%.1f %%", 100 * spread);
      if (state.showsFinal() && state.earlierFigures()) {
        text += difference("%+.1f", state.earlierFigures()->spread, spread, 100);
      }
    } else if (state.playback.recorded() > 0) {
      text += "   no curvature to balance";
    }
    if (state.showsFinal()) text += finishedFigures(state);
    text += "   |   ";
  }
  return text + grouped(results.mesh->triangleCount()) + " triangles";
}

}  // namespace

void statusBar(const Ui& ui) {
  ImGui::AlignTextToFramePadding();
  workState(ui);
  missedErrors(ui);
  const std::string right = figures(ui.state);
  const float rightWidth = ImGui::CalcTextSize(right.c_str()).x;
  const float end = ImGui::GetWindowContentRegionMax().x;
  const float start = ui.px(300);
  const float room = end - rightWidth - ui.px(20) - start;
  if (room > ui.px(60)) {
    ImGui::SameLine(start);
    fittedText(ui, underMouse(ui.state), room, ui.theme.palette.dim);
  }
  ImGui::SameLine(end - rightWidth);
  ImGui::TextUnformatted(right.c_str());
  ui.probe.item("figures");
}

}  // namespace chartflood
