#include "app/host/film/playback.h"

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
  return following_ || inBorders_ ? recorded()
                                  : std::min(static_cast<std::size_t>(position_), recorded());
}

std::size_t Playback::borderStep() const {
  if (inBorders_) return static_cast<std::size_t>(position_);
  return atFinal() ? borderSteps_ : 0;
}

bool Playback::atEndOfRun() const {
  return following_ || (atEnd() && lastRound() && !finished_ && !missingRound());
}

double Playback::speed() const {
  if (chosenSpeed_ > 0) return chosenSpeed_;
  return std::max(kSlowest, static_cast<double>(capacity()) / kDefaultSeconds);
}

/// Of the round shown: the first ones are watched, the later ones are more of the same.
double Playback::pace() const {
  if (speedChosen()) return speed();
  return speed() * std::pow(1 / kShorter, static_cast<double>(round()));
}

/// In a round of the run; the worker's where the round is still under way.
void Playback::stand(std::size_t round, std::size_t count) {
  following_ = false;
  inBorders_ = false;
  onLive_ = round >= rounds_.size();
  round_ = onLive_ ? 0 : round;
  position_ = static_cast<double>(count);
}

/// From following to the same moment as a place of its own.
void Playback::leaveEnd() {
  if (!following_ && !inBorders_) return;
  following_ = inBorders_ = false;
  onLive_ = true;
  position_ = static_cast<double>(recorded());
}

void Playback::enterBorders(double step) {
  following_ = step >= static_cast<double>(borderSteps_);
  inBorders_ = !following_;
  onLive_ = true;
  position_ = step;
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
  if ((following_ || inBorders_) && round == liveRound_) return seek(count);
  stand(round, count);
  seek(count);
}

void Playback::goToBorder(std::size_t step) {
  if (!finished_) return follow();
  mode_ = Mode::Paused;
  enterBorders(static_cast<double>(step));
}

void Playback::follow() {
  mode_ = Mode::Paused;
  following_ = true;
  inBorders_ = false;
}

std::optional<StepRequest> Playback::stepForward(std::size_t count) {
  mode_ = Mode::Paused;
  while (!following_) {
    if (inBorders_) {
      goToBorder(borderStep() + count);
      return std::nullopt;
    }
    const std::size_t end = missingRound() ? capacity() : recorded();
    const std::size_t now = std::min(static_cast<std::size_t>(position_), end);
    if (now + count <= end) {
      seek(now + count);
      return std::nullopt;
    }
    count -= end - now;
    if (!lastRound()) {
      stand(round() + 1, 0);
    } else if (finished_) {  // one step leads to the round that is kept
      goToBorder(count - 1);
      return std::nullopt;
    } else {
      follow();
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
  if (atFinal() || inBorders_) {
    if (count <= borderStep()) return goToBorder(borderStep() - count);
    count -= borderStep() + 1;
    stand(rounds() - 1, capacity());
  }
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
  if (missingRound() || inBorders_) return std::nullopt;
  if (!complete()) return ask({StepUnit::Flood, 1});
  if (!atEnd()) return std::nullopt;
  if (!lastRound()) {
    if (mode_ == Mode::OneFlood) mode_ = Mode::Paused;
    return std::nullopt;
  }
  // After a stop rule one more step of the worker finishes the charts.
  if (mode_ == Mode::OneFlood || (source.stopped && finished_)) {
    follow();
    return std::nullopt;
  }
  return ask({StepUnit::Iteration, 1});
}

/// Follows what the worker has.
void Playback::take(const Source& source) {
  const auto before = live_;
  live_ = source.record;
  liveRound_ = source.round;
  finished_ = source.finished;
  borderSteps_ = source.finished ? source.borderSteps : 0;
  rounds_.assign(source.rounds.begin(), source.rounds.end());
  if (live_ != before) waiting_ = false;
  if (inBorders_ && (live_ != before || borderStep() >= borderSteps_)) follow();
  keepPlace(before);
}

/// Keeps the place in the run when the worker has gone on from its flood of `before`.
void Playback::keepPlace(const std::shared_ptr<const FloodRecord>& before) {
  const bool another = live_ != before;
  if (onLive_ && another) {
    // The flood that was shown is a finished round now, or was begun again.
    const auto kept = std::find(rounds_.begin(), rounds_.end(), before);
    if (before && kept != rounds_.end()) {
      position_ = std::min(position_, static_cast<double>(before->size()));
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

/// At the pace at which floods are played.
void Playback::playBorders(double seconds) {
  const double faster = speed() * kDefaultSeconds / std::max(1.0, static_cast<double>(capacity()));
  const double perSecond = static_cast<double>(borderSteps_) / kBorderSeconds * faster;
  enterBorders(position_ + std::max(0.0, seconds) * perSecond);
  if (following_) mode_ = Mode::Paused;
}

void Playback::playOn(const Source& source, double seconds) {
  if (inBorders_) return playBorders(seconds);
  if (following_) {  // play was pressed: a finished run starts over, a part of one goes on
    const bool over = complete() && source.finished;
    leaveEnd();
    if (over) stand(0, 0);
  }
  if (missingRound()) return;
  const bool unlimited = speed() > kFastest;
  position_ += unlimited ? static_cast<double>(capacity()) : pace() * std::max(0.0, seconds);
  while (position_ > static_cast<double>(recorded())) {
    const bool goesOn = mode_ == Mode::Running && complete() && !lastRound();
    if (!goesOn) {
      position_ = static_cast<double>(recorded());
      const bool atLast = mode_ == Mode::Running && complete() && lastRound();
      if (atLast && borderSteps_ > 0) enterBorders(0);
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
  if (waiting_ && recorded() == recordedWhenAsked_ && !source.finished) {
    waiting_ = false;  // the worker had nothing to give: stopped or failed
    mode_ = Mode::Paused;
    following_ = true;
    return std::nullopt;
  }
  waiting_ = false;
  return askWhenDone(source);
}

}  // namespace chartflood
