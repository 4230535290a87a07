#pragma once
/// Floods are recorded, then played: which moment of the run is shown, and what to ask of the
/// worker so that there is something to play.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/model/flood_record.h"
#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// A step to ask of the session.
struct StepRequest {
  StepUnit unit = StepUnit::Face;
  std::size_t count = 1;

  bool operator==(const StepRequest&) const = default;
};

/// The transport over a whole run: the logs of its finished rounds, the flood under way, and after
/// a stop rule the steps that refined the borders, with the finished charts as the last picture.
/// Knows no session: `update` is told what there is and answers with what to ask for.
class Playback {
 public:
  enum class Mode {
    Paused,
    OneFlood,  ///< plays to the end of the present flood
    Running,   ///< flood after flood until a stop rule fires
  };
  /// Slowest and fastest speed of the slider, triangles per second; above it "as fast as can be".
  static constexpr double kSlowest = 1, kFastest = 1e6;
  /// At the default speed the first flood of a run takes this long.
  static constexpr double kDefaultSeconds = 3;
  /// And each next one this share of the one before, so that all rounds end within ten seconds.
  static constexpr double kShorter = 0.7;
  /// The refinement of borders takes this long.
  static constexpr double kBorderSeconds = 4;

  /// What the session has to offer in this moment.
  struct Source {
    bool hasMesh = false;
    std::shared_ptr<const FloodRecord> record;  ///< the worker's flood; null before the first
    bool busy = false;                          ///< the worker runs or has work waiting
    bool stopped = false;                       ///< a stop rule has fired
    bool finished = false;                      ///< there are finished charts after the last flood
    std::size_t round = 0;                      ///< of `record`
    /// Logs of the finished rounds, null where one was dropped.
    std::span<const std::shared_ptr<const FloodRecord>> rounds = {};
    std::size_t borderSteps = 0;  ///< of the refinement that led to the finished charts
  };

  /// Moves on by `seconds` of time and follows the worker. Returns the step that is needed to go
  /// on, if any.
  std::optional<StepRequest> update(const Source& source, double seconds);

  void play() { mode_ = Mode::Running; }
  void playOneFlood() { mode_ = Mode::OneFlood; }
  void pause() { mode_ = Mode::Paused; }
  Mode mode() const { return mode_; }
  bool playing() const { return mode_ != Mode::Paused; }

  /// Shows the first `count` triangles of the round shown; pauses.
  void seek(std::size_t count);
  /// Shows a round at a moment; behind the last one the finished charts or the end of what there
  /// is. Pauses.
  void goTo(std::size_t round, std::size_t count);
  /// Shows the borders after so many steps of their refinement, all of them being the finished
  /// charts, which also stand for what there is not. Pauses.
  void goToBorder(std::size_t step);
  /// One or more triangles on: from the logs while they reach, then by a step of the worker; steps
  /// of the refinement count like triangles.
  std::optional<StepRequest> stepForward(std::size_t count);
  /// To the next triangle that `chart` takes in the round shown, to its end where none comes.
  std::optional<StepRequest> stepChart(Index chart);
  /// The way back, through earlier rounds as well.
  void stepBack(std::size_t count);
  /// To the end of the run, following it as it grows; pauses.
  void follow();

  /// Log of the round shown; null before the first flood and where it was dropped.
  const std::shared_ptr<const FloodRecord>& record() const;
  /// Number of the round shown.
  std::size_t round() const { return following_ || onLive_ ? liveRound_ : round_; }
  /// Rounds of the run, the one under way included.
  std::size_t rounds() const;
  /// True when the finished charts are shown, which are behind the last flood.
  bool atFinal() const { return following_ && finished_; }
  bool hasFinal() const { return finished_; }
  /// Between the last flood and the finished charts.
  bool inBorders() const { return inBorders_; }
  /// Steps of the refinement, 0 without one, and how many of them are shown.
  std::size_t borderSteps() const { return borderSteps_; }
  std::size_t borderStep() const;
  /// The moment is one of the refinement, of which the finished charts are the last.
  bool showsBorders() const { return inBorders_ || (atFinal() && borderSteps_ > 0); }
  /// True when the shown round is the one that the worker stands at.
  bool onWorkersRound() const { return record() == live_; }
  /// The round shown when its log must be made again first.
  std::optional<std::size_t> missingRound() const;

  /// Incorporations shown: 0..recorded().
  std::size_t playhead() const;
  std::size_t recorded() const { return record() ? record()->size() : 0; }
  /// Faces of a whole flood.
  std::size_t capacity() const { return live_ ? live_->capacity() : 0; }
  bool complete() const { return live_ && recorded() == capacity(); }
  /// At the end of the log of the round shown.
  bool atEnd() const { return playhead() == recorded(); }
  /// Nothing of the run lies ahead.
  bool atEndOfRun() const;

  /// Triangles per second: as set, or the first flood in kDefaultSeconds.
  double speed() const;
  /// 0 returns to the default; above kFastest there is no limit.
  void setSpeed(double trianglesPerSecond) { chosenSpeed_ = trianglesPerSecond; }
  bool speedChosen() const { return chosenSpeed_ > 0; }

 private:
  double pace() const;
  void take(const Source& source);
  void stand(std::size_t round, std::size_t count);
  void leaveEnd();
  void enterBorders(double step);
  bool lastRound() const { return round() + 1 >= rounds(); }
  void playOn(const Source& source, double seconds);
  void playBorders(double seconds);
  void keepPlace(const std::shared_ptr<const FloodRecord>& before);
  std::optional<StepRequest> askWhenDone(const Source& source);
  std::optional<StepRequest> ask(StepRequest request);

  std::shared_ptr<const FloodRecord> live_;  ///< the worker's
  std::size_t liveRound_ = 0;
  bool finished_ = false;
  std::size_t borderSteps_ = 0;
  std::vector<std::shared_ptr<const FloodRecord>> rounds_;
  Mode mode_ = Mode::Paused;
  bool following_ = true;   ///< the playhead sticks to the end of the run
  bool onLive_ = false;     ///< it is in the worker's flood, wherever that is
  bool inBorders_ = false;  ///< or behind it in the refinement
  std::size_t round_ = 0;   ///< where it is otherwise
  double position_ = 0;     ///< of the playhead while it does not follow; in faces or steps
  double chosenSpeed_ = 0;
  bool waiting_ = false;  ///< a step was asked for and nothing has come of it yet
  std::size_t recordedWhenAsked_ = 0;
};

}  // namespace chartflood
