#pragma once
/// What all methods that flood round after round have in common: how far a call goes, the history,
/// the best round, the way back to any round, and the refinement of borders at the end.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/model/face_values.h"
#include "core/segment/borders/border_refiner.h"
#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// A method says how one flood runs and what is made of a finished one. Its constructor ends with
/// restartFlood().
class FloodRounds : public Stepper {
 public:
  /// \param id of the method, as in the registry
  FloodRounds(const char* id, const SegmentInputs& inputs, const SegmentOptions& options);

  StepOutcome advance(StepUnit unit, std::size_t count, Progress& progress) final;
  std::shared_ptr<const Segmentation> state() const final;
  std::shared_ptr<const FloodRecord> record() const final { return record_; }
  std::shared_ptr<const SeamRecord> seamRecord() const final {
    return finished() ? seamRecord_ : nullptr;
  }
  std::span<const IterationSummary> history() const final { return history_; }
  std::size_t bestIteration() const final { return best_; }
  StopReason stopReason() const final { return stopReason_; }
  bool finished() const final { return phase_ == Phase::Done; }
  StepOutcome adopt(std::size_t iteration, Progress& progress) final;
  void restartFlood() final;
  std::shared_ptr<const FloodRecord> replay(std::size_t iteration, Progress& progress) final;

 protected:
  /// What a round is worth.
  struct Judgement {
    StopReason stop = StopReason::NotStopped;
    bool best = false;  ///< better than all before
  };

  const Mesh& mesh() const { return *in_.mesh; }
  const SegmentInputs& inputs() const { return in_; }
  const SegmentOptions& options() const { return options_; }
  std::span<const double> faceGauss() const { return faceGauss_; }

  /// Seeds and what goes with them, of the flood at hand. Record and number are filled in here.
  virtual FloodStart present() const = 0;
  /// Begins a flood from there.
  virtual void startFlood(std::shared_ptr<FloodRecord> record) = 0;
  /// Takes up to `count` more faces, all when it can; returns how many.
  virtual std::size_t take(std::size_t count, Progress* progress) = 0;
  virtual std::size_t taken() const = 0;
  virtual std::vector<Index> labels() const = 0;  ///< of each face, kNone while free

  /// Of a finished flood: balance and cost, nothing else of the summary.
  virtual IterationSummary measure() = 0;
  /// After measure(): plans the next round as if no rule had stopped.
  virtual void planNext() = 0;
  /// After measure(), once for each new round, which is the last of the history: plans the next one
  /// or says why to stop.
  virtual Judgement judge() = 0;
  /// What was planned becomes present; returns how many seeds are elsewhere. Nothing when cancelled
  /// before: everything is as it was.
  virtual std::optional<std::size_t> takeNext(Progress& progress) = 0;
  /// A round of the history becomes present.
  virtual void standAt(const IterationSummary& round) = 0;
  /// Floods a round of the history again, away from the flood at hand. False when cancelled.
  virtual bool floodAside(const IterationSummary& round, std::shared_ptr<FloodRecord> record,
                          Progress* progress) const = 0;

  virtual const char* phaseName() const = 0;  ///< of a flood, for the user

  /// The round at hand is the best so far: its labels are kept until a better one comes.
  virtual void keepBest() { bestLabel_ = labels(); }
  /// No flood follows for a while: what is made again quickly may go.
  virtual void rest() {}
  /// What the refinement of the present round's borders is to heed beside seams; null: nothing.
  virtual std::shared_ptr<ChartPrice> price() const { return nullptr; }
  /// The labels that were kept last.
  virtual std::vector<Index> bestLabels() const { return bestLabel_; }

 private:
  enum class Phase {
    Flooding,  ///< a flood is ready or under way
    Flooded,   ///< a round is done and judged, the next one planned
    Refining,  ///< the round to be kept is chosen and its borders are being refined
    Done,
  };

  bool floodDone() const { return taken() == mesh().faceCount(); }
  template <class Step>
  StepOutcome repeat(std::size_t count, const Progress& progress, const Step& step);
  StepOutcome advanceFaces(std::size_t count, Progress& progress);
  bool oneFlood(Progress& progress);
  bool oneIteration(Progress& progress);
  bool completeFlood(Progress& progress);
  bool leaveFlooded(Progress& progress);
  void judgeRound();
  bool finish(Progress& progress);
  bool floodAgain(std::size_t iteration, Progress& progress);

  const char* id_;
  SegmentInputs in_;
  SegmentOptions options_;
  FaceValues faceGauss_;
  std::shared_ptr<FloodRecord> record_;
  Phase phase_ = Phase::Flooding;
  std::size_t iteration_ = 0;  ///< number of the round at hand
  std::size_t best_ = 0;
  std::size_t movedSeeds_ = 0;
  std::vector<Index> bestLabel_, finalLabel_;
  std::vector<IterationSummary> history_;
  StopReason stopReason_ = StopReason::NotStopped;
  std::unique_ptr<BorderRefiner> refiner_;
  std::shared_ptr<const SeamRecord> seamRecord_;
};

}  // namespace chartflood
