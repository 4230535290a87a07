#include "app/host/state/app_state.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "app/host/script/action_registry.h"
#include "core/base/error.h"
#include "core/base/failure.h"
#include "render/scene/first_view.h"

namespace chartflood {

namespace {

/// After a pause of the program the playback goes on from where it was.
constexpr double kLongestPlayedSeconds = 0.1;

}  // namespace

AppState::AppState(Session::Worker worker)
    : methodRuns(worker), session_(worker),
      insight_(std::make_unique<Insight>(worker == Session::Worker::Inline)),
      results_(session_.results()), moment_(insight_->place()) {
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
  finishFirstFlood();
  keepWork(seconds);
  keepLikes(seconds);
}

/// What the user likes is on disk soon after it was changed: no end of the program loses it.
void AppState::keepLikes(double seconds) {
  constexpr double kQuietSeconds = 1;
  if (keptPreferences_ && !panels.firstCard) preferences.firstCard = false;
  if (preferences != seenPreferences_) {
    seenPreferences_ = preferences;
    preferencesAge_ = 0;
    return;
  }
  if (preferences == keptPreferences_ || !keptPreferences_) return;
  preferencesAge_ += seconds;
  if (preferencesAge_ < kQuietSeconds) return;
  keptPreferences_ = preferences;
  keepPreferences();
}

void AppState::preferencesAreKept() { seenPreferences_ = keptPreferences_.emplace(preferences); }

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
  earlierFigures_.reset();
  firstFlood_ = false;
  view.uvCamera = {};
  view.isolate = false;
  view.chartColors.clear();
  view.frameWhenLoaded = true;
  const std::string& name = results_->mesh->input().file;
  const bool asked = opening_ && (opening_->model.file == name || opening_->model.sample == name);
  Opening opening;
  opening.model.file = name;
  if (asked) opening = std::move(*std::exchange(opening_, std::nullopt));
  const bool another = opening.model.file != model_.file || opening.model.sample != model_.sample;
  model_ = opening.model;
  model_.checksum = results_->checksum;
  unknownInFile_.clear();
  unknownView_.clear();
  // Only what could be read is worth to be offered again.
  if (asked && !opening.session && modelIsFile()) rememberFile(preferences, opening.model.file);
  if (opening.session) return takeSession(opening);
  if (another) lookAtNewMesh();
  placeSeeds();
  takeHints();
  keeper.begin(session_.document(), {});
  if (asked) {
    playback.playOneFlood();
    firstFlood_ = true;
  }
}

/// Upright and from where its shape is seen best.
void AppState::lookAtNewMesh() {
  const std::optional<UpAxis> asked = std::exchange(firstUp, std::nullopt);
  view.camera.up = asked.value_or(likelyUpAxis(*results_->mesh));
  lookAtFirst(view.camera, *results_->mesh);
  if (asked || view.camera.up == UpAxis::Y) return;
  notices.add(Notice::Kind::Info, "The model seems to stand along Z, which is shown upright now; "
                                  "View > Camera > Upright axis turns it.");
}

/// What has been watched once is looked at finished, unless the user has taken it over.
void AppState::finishFirstFlood() {
  if (!firstFlood_ || playback.playing() || changing()) return;
  firstFlood_ = false;
  if (preferences.explore && playback.complete() && playback.atEnd()) finish();
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
  } catch (const std::exception& failure) {
    // Whatever it was: the window and the work in it stay.
    notices.add(Notice::Kind::Error, failureSentence(failure));
    return false;
  }
}

std::string AppState::modelName() const {
  if (!hasMesh()) return "";
  return std::filesystem::path(results_->mesh->input().file).stem().string();
}

bool AppState::showsFinal() const {
  const Segmentation* labels = results_->segmentation.get();
  if (labels == nullptr || !labels->complete) return false;
  // Finished charts stay until others are there, even where the worker could not keep them.
  const bool answers = preferences.explore && (results_->finished || results_->stale);
  if (answers) return playback.atEndOfRun();
  if (changing()) return false;
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
  if (preferences.explore && !document.seeds.empty()) {
    std::vector<PlacedSeed> seeds = document.seeds;
    for (std::size_t i = seeds.size(); i < results->start.seeds.size(); ++i) {
      seeds.push_back({results->start.seeds[i]});
    }
    return seeds;
  }
  const bool current = !results->stale && results->placed == document.seeds &&
                       results->parameters == document.parameters;
  if (!current && !document.seeds.empty()) return document.seeds;
  const std::vector<Index> locked = lockedFaces(document.seeds);
  std::vector<PlacedSeed> seeds;
  for (const Index face : results->start.seeds) {
    const bool isLocked = std::find(locked.begin(), locked.end(), face) != locked.end();
    seeds.push_back({face, isLocked});
  }
  return seeds;
}

const CompareFigures& AppState::liveFigures() const {
  if (figuresVersion_ != results_->version) figures_ = compareFigures(*results_);
  figuresVersion_ = results_->version;
  return figures_;
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

void AppState::takeNotices() {
  for (Notice& notice : session_.takeNotices()) notices.add(notice.kind, std::move(notice.text));
}

}  // namespace chartflood
