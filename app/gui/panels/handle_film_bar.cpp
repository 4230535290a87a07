// The transport of the film that shows how handles are cut, at the bottom of the 3D view.

#include <algorithm>
#include <cmath>
#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr float kWidth = 520, kLeastBarWidth = 240;

std::string caption(const HandleFilm& film) {
  if (!film.ready()) return "Preparing";
  return grouped(film.position()) + " of " + grouped(film.steps()) + " faces";
}

/// Drag to any moment.
void scrubber(const Ui& ui, float width) {
  const HandleFilm& film = ui.state.film;
  const double steps = static_cast<double>(std::max<std::size_t>(1, film.steps()));
  BarSlider slider;
  slider.label = "film-scrubber";
  slider.fraction = static_cast<double>(film.position()) / steps;
  slider.text = caption(film);
  slider.moved = [&](double fraction, bool) {
    const auto step = static_cast<long>(std::lround(fraction * steps));
    if (static_cast<std::size_t>(step) != film.position()) {
      ui.run("film-seek " + std::to_string(step));
    }
  };
  barSlider(ui, slider, width);
}

void transport(const Ui& ui) {
  const float height = ImGui::GetFrameHeight();
  const ImVec2 size{std::round(height * 1.2f), height};
  const float tight = ui.px(2);
  iconButton(ui, Icon::StepBack, "film-step -1", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, ui.state.film.playing() ? Icon::Pause : Icon::Play, "film-play", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::StepForward, "film-step", size);
  ImGui::SameLine(0, tight);
  iconButton(ui, Icon::NextRound, "film-next-event", size);
  ImGui::SameLine(0, ui.px(8));
  scrubber(ui, ImGui::GetContentRegionAvail().x - size.x - ui.px(8));
  ImGui::SameLine(0, ui.px(8));
  iconButton(ui, Icon::Close, "film-close", size);
}

}  // namespace

void handleFilmBar(const Ui& ui, ImVec2 low, ImVec2 high) {
  const HandleFilm& film = ui.state.film;
  if (!film.active()) return;
  const float room = high.x - low.x - ui.px(24);
  const float width = std::min(ui.px(kWidth), std::max(room, ui.px(kLeastBarWidth)));
  ImGui::SetNextWindowPos({std::round((low.x + high.x) / 2), high.y - ui.px(12)}, ImGuiCond_Always,
                          {0.5f, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.panel);
  ImGui::Begin("##handle-film", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushFont(ui.theme.strong);
  const std::string title = "Handles of chart " + std::to_string(film.chart());
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  ImGui::SameLine(0, ui.px(12));
  const std::string sentence = film.sentence();
  fittedText(ui, sentence.empty() ? "A region grows from one face." : sentence,
             ImGui::GetContentRegionAvail().x, ui.theme.palette.dim);
  transport(ui);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (!film.ready() || film.playing()) ui.wakeIn(0);
}

}  // namespace chartflood
