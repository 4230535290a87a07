#pragma once
/// A flood is recorded, then played: which part of the record is shown, and what to ask of the
/// worker so that there is something to play.

#include <cstddef>
#include <memory>
#include <optional>

#include "core/model/flood_record.h"
#include "core/segment/segmenter.h"

namespace chartflood {

/// A step to ask of the session.
struct StepRequest {
  StepUnit unit = StepUnit::Face;
  std::size_t count = 1;

  bool operator==(const StepRequest&) const = default;
};

/// The transport over the present flood's record. Knows no session: `update` is told what there is
/// and answers with what to ask for.
class Playback {
 public:
  enum class Mode {
    Paused,
    OneFlood,  ///< plays to the end of the present flood
    Running,   ///< flood after flood until a stop rule fires
  };
  /// Slowest and fastest speed of the slider, triangles per second; above it "as fast as can be".
  static constexpr double kSlowest = 1, kFastest = 1e6;
  /// At the default speed a whole flood takes this long.
  static constexpr double kDefaultSeconds = 3;

  /// What the session has to offer in this moment.
  struct Source {
    bool hasMesh = false;
    std::shared_ptr<const FloodRecord> record;  ///< null before the first flood
    bool busy = false;                          ///< the worker runs or has work waiting
    bool stopped = false;                       ///< a stop rule has fired
  };

  /// Moves on by `seconds` of time and follows the record. Returns the step that is needed to go
  /// on, if any.
  std::optional<StepRequest> update(const Source& source, double seconds);

  void play() { mode_ = Mode::Running; }
  void playOneFlood() { mode_ = Mode::OneFlood; }
  void pause() { mode_ = Mode::Paused; }
  Mode mode() const { return mode_; }
  bool playing() const { return mode_ != Mode::Paused; }

  /// Shows the first `count` triangles of the record; pauses.
  void seek(std::size_t count);
  /// One or more triangles on: from the record while it reaches, then by a step of the worker.
  std::optional<StepRequest> stepForward(std::size_t count);
  void stepBack(std::size_t count);
  /// To the end of the record, following it as it grows; pauses.
  void follow();

  /// Incorporations shown: 0..recorded().
  std::size_t playhead() const;
  std::size_t recorded() const { return record_ ? record_->size() : 0; }
  /// Faces of a whole flood.
  std::size_t capacity() const { return record_ ? record_->capacity() : 0; }
  bool complete() const { return record_ && recorded() == capacity(); }
  bool atEnd() const { return playhead() == recorded(); }

  /// Triangles per second: as set, or a whole flood in kDefaultSeconds.
  double speed() const;
  /// 0 returns to the default; above kFastest there is no limit.
  void setSpeed(double trianglesPerSecond) { chosenSpeed_ = trianglesPerSecond; }
  bool speedChosen() const { return chosenSpeed_ > 0; }

 private:
  std::optional<StepRequest> askWhenDone(const Source& source);
  std::optional<StepRequest> ask(StepRequest request);

  std::shared_ptr<const FloodRecord> record_;
  Mode mode_ = Mode::Paused;
  bool following_ = true;  ///< the playhead sticks to the record's end
  double position_ = 0;    ///< of the playhead while it does not follow
  double chosenSpeed_ = 0;
  bool waiting_ = false;  ///< a step was asked for and nothing has come of it yet
  std::size_t recordedWhenAsked_ = 0;
};

}  // namespace chartflood
