#include "app/host/playback.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

const std::shared_ptr<const FloodRecord>& Playback::record() const {
  return following_ || onLive_ ? live_ : rounds_[round_];
}

std::size_t Playback::rounds() const {
  return live_ ? std::max(rounds_.size(), liveRound_ + 1) : rounds_.size();
}

std::optional<std::size_t> Playback::missingRound() const {
  if (following_ || onLive_ || rounds_[round_]) return std::nullopt;
  return round_;
}

std::size_t Playback::playhead() const {
  return following_ ? recorded() : std::min(static_cast<std::size_t>(position_), recorded());
}

bool Playback::atEndOfRun() const {
  return following_ || (atEnd() && lastRound() && !finished_ && !missingRound());
}

double Playback::speed() const {
  if (chosenSpeed_ > 0) return chosenSpeed_;
  return std::max(kSlowest, static_cast<double>(capacity()) / kDefaultSeconds);
}

/// In a round of the run; the worker's where the round is still under way.
void Playback::stand(std::size_t round, std::size_t count) {
  following_ = false;
  onLive_ = round >= rounds_.size();
  round_ = onLive_ ? 0 : round;
  position_ = static_cast<double>(count);
}

/// From following to the same moment as a place of its own.
void Playback::leaveEnd() {
  if (!following_) return;
  following_ = false;
  onLive_ = true;
  position_ = static_cast<double>(recorded());
}

void Playback::seek(std::size_t count) {
  mode_ = Mode::Paused;
  if (!live_) return;
  leaveEnd();
  position_ = static_cast<double>(std::min(count, capacity()));
  if (onLive_ && !finished_ && count >= recorded()) following_ = true;
}

void Playback::goTo(std::size_t round, std::size_t count) {
  if (!live_ || round >= rounds()) return follow();
  if (following_ && round == liveRound_) return seek(count);
  stand(round, count);
  seek(count);
}

void Playback::follow() {
  mode_ = Mode::Paused;
  following_ = true;
}

std::optional<StepRequest> Playback::stepForward(std::size_t count) {
  mode_ = Mode::Paused;
  while (!following_) {
    const std::size_t end = missingRound() ? capacity() : recorded();
    const std::size_t now = std::min(static_cast<std::size_t>(position_), end);
    if (now + count <= end) {
      seek(now + count);
      return std::nullopt;
    }
    count -= end - now;
    if (lastRound()) {
      follow();
      if (finished_) return std::nullopt;  // the step leads to the finished charts
    } else {
      stand(round() + 1, 0);
    }
  }
  if (finished_) return std::nullopt;
  return StepRequest{StepUnit::Face, count};
}

std::optional<StepRequest> Playback::stepChart(Index chart) {
  const std::size_t now = playhead(), size = recorded();
  for (std::size_t i = now; i < size; ++i) {
    if ((*record())[i].chart == chart) return stepForward(i + 1 - now);
  }
  if (size > now) return stepForward(size - now);
  return stepForward(1);
}

void Playback::stepBack(std::size_t count) {
  mode_ = Mode::Paused;
  if (!live_) return;
  if (atFinal() && count > 0) --count;  // the finished charts are a step behind the flood
  leaveEnd();
  while (count >= playhead() && round() > 0) {
    count -= playhead();
    stand(round() - 1, capacity());
    if (missingRound()) break;  // a log that must be made again first
  }
  position_ = static_cast<double>(playhead() - std::min(playhead(), count));
  if (missingRound()) position_ = static_cast<double>(capacity() - std::min(capacity(), count));
}

std::optional<StepRequest> Playback::ask(StepRequest request) {
  waiting_ = true;
  recordedWhenAsked_ = recorded();
  return request;
}

std::optional<StepRequest> Playback::askWhenDone(const Source& source) {
  if (missingRound()) return std::nullopt;
  if (!complete()) return ask({StepUnit::Flood, 1});
  if (!atEnd()) return std::nullopt;
  if (!lastRound()) {
    if (mode_ == Mode::OneFlood) mode_ = Mode::Paused;
    return std::nullopt;
  }
  if (mode_ == Mode::OneFlood || source.stopped) {
    follow();
    return std::nullopt;
  }
  return ask({StepUnit::Iteration, 1});
}

/// Follows what the worker has, and keeps the place in the run.
void Playback::take(const Source& source) {
  const bool another = source.record != live_;
  const auto old = live_;
  live_ = source.record;
  liveRound_ = source.round;
  finished_ = source.finished;
  rounds_.assign(source.rounds.begin(), source.rounds.end());
  if (another) waiting_ = false;
  if (onLive_ && another) {
    // The flood that was shown is a finished round now, or was begun again.
    const auto kept = std::find(rounds_.begin(), rounds_.end(), old);
    if (old && kept != rounds_.end()) {
      position_ = std::min(position_, static_cast<double>(old->size()));
      onLive_ = false;
      round_ = static_cast<std::size_t>(kept - rounds_.begin());
      return;
    }
    position_ = 0;
    following_ = !playing();
  }
  const bool lost = !following_ && !onLive_ && round_ >= rounds_.size();
  if (lost) {  // another run has begun
    onLive_ = true;
    position_ = 0;
    following_ = !playing();
  }
  if (following_ && another && playing()) {
    leaveEnd();
    position_ = 0;
  }
}

void Playback::playOn(const Source& source, double seconds) {
  if (following_) {  // play was pressed: a finished run starts over, a part of one goes on
    const bool over = complete() && source.stopped;
    leaveEnd();
    if (over) stand(0, 0);
  }
  if (missingRound()) return;
  const bool unlimited = speed() > kFastest;
  position_ += unlimited ? static_cast<double>(capacity()) : speed() * std::max(0.0, seconds);
  while (position_ > static_cast<double>(recorded())) {
    const bool goesOn = mode_ == Mode::Running && complete() && !lastRound();
    if (!goesOn) {
      position_ = static_cast<double>(recorded());
      break;
    }
    const double rest = position_ - static_cast<double>(recorded());
    stand(round() + 1, 0);
    position_ = rest;
    if (missingRound()) return;  // plays on from there when the log is back
  }
}

std::optional<StepRequest> Playback::update(const Source& source, double seconds) {
  take(source);
  if (!playing() || !source.hasMesh) return std::nullopt;
  playOn(source, seconds);
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
