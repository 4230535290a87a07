// What AppState does with files: opening models, sessions and pictures, saving, and the words that
// name the model again.

#include <algorithm>
#include <utility>

#include "app/host/files/picture_record.h"
#include "app/host/files/session_view.h"
#include "app/host/script/command.h"
#include "app/host/state/app_state.h"
#include "core/base/failure.h"
#include "core/io/read/read_hints.h"
#include "core/io/write/file_output.h"

namespace chartflood {

void AppState::takeSession(Opening& opening) {
  SessionFile& session = *opening.session;
  unknownInFile_ = std::move(session.unknown);
  std::vector<std::string> warnings = std::move(session.warnings);
  const auto add = [&](std::vector<std::string> more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  };
  // What the program saved by itself names what the user had opened.
  add(applyViewValues(session.view, view, opening.recovered.empty() ? session.folder : "/"));
  const SessionView known = viewValues(view);
  for (auto& [key, value] : session.view) {
    if (!known.contains(key)) unknownView_[key] = value;
  }
  // Pictures know of charts that were selected or hidden, sessions do not.
  const std::vector<Index> selected = std::exchange(view.render.selectedCharts, {});
  const std::vector<Index> hidden = std::exchange(view.render.hiddenCharts, {});
  if (selected.size() == 1 && selected[0] < session.charts.start.seeds.size()) {
    selectedChart = selected[0];
    view.isolate = hidden.size() + 1 == session.charts.start.seeds.size();
  }
  if (!view.isolate) view.hiddenCharts = hidden;
  SessionContent content = sessionContent(session, *results_->mesh, results_->checksum);
  add(content.warnings);
  for (std::string& warning : warnings) notices.add(Notice::Kind::Warning, std::move(warning));
  if (!opening.recovered.empty()) {
    keeper.beginRecovered(opening.recovered, opening.sessionFile);
  } else {
    keeper.begin(content.document, opening.sessionFile);
  }
  if (content.moment.start.seeds.empty()) {
    session_.setDocument(content.document, Session::Answer::Flood);
    playback.playOneFlood();
    firstFlood_ = true;
  } else {
    playback.follow();
    session_.restore(content.document, content.moment, answerTo(false));
  }
}

std::string AppState::sessionTextFor(const std::filesystem::path& file) const {
  return sessionTextOf(view, file);
}

std::string AppState::sessionTextLike(const ViewSettings& shown) const {
  return sessionTextOf(shown, {});
}

std::string AppState::sessionTextOf(const ViewSettings& shown,
                                    const std::filesystem::path& file) const {
  // As new as can be, unless another model has just come that this state knows nothing of yet.
  const std::shared_ptr<const Results> newest = session_.results();
  const Results& now = newest->meshVersion == meshVersion_ ? *newest : *results_;
  SessionFile session = sessionOf(model_, document(), now);
  session.charts = presentMoment(now);
  session.view = viewValues(shown);
  session.view.insert(unknownView_.begin(), unknownView_.end());
  session.unknown = unknownInFile_;
  if (!file.empty() && file == keeper.recovery.file()) session.continues = keeper.file();
  return sessionText(session, file);
}

std::string AppState::modelWords(bool withFolder) const {
  if (!model_.sample.empty()) {
    const std::string size =
        model_.triangles == 0 ? "" : " --triangles=" + std::to_string(model_.triangles);
    return "--sample=" + model_.sample + size;
  }
  const std::filesystem::path file =
      model_.file.empty() ? std::filesystem::path(results_->mesh->input().file) : model_.file;
  return quotedArgument((withFolder ? file : file.filename()).string());
}

void AppState::keepWork(double seconds) {
  if (!hasMesh()) return;
  keeper.update(document(), results_->version, !changing() && !playback.playing(), seconds,
                [&] { return sessionTextFor(keeper.recovery.file()); });
}

void AppState::saveSession(const std::filesystem::path& file) {
  writeFileAtomically(file, sessionTextFor(file));
  keeper.begin(document(), file);
  rememberFile(preferences, file);
}

void AppState::open(const std::filesystem::path& file) {
  if (isSessionFile(file)) return openSession(readSession(file), file);
  if (isPngFile(file)) {
    const std::filesystem::path model = findModel(modelOfPicture(file), file);
    return openSession(readPictureSource(file, model).session, {});
  }
  opening_.emplace().model.file = file;
  session_.open(file);
}

/// A model of this name: beside the picture, the one that is open, or one opened lately; "": none.
std::filesystem::path AppState::findModel(const std::string& name,
                                          const std::filesystem::path& picture) const {
  if (name.empty()) return {};
  std::vector<std::filesystem::path> places{picture.parent_path() / name, model_.file};
  places.insert(places.end(), preferences.recentFiles.begin(), preferences.recentFiles.end());
  std::error_code error;
  for (const std::filesystem::path& place : places) {
    if (place.filename() == name && std::filesystem::exists(place, error)) return place;
  }
  return {};
}

void AppState::openSession(SessionFile session, const std::filesystem::path& file,
                           const std::filesystem::path& recovered) {
  const SessionModel model = session.model;
  opening_ = Opening{model, std::move(session), file, recovered};
  if (recovered.empty() && !file.empty()) rememberFile(preferences, file);
  if (model.file.empty()) {
    session_.openSample(model.sample, model.triangles);
  } else {
    session_.open(model.file);
  }
}

void AppState::openSample(const std::string& name, std::size_t triangles) {
  opening_.emplace().model = {{}, {}, name, triangles};
  session_.openSample(name, triangles);
}

void AppState::placeSeeds() {
  if (firstSeeds.empty()) return;
  const std::vector<Index> wanted = std::exchange(firstSeeds, {});
  Document document = session_.document();
  document.seeds.clear();
  for (const Index face : wanted) document.seeds.push_back({meshFace(*results_->mesh, face)});
  if (std::erase(document.seeds, PlacedSeed{}) > 0) {
    notices.add(Notice::Kind::Warning, "Some seeds are no faces of this model and were left out.");
  }
  session_.setDocument(document);
}

void AppState::takeHints() {
  if (firstHints.empty()) return;
  try {
    Document document = session_.document();
    document.hints = readHints(std::exchange(firstHints, {}), *results_->mesh);
    session_.setDocument(document);
  } catch (const std::exception& failure) {
    notices.add(Notice::Kind::Error, failureSentence(failure));
  }
}

std::string commandLine(const AppState& state, bool withFolder) {
  return commandLine(state, state.document(), state.results(), withFolder);
}

std::string commandLine(const AppState& state, const Document& document, const Results& results,
                        bool withFolder) {
  std::string text = "chartflood";
  for (const ParameterInfo& info : parameterTable()) {
    if (isDefault(document.parameters, info)) continue;
    text += std::string(" --") + info.id + '=' +
            parameterText(parameterValue(document.parameters, info));
  }
  if (!document.seeds.empty()) {
    std::string faces;
    for (const PlacedSeed& seed : document.seeds) {
      faces += (faces.empty() ? "" : ",") + std::to_string(results.mesh->inputFace(seed.face));
    }
    text += " --seeds=" + faces;
  }
  if (state.hasMesh()) text += ' ' + state.modelWords(withFolder);
  return text;
}

}  // namespace chartflood
