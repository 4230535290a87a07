#include "app/host/app_state.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "app/host/action_registry.h"
#include "app/host/command.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

/// After a pause of the program the playback goes on from where it was.
constexpr double kLongestPlayedSeconds = 0.1;

}  // namespace

AppState::AppState(Session::Worker worker)
    : session_(worker), insight_(std::make_unique<Insight>(worker == Session::Worker::Inline)),
      results_(session_.results()) {
  session_.setAutoUnwrap(true);
}

void AppState::update(double seconds) {
  results_ = session_.results();
  status_ = session_.status();
  takeNotices();
  notices.update(seconds);
  if (results_->meshVersion != meshVersion_) {
    meshVersion_ = results_->meshVersion;
    hoveredFace = pointedChart = selectedChart = panels.shownFace = kNone;
    view.uvCamera = {};
    view.isolate = false;
    view.frameWhenLoaded = true;
    placeSeeds();
    if (std::exchange(playWhenOpened_, false)) playback.playOneFlood();
  }
  film.update(results_->segmentation, std::min(seconds, kLongestPlayedSeconds));
  const bool stopped = results_->stopReason != StopReason::NotStopped;
  request(playback.update({hasMesh(), results_->record, changing(), stopped},
                          std::min(seconds, kLongestPlayedSeconds)));
}

bool AppState::perform(const ActionRegistry& actions, std::string_view line) {
  try {
    actions.run(line, *this);
    journal_.emplace_back(line);
    return true;
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
  return labels != nullptr && labels->complete && !changing() && playback.atEnd() &&
         playback.complete();
}

void AppState::changeDocument(const Document& document, std::string name, const std::string& key,
                              bool dragging) {
  const Document before = session_.document();
  if (document != before) undo_.changed(before, std::move(name), key);
  if (!dragging) undo_.close();
  session_.setDocument(document, floodsLive(dragging));
}

bool AppState::floodsLive(bool dragging) const {
  if (preferences.live == LiveMode::Off) return false;
  if (!dragging || preferences.live == LiveMode::On) return true;
  const double last = results_->timing.segment;
  return last >= 0 && last < kLiveMilliseconds;
}

void AppState::undo() {
  if (undo_.canUndo()) session_.setDocument(undo_.undo(session_.document()));
}

void AppState::redo() {
  if (undo_.canRedo()) session_.setDocument(undo_.redo(session_.document()));
}

Index AppState::chartOfFace(Index face) const {
  const Segmentation* labels = results_->segmentation.get();
  if (labels == nullptr || face >= labels->label.size()) return kNone;
  return labels->label[face];
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
  playWhenOpened_ = true;
  rememberFile(preferences, file);
  session_.open(file);
}

void AppState::openSample(const std::string& name, std::size_t triangles) {
  playWhenOpened_ = true;
  session_.openSample(name, triangles);
}

void AppState::placeSeeds() {
  if (firstSeeds.empty()) return;
  const std::vector<Index> wanted = std::exchange(firstSeeds, {});
  Document document = session_.document();
  document.seeds.assign(wanted.size(), kNone);
  const Mesh& mesh = *results_->mesh;
  for (Index face = 0; face < mesh.faceCount(); ++face) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (mesh.inputFace(face) == wanted[i]) document.seeds[i] = face;
    }
  }
  if (std::erase(document.seeds, kNone) > 0) {
    notices.add(Notice::Kind::Warning, "Some seeds are no faces of this model and were left out.");
  }
  session_.setDocument(document);
}

void AppState::takeNotices() {
  for (Notice& notice : session_.takeNotices()) notices.add(notice.kind, std::move(notice.text));
}

std::string commandLine(const AppState& state) {
  std::string text = "chartflood";
  for (const ParameterInfo& info : parameterTable()) {
    const ParameterValue value = parameterValue(state.document().parameters, info);
    if (value == parameterDefault(info)) continue;
    text += std::string(" --") + info.id + '=' + parameterText(value);
  }
  if (state.hasMesh()) text += ' ' + quotedArgument(state.results().mesh->input().file);
  return text;
}

}  // namespace chartflood
