// Actions of the film that shows how handles are cut.

#include <algorithm>

#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

std::vector<long> handles(const AppState& state) {
  const Results& results = state.results();
  const bool ready = results.segmentation && results.segmentation->complete && results.chartStats &&
                     !results.stale;
  return ready ? handlesOfCharts(*results.chartStats) : std::vector<long>{};
}

std::string needsHandle(const AppState& state) {
  if (!state.hasMesh()) return "There is no model yet; open one first.";
  const std::vector<long> all = handles(state);
  if (all.empty()) return "There are no complete charts yet; finish a flood first.";
  const bool any = std::any_of(all.begin(), all.end(), [](long count) { return count > 0; });
  return any ? "" : "No chart has a handle.";
}

std::string needsFilm(const AppState& state) {
  return state.film.ready() ? "" : "No film of a handle is shown.";
}

/// The chart asked for, else the selected one if it has a handle, else the first that has.
Index filmedChart(const AppState& state, const Arguments& a) {
  const std::vector<long> all = handles(state);
  const auto has = [&](long chart) {
    return chart >= 0 && static_cast<std::size_t>(chart) < all.size() &&
           all[static_cast<std::size_t>(chart)] > 0;
  };
  if (a.has("chart")) {
    const long chart = a.integer("chart");
    if (!has(chart)) throw UsageError("Chart " + std::to_string(chart) + " has no handle.");
    return static_cast<Index>(chart);
  }
  if (state.selectedChart != kNone && has(static_cast<long>(state.selectedChart))) {
    return state.selectedChart;
  }
  const auto first = std::find_if(all.begin(), all.end(), [](long count) { return count > 0; });
  return static_cast<Index>(first - all.begin());
}

}  // namespace

void addFilmActions(ActionRegistry& registry) {
  registry.add(
      {.id = "watch-handles",
       .title = "Watch the HandleCutter",
       .help = "Shows step by step how a growing front finds the handles of a chart and "
               "which loops are cut.",
       .arguments = {{"chart", ArgumentType::Integer, "left out: one with handles", false}},
       .refusal = needsHandle,
       .run = [](AppState& state, const Arguments& a) {
         const Index chart = filmedChart(state, a);
         state.playback.follow();
         const int seed = state.results().parameters.rngSeed;
         state.film.open(state.results().mesh, state.results().segmentation, chart,
                         static_cast<std::uint32_t>(seed));
       }});
  registry.add(
      {.id = "film-play",
       .title = "Play",
       .help = "Plays the film of the handle; once more pauses.",
       .arguments = {},
       .refusal = needsFilm,
       .run =
           [](AppState& state, const Arguments&) {
             HandleFilm& film = state.film;
             if (film.playing()) return film.pause();
             if (film.position() == film.steps()) film.seek(0);
             film.play();
           },
       .checked = [](const AppState& state, const Arguments&) { return state.film.playing(); }});
  registry.add({.id = "film-step",
                .title = "Step",
                .help = "Goes so many triangles on, or back with a negative number.",
                .arguments = {{"count", ArgumentType::Integer, "how many triangles", false}},
                .refusal = needsFilm,
                .run = [](AppState& state, const Arguments& a) {
                  const long wanted =
                      static_cast<long>(state.film.position()) + a.integer("count", 1);
                  state.film.seek(static_cast<std::size_t>(std::max(0L, wanted)));
                }});
  registry.add({.id = "film-next-event",
                .title = "Next event",
                .help = "Goes to the next moment at which a front splits, closes or meets another.",
                .arguments = {},
                .refusal = needsFilm,
                .run = [](AppState& state, const Arguments&) { state.film.toNextEvent(); }});
  registry.add({.id = "film-seek",
                .title = "Go to a moment",
                .help = "Shows the film after so many triangles.",
                .arguments = {{"count", ArgumentType::Integer, "triangles taken"}},
                .refusal = needsFilm,
                .run = [](AppState& state, const Arguments& a) {
                  state.film.seek(static_cast<std::size_t>(std::max(0L, a.integer("count"))));
                }});
  registry.add({.id = "film-close",
                .title = "Close",
                .help = "Ends the film of the handle.",
                .arguments = {},
                .refusal = {},
                .run = [](AppState& state, const Arguments&) { state.film.close(); }});
  constexpr std::pair<const char*, const char*> kKeys[] = {
      {"Space", "film-play"},           {"Right", "film-step"},  {"Left", "film-step -1"},
      {"Alt+Right", "film-next-event"}, {"Home", "film-seek 0"}, {"Esc", "film-close"}};
  for (const auto& [key, line] : kKeys) registry.bind(key, line, KeyPlace::HandleFilm);
}

}  // namespace chartflood
