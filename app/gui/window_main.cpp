#include "app/gui/window_main.h"

#include <cstdlib>

#include "app/host/actions/actions.h"
#include "app/host/files/session_view.h"
#include "app/host/script/action_registry.h"
#include "app/host/settings/standard_paths.h"
#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/base/log.h"

namespace chartflood {

namespace {

std::filesystem::path fromEnvironment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? std::filesystem::path() : std::filesystem::path(value);
}

void loadPreferences(AppState& state) {
  std::string warning;
  state.preferences = readPreferences(configFolder(), stateFolder(), warning);
  if (!warning.empty()) state.notices.add(Notice::Kind::Warning, warning);
  state.panels.firstCard = state.preferences.firstCard;
}

/// Options hold for this time: what the user does not change goes back to what it was.
class PreferredByOptions {
 public:
  PreferredByOptions(Preferences& preferences, const WindowOptions& options)
      : before_(preferences) {
    for (const auto& [name, text] : options.preferences) {
      rows_.push_back(findSetting(preferenceTable(), name));
      rows_.back()->setText(preferences, text);
    }
    given_ = preferences;
  }
  void takeBack(Preferences& preferences) const {
    for (const Setting<Preferences>* row : rows_) {
      if (row->get(preferences) == row->get(given_)) row->set(preferences, row->get(before_));
    }
  }

 private:
  std::vector<const Setting<Preferences>*> rows_;
  Preferences before_, given_;
};

/// The card of first steps is shown until it was once put away.
void savePreferences(AppState& state, const PreferredByOptions& preferred) {
  if (!state.panels.firstCard) state.preferences.firstCard = false;
  Preferences kept = state.preferences;
  preferred.takeBack(kept);
  try {
    writePreferences(kept, configFolder(), stateFolder());
  } catch (const std::exception& failure) {
    logMessage(LogLevel::Warning, failureSentence(failure));
  }
}

/// Goes on with a session; options that were given beside it win.
void beginSession(AppState& state, const WindowOptions& options) {
  SessionFile session = *options.session;
  Stage stage;
  const bool changed = firstDifference(session.parameters, options.parameters, stage);
  if ((changed && stage <= Stage::Refine) || !options.seeds.empty()) session.charts = {};
  if (!options.seeds.empty()) {
    session.seeds.clear();
    for (const Index face : options.seeds) session.seeds.push_back({face});
  }
  const Document saved{session.parameters, session.seeds, {}};
  session.seeds = withFittingSeeds(saved, {options.parameters, session.seeds, {}}).seeds;
  session.parameters = options.parameters;
  ViewSettings view;
  applyViewValues(session.view, view, session.folder);
  view.render = options.render;
  if (options.up) view.camera.up = *options.up;
  view.camera.orthographic = options.orthographic;
  for (auto& [name, value] : viewValues(view)) session.view[name] = value;
  state.openSession(std::move(session), options.sessionFile);
}

void begin(AppState& state, const WindowOptions& options) {
  state.view.render = options.render;
  state.firstUp = options.up;
  state.view.camera.look(StandardView::Oblique);
  state.view.camera.orthographic = options.orthographic;
  if (options.session) return beginSession(state, options);
  state.firstSeeds = options.seeds;
  state.firstHints = options.hints;
  Document document;
  document.parameters = options.parameters;
  state.session().setDocument(document);
  if (options.file.empty()) {
    state.openSample(options.sample, options.triangles);
  } else {
    state.open(options.file);
  }
}

}  // namespace

int runWindow(const WindowOptions& options) {
  const ActionRegistry actions = makeActionRegistry();
  AppState state(Session::Worker::Background);
  loadPreferences(state);
  const PreferredByOptions preferred(state.preferences, options);
  state.keepPreferences = [&] { savePreferences(state, preferred); };
  state.preferencesAreKept();
  state.keeper.recovery.begin(stateFolder());
  {
    Window window(
        state, actions,
        {fromEnvironment("CHARTFLOOD_PROBE_FILE"), fromEnvironment("CHARTFLOOD_FRAME_LOG")});
    begin(state, options);
    window.run();
  }
  savePreferences(state, preferred);
  state.keeper.recovery.end();
  return EXIT_SUCCESS;
}

}  // namespace chartflood
