#include "app/host/app_state.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "app/host/action_registry.h"
#include "app/host/command.h"
#include "app/host/picture_record.h"
#include "app/host/session_view.h"
#include "core/base/error.h"
#include "core/io/file_output.h"
#include "core/io/read_hints.h"

namespace chartflood {

namespace {

/// After a pause of the program the playback goes on from where it was.
constexpr double kLongestPlayedSeconds = 0.1;

}  // namespace

AppState::AppState(Session::Worker worker)
    : methodRuns(worker), session_(worker),
      insight_(std::make_unique<Insight>(worker == Session::Worker::Inline)),
      results_(session_.results()) {
  session_.setAutoUnwrap(true);
}

void AppState::update(double seconds) {
  results_ = session_.results();
  status_ = session_.status();
  compare.update(results_);
  updateMethodRuns(*this);
  takeNotices();
  notices.update(seconds);
  if (results_->meshVersion != meshVersion_) {
    meshVersion_ = results_->meshVersion;
    moment_.clear();
    takeNewMesh();
  }
  runs.update(*this);
  film.update(results_->segmentation, std::min(seconds, kLongestPlayedSeconds));
  movePlayback(std::min(seconds, kLongestPlayedSeconds));
  keepWork(seconds);
}

void AppState::movePlayback(double seconds) {
  const bool stopped = results_->stopReason != StopReason::NotStopped;
  request(playback.update({hasMesh(), results_->record, changing(), stopped, results_->finished,
                           results_->recordIteration, results_->floods,
                           results_->seamRecord ? results_->seamRecord->steps.size() : 0},
                          seconds));
  const std::size_t missing = playback.missingRound().value_or(kNoRound);
  if (missing != kNoRound && missing != recalled_) session_.recallRound(missing);
  recalled_ = missing;
  flash.update(playback, seconds);
  if (playback.inBorders()) {
    moment_.showBorders(*results_, playback.borderStep());
  } else if (!showsFinal()) {
    moment_.show(*results_, playback.record(), playback.playhead());
  }
}

void AppState::takeNewMesh() {
  hoveredFace = pointedChart = selectedChart = hoveredSeed = chosenSeed = panels.shownFace = kNone;
  view.hiddenCharts.clear();
  seedDrag.reset();
  hintStroke.reset();
  undo_.clear();  // its seeds are faces of another mesh
  methodRuns.stop();
  view.uvCamera = {};
  view.isolate = false;
  view.chartColors.clear();
  view.frameWhenLoaded = true;
  const std::string& name = results_->mesh->input().file;
  const bool asked = opening_ && (opening_->model.file == name || opening_->model.sample == name);
  Opening opening;
  opening.model.file = name;
  if (asked) opening = std::move(*std::exchange(opening_, std::nullopt));
  model_ = opening.model;
  model_.checksum = results_->checksum;
  unknownInFile_.clear();
  unknownView_.clear();
  if (opening.session) return takeSession(opening);
  placeSeeds();
  takeHints();
  keeper.begin(session_.document(), {});
  if (asked) playback.playOneFlood();
}

void AppState::takeSession(Opening& opening) {
  SessionFile& session = *opening.session;
  unknownInFile_ = std::move(session.unknown);
  std::vector<std::string> warnings = std::move(session.warnings);
  const auto add = [&](std::vector<std::string> more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  };
  add(applyViewValues(session.view, view));
  const SessionView known = viewValues(view);
  for (auto& [key, value] : session.view) {
    if (!known.contains(key)) unknownView_[key] = value;
  }
  // Pictures know of charts that were selected or hidden, sessions do not.
  const std::vector<Index> selected = std::exchange(view.render.selectedCharts, {});
  const std::vector<Index> hidden = std::exchange(view.render.hiddenCharts, {});
  if (selected.size() == 1 && selected[0] < session.charts.seeds.size()) {
    selectedChart = selected[0];
    view.isolate = hidden.size() + 1 == session.charts.seeds.size();
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
  if (content.moment.seeds.empty()) {
    session_.setDocument(content.document);
    playback.playOneFlood();
  } else {
    playback.follow();
    session_.restore(content.document, content.moment);
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
  // A flood that is under way will have been finished by the time it is looked at again.
  if (changing()) session.charts.taken = results_->mesh->faceCount();
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

void AppState::whenSafe(std::function<void(AppState&)> step) {
  if (!unsaved() || !preferences.askUnsaved) return step(*this);
  waiting_ = std::move(step);
  panels.unsavedQuestion = true;
}

void AppState::goOn() {
  if (const auto step = std::exchange(waiting_, {})) step(*this);
}

bool AppState::perform(const ActionRegistry& actions, std::string_view line) {
  try {
    actions.run(line, *this);
    journal_.emplace_back(line);
    return true;
  } catch (const Refusal& refusal) {
    notices.add(Notice::Kind::Info, refusal.what());
    return false;
  } catch (const Error& error) {
    notices.add(Notice::Kind::Error, error.what());
    return false;
  }
}

std::string AppState::modelName() const {
  if (!hasMesh()) return "";
  return std::filesystem::path(results_->mesh->input().file).stem().string();
}

bool AppState::showsFinal() const {
  const Segmentation* labels = results_->segmentation.get();
  if (labels == nullptr || !labels->complete || changing()) return false;
  if (results_->finished) return playback.atFinal();
  return playback.onWorkersRound() && playback.atEnd() && playback.complete();
}

std::span<const Index> AppState::shownLabels() const {
  if (!showsFinal()) return moment_.labels();
  return results_->segmentation->label;
}

const std::shared_ptr<const ChartStats>& AppState::shownStats() const {
  return showsFinal() ? results_->chartStats : moment_.stats();
}

std::vector<PlacedSeed> AppState::presentSeeds() const {
  const std::shared_ptr<const Results> results = session_.results();
  if (!results->mesh) return {};
  const Document& document = session_.document();
  const bool current = !results->stale && results->placed == document.seeds &&
                       results->parameters == document.parameters;
  if (!current && !document.seeds.empty()) return document.seeds;
  const std::vector<Index> locked = lockedFaces(document.seeds);
  std::vector<PlacedSeed> seeds;
  for (const Index face : results->seeds) {
    const bool isLocked = std::find(locked.begin(), locked.end(), face) != locked.end();
    seeds.push_back({face, isLocked});
  }
  return seeds;
}

UndoStep AppState::present() const {
  const std::shared_ptr<const Results> results = session_.results();
  UndoStep step{session_.document(), momentOf(*results)};
  // A flood under way would have been finished.
  if (changing() && results->mesh) step.moment.taken = results->mesh->faceCount();
  return step;
}

void AppState::changeDocument(const Document& document, std::string name, const std::string& key,
                              bool dragging) {
  const Document before = session_.document();
  const Document after = withFittingSeeds(before, document);
  if (after != before) undo_.changed(present(), std::move(name), key);
  if (!dragging) undo_.close();
  session_.setDocument(after, floodsLive(dragging));
}

void AppState::rememberCharts(std::string name) {
  undo_.changed(present(), std::move(name), "charts of a moment");
  undo_.close();
}

bool AppState::floodsLive(bool dragging) const {
  if (preferences.live == LiveMode::Off) return false;
  if (!dragging || preferences.live == LiveMode::On) return true;
  const double last = results_->timing.segment;
  return last >= 0 && last < kLiveMilliseconds;
}

void AppState::takeUp(const Document& document, const FloodMoment& moment, std::string name) {
  rememberCharts(std::move(name));
  playback.follow();
  selectedChart = hoveredSeed = kNone;
  session_.restore(document, moment);
}

const CompareFigures& AppState::liveFigures() const {
  if (figuresVersion_ != results_->version) figures_ = compareFigures(*results_);
  figuresVersion_ = results_->version;
  return figures_;
}

void AppState::undo() {
  if (!undo_.canUndo()) return;
  playback.follow();
  hoveredSeed = kNone;
  const UndoStep step = undo_.undo(present());
  session_.restore(step.document, step.moment);
}

void AppState::redo() {
  if (!undo_.canRedo()) return;
  playback.follow();
  hoveredSeed = kNone;
  const UndoStep step = undo_.redo(present());
  session_.restore(step.document, step.moment);
}

void AppState::takeBackDrag() {
  const std::optional<UndoStep> step = undo_.takeBack();
  if (step) session_.restore(step->document, step->moment);
}

Index AppState::chartOfFace(Index face) const {
  const std::span<const Index> labels = shownLabels();
  return face < labels.size() ? labels[face] : kNone;
}

Index AppState::hoveredChart() const {
  return hoveredFace != kNone ? chartOfFace(hoveredFace) : pointedChart;
}

void AppState::showChart(Index chart) {
  const Segmentation* labels = results_->segmentation.get();
  std::vector<Index> triangles;
  if (hasMesh() && labels != nullptr && labels->label.size() == results_->mesh->faceCount()) {
    const Mesh& mesh = *results_->mesh;
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      if (labels->label[mesh.faceOf(t)] == chart) triangles.push_back(t);
    }
  }
  if (chart == kNone || triangles.empty()) throw Error("There is no such chart.");
  selectedChart = chart;
  frameTriangles(triangles);
}

void AppState::showFace(Index face) {
  const Mesh& mesh = *results_->mesh;
  std::vector<Index> triangles;
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    triangles.push_back(t);
    // A face without area is seen by its neighbours.
    for (Index side = 3 * t; side < 3 * t + 3; ++side) {
      if (mesh.opposite()[side] != kNone) triangles.push_back(mesh.opposite()[side] / 3);
    }
  }
  selectedChart = chartOfFace(face);
  frameTriangles(triangles);
}

void AppState::frameTriangles(const std::vector<Index>& triangles) {
  const Mesh& mesh = *results_->mesh;
  glm::dvec3 normal(0);
  view.pointsToFrame.clear();
  for (const Index t : triangles) {
    const auto& [a, b, c] = mesh.triangles()[t];
    const auto p = mesh.positions();
    normal += glm::cross(p[b] - p[a], p[c] - p[a]);
    for (const Index v : {a, b, c}) view.pointsToFrame.push_back(p[v]);
  }
  // A chart that closes upon itself has no side to be seen from.
  if (glm::length(normal) < 1e-12) return;
  view.camera.lookAlong(-glm::normalize(normal),
                        view.camera.up == UpAxis::Z ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
}

void AppState::request(const std::optional<StepRequest>& step) {
  if (step) session_.step(step->unit, step->count);
}

void AppState::open(const std::filesystem::path& file) {
  if (isSessionFile(file)) return openSession(readSession(file), file);
  if (isPngFile(file)) {
    const std::filesystem::path model = findModel(modelOfPicture(file), file);
    return openSession(readPictureSource(file, model).session, {});
  }
  opening_.emplace().model.file = file;
  rememberFile(preferences, file);
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
  } catch (const Error& error) {
    notices.add(Notice::Kind::Error, error.what());
  }
}

void AppState::takeNotices() {
  for (Notice& notice : session_.takeNotices()) notices.add(notice.kind, std::move(notice.text));
}

std::string commandLine(const AppState& state, bool withFolder) {
  std::string text = "chartflood";
  for (const ParameterInfo& info : parameterTable()) {
    const ParameterValue value = parameterValue(state.document().parameters, info);
    if (value == parameterDefault(info)) continue;
    text += std::string(" --") + info.id + '=' + parameterText(value);
  }
  if (!state.document().seeds.empty()) {
    std::string faces;
    for (const PlacedSeed& seed : state.document().seeds) {
      faces +=
          (faces.empty() ? "" : ",") + std::to_string(state.results().mesh->inputFace(seed.face));
    }
    text += " --seeds=" + faces;
  }
  if (state.hasMesh()) text += ' ' + state.modelWords(withFolder);
  return text;
}

}  // namespace chartflood
