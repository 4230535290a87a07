#include "app/host/playback.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

std::size_t Playback::playhead() const {
  return following_ ? recorded() : std::min(static_cast<std::size_t>(position_), recorded());
}

double Playback::speed() const {
  if (chosenSpeed_ > 0) return chosenSpeed_;
  return std::max(kSlowest, static_cast<double>(capacity()) / kDefaultSeconds);
}

void Playback::seek(std::size_t count) {
  mode_ = Mode::Paused;
  following_ = count >= recorded();
  position_ = static_cast<double>(std::min(count, recorded()));
}

void Playback::follow() {
  mode_ = Mode::Paused;
  following_ = true;
}

std::optional<StepRequest> Playback::stepForward(std::size_t count) {
  const std::size_t wanted = playhead() + count;
  const std::size_t missing = wanted > recorded() ? wanted - recorded() : 0;
  seek(std::min(wanted, recorded()));
  if (missing == 0) return std::nullopt;
  return StepRequest{StepUnit::Face, missing};
}

void Playback::stepBack(std::size_t count) {
  const std::size_t now = playhead();
  seek(now - std::min(now, count));
}

std::optional<StepRequest> Playback::ask(StepRequest request) {
  waiting_ = true;
  recordedWhenAsked_ = recorded();
  return request;
}

std::optional<StepRequest> Playback::askWhenDone(const Source& source) {
  if (!complete()) return ask({StepUnit::Flood, 1});
  if (!atEnd()) return std::nullopt;
  if (mode_ == Mode::OneFlood || source.stopped) {
    mode_ = Mode::Paused;
    following_ = true;
    return std::nullopt;
  }
  return ask({StepUnit::Iteration, 1});
}

std::optional<StepRequest> Playback::update(const Source& source, double seconds) {
  if (source.record != record_) {
    record_ = source.record;
    waiting_ = false;
    position_ = 0;
    following_ = !playing();
  }
  if (!playing() || !source.hasMesh) return std::nullopt;
  if (following_) {  // play was pressed: a whole flood starts over, a part of one goes on
    position_ = complete() && source.stopped ? 0.0 : static_cast<double>(recorded());
    following_ = false;
  }
  const bool unlimited = speed() > kFastest;
  position_ += unlimited ? static_cast<double>(capacity()) : speed() * std::max(0.0, seconds);
  position_ = std::min(position_, static_cast<double>(recorded()));
  if (source.busy) return std::nullopt;
  if (waiting_ && recorded() == recordedWhenAsked_ && !source.stopped) {
    waiting_ = false;  // the worker had nothing to give: stopped or failed
    mode_ = Mode::Paused;
    following_ = true;
    return std::nullopt;
  }
  waiting_ = false;
  return askWhenDone(source);
}

}  // namespace chartflood
