#pragma once
/// The triangle that a step has just taken is bright for a moment.

#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/host/film/playback.h"
#include "core/base/index.h"

namespace chartflood {

class StepFlash {
 public:
  static constexpr double kSeconds = 0.3;

  /// A step is about to be taken, here or by the worker.
  void ask(const Playback& playback) {
    due_ = true;
    from_ = momentOf(playback);
  }
  /// Takes in where the playback stands now.
  void update(const Playback& playback, double seconds) {
    left_ = std::max(0.0, left_ - seconds);
    if (left_ == 0) face_ = kNone;
    if (playback.playing() || playback.inBorders()) due_ = false;
    if (!due_ || momentOf(playback) == from_ || playback.playhead() == 0) return;
    due_ = false;
    face_ = (*playback.record())[playback.playhead() - 1].face;
    left_ = kSeconds;
  }
  /// kNone while nothing flashes.
  Index face() const { return face_; }
  double secondsLeft() const { return left_; }

 private:
  using Moment = std::pair<std::size_t, std::size_t>;
  static Moment momentOf(const Playback& playback) {
    return {playback.round(), playback.playhead()};
  }

  bool due_ = false;
  Moment from_;
  Index face_ = kNone;
  double left_ = 0;
};

}  // namespace chartflood
