#include "app/host/state/method_runs.h"

#include <algorithm>
#include <utility>

#include "app/host/state/app_state.h"
#include "app/host/state/compare_look.h"
#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/segment/registry.h"
#include "core/session/pipeline/compared_methods.h"

namespace chartflood {

void MethodRuns::begin(std::shared_ptr<const Mesh> mesh, const Document& document) {
  session_ = std::make_unique<Session>(worker_);
  session_->setWake(wake_);
  session_->setAutoUnwrap(true);
  session_->openMesh(std::move(mesh));
  document_ = document;
  done_.clear();
  stopped_ = false;
  beginNext();
}

void MethodRuns::beginNext() {
  running_ = document_;
  running_.parameters = comparedWith(document_.parameters, comparedMethods()[done_.size()]);
  session_->setDocument(running_, Session::Answer::Nothing);
  session_->resetSeeds();
  session_->step(StepUnit::Converged);
}

void MethodRuns::stop() {
  if (!running()) return;
  stopped_ = true;
  session_->stop();
}

MethodRuns::State MethodRuns::state() const {
  const WorkStatus status = session_->status();
  const char* phase = *status.phase == '\0' ? "Working" : status.phase;
  return {std::string(comparedMethods()[done_.size()]) + ": " + phase, status.fraction};
}

std::optional<std::vector<MethodRuns::Done>> MethodRuns::update() {
  if (session_ == nullptr || session_->status().busy) return std::nullopt;
  if (stopped_) {
    session_.reset();
    return std::nullopt;
  }
  for (const Notice& notice : session_->takeNotices()) {
    if (notice.kind != Notice::Kind::Error) continue;
    session_.reset();
    throw Error("The methods could not be compared: " + notice.text);
  }
  done_.push_back({running_, session_->results()});
  if (done_.size() < comparedMethods().size()) {
    beginNext();
    return std::nullopt;
  }
  session_.reset();
  return std::exchange(done_, {});
}

void MethodRuns::setWake(void (*wake)()) {
  wake_ = wake;
  if (session_) session_->setWake(wake);
}

namespace {

StoredResult storedOf(const MethodRuns::Done& done, const CompareLook& look) {
  StoredResult stored;
  stored.document = done.document;
  stored.results = done.results;
  stored.figures = compareFigures(*done.results);
  const std::vector<Index> locked = lockedFaces(done.document.seeds);
  for (const Index face : done.results->start.seeds) {
    const auto number = static_cast<Index>(stored.seeds.size());
    const bool stays = std::find(locked.begin(), locked.end(), face) != locked.end();
    stored.seeds.push_back({face, number, false, stays});
  }
  stored.look = look;
  stored.ofMethods = true;
  return stored;
}

void show(AppState& state, const std::vector<MethodRuns::Done>& runs) {
  activate(state, {});
  state.compare.stored.clear();
  std::string said;
  for (const MethodRuns::Done& done : runs) {
    StoredResult stored = storedOf(done, {state.view.camera, state.view.render});
    stored.name = kCompareSlots[state.compare.stored.size()];
    said += (said.empty() ? "" : ", ") + stored.name + ' ' + stored.figures.method;
    state.compare.store(std::move(stored));
  }
  state.compare.layout = Compare::Layout::SideBySide;
  state.view.frameWhenLoaded = true;  // the sides are narrower than the view was
  state.notices.add(Notice::Kind::Info, "The methods stand side by side: " + said + '.');
}

}  // namespace

void updateMethodRuns(AppState& state) {
  try {
    if (const auto done = state.methodRuns.update()) show(state, *done);
  } catch (const std::exception& failure) {
    state.notices.add(Notice::Kind::Error, failureSentence(failure));
  }
}

}  // namespace chartflood
