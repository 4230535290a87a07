#pragma once
/// The stages from mesh to charts with what each depends on: a change recomputes the first stage
/// that it touches and those after it, and nothing else.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/model/flood_graph.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/segment/parts/segmenter.h"
#include "core/session/pipeline/chart_run.h"
#include "core/session/pipeline/flood_history.h"
#include "core/session/pipeline/kept_runs.h"
#include "core/session/pipeline/results.h"
#include "core/session/pipeline/run_set.h"
#include "core/session/settings/parameters.h"

namespace chartflood {

/// Driven by one thread. Holds the newest value of every stage.
class Pipeline {
 public:
  /// Told when something new can be shown.
  struct Listener {
    std::function<void(const FloodBegun&)> onFlood;
    std::function<void(Notice)> onNotice;
  };
  explicit Pipeline(Listener listener) : listener_(std::move(listener)) {}

  /// Before the first stepper is made.
  void setFloodLogs(FloodLogs logs) { logs_ = logs; }
  bool hasMesh() const { return mesh_ != nullptr; }
  /// The newest values.
  const Document& document() const { return document_; }
  /// Whether seeds and hints of the document lost their meaning since the last call.
  bool takeVoidSeeds() { return std::exchange(seedsVoid_, false); }
  /// Replaces the mesh and computes its Gauss area; charts are gone.
  void setMesh(std::shared_ptr<const Mesh> mesh, double readMilliseconds, Progress& progress);

  /// Takes new values and brings Gauss area and flood graph up to date. With `live`, when there are
  /// charts, they are flooded once more from the present seeds. False when labels and Gauss areas
  /// stay as they are.
  bool apply(const Document& document, bool live, Progress& progress);

  /// Takes new values and makes their finished charts: whole ones are those of a batch run with the
  /// same values, the same bytes; sketches begin from the present seeds. The old charts stay until
  /// then, and where a call is cancelled. False when the charts are as they were.
  bool explore(const Document& document, Depth depth, Progress& progress);
  /// True when these charts are no batch run's: sketches, or of earlier values.
  bool unsettled() const {
    return finished() && (!standing() || !sameCharts(run_.document, document_));
  }

  /// Takes new values and floods once from the moment's seeds and offsets, as far as it had come.
  /// False where they are at hand, measured and all.
  bool restore(const Document& document, const FloodMoment& moment, Progress& progress);

  StepOutcome step(StepUnit unit, std::size_t count, Progress& progress);
  void restartFlood();
  /// Forgets the present seeds: the next flood begins from the first ones.
  void resetSeeds();
  StepOutcome adopt(std::size_t iteration, Progress& progress);
  /// Makes the dropped log of a finished round again, for looking at.
  void recall(std::size_t iteration, Progress& progress);

  /// Takes a picture of the present labels and measures their charts.
  void measure();

  /// Lays the charts as last measured flat, from the first stage on that is not up to date. False
  /// when cancelled; the stages that were finished stay. \pre complete()
  bool unwrap(Progress& progress);
  /// True when every face has a chart and the charts are up to date.
  bool complete() const { return !stale() && run_.segmentation && run_.segmentation->complete; }
  /// True when charts that are or were laid flat, or that a stop rule has finished, await it.
  bool awaitsUnwrap() const;
  /// True when going to the end means to try several generator seeds: where the parameters ask for
  /// it and seeds are left to chance.
  bool triesSeeds() const;
  /// Runs to the end with each of the generator seeds on a thread of its own, and goes on with the
  /// one of the shortest seams among the balanced. The charts of a cancelled call are the old ones.
  StepOutcome stepWithSeeds(Progress& progress);
  /// Looks for the shortest seams with which no chart stretches more than allowed, over numbers of
  /// charts and relief cuts; the present charts stay. False when cancelled.
  bool findChartCount(Progress& progress);
  /// Copies what is known into `results`, the labels and figures as last measured.
  void report(Results& results) const;
  /// The part of report() that tells of the rounds of the run.
  void reportRounds(Results& results) const;
  /// True when charts are shown that later values have made stale.
  bool stale() const {
    return run_.segmentation != nullptr && (run_.stepper == nullptr || overtaken_);
  }

 private:
  bool finished() const { return run_.finished(); }
  /// True when the present charts are finished, whole and of the present values.
  bool standing() const { return finished() && !overtaken_ && run_.depth == Depth::Whole; }
  /// K as asked for or as the model's features have it, before parts raise it.
  std::size_t wantedCharts() const { return chartsInForce(document_.parameters, features_); }
  /// True when the stepper holds the charts of the moment already.
  bool standsAt(const FloodMoment& moment) const;
  bool isFlat() const;
  /// The first step of unwrap(): cutting into disks.
  bool cutOpen(Progress& progress);
  /// The first two steps: cutting and laying flat.
  bool layFlat(Progress& progress);
  /// Whether a run whose charts are cut open is worth to be laid flat.
  using Worth = std::function<bool(const Run&)>;
  /// A pipeline of the same mesh that begins anew, run to the end and laid flat where that is
  /// worth it; null when cancelled.
  std::unique_ptr<Pipeline> runApart(const Parameters& parameters, const Worth& worth,
                                     Progress& progress) const;
  /// The figures of such a pipeline, as a run.
  Run asRun(bool withResults) const;
  std::vector<std::unique_ptr<Pipeline>> runAll(std::span<const Parameters> each,
                                                const Worth& worth, Progress& progress) const;
  /// One search for the number of charts; see pipeline_search.cpp.
  class ChartSearch;
  /// A pipeline of the same mesh that begins anew with the present values.
  std::unique_ptr<Pipeline> sibling(Listener listener) const;
  /// Brings Gauss area and flood graph up to date with values that came after `before`.
  void makeGround(const Parameters& before, Progress& progress);
  /// A finished run becomes the present one.
  void takeOver(ChartRun run);
  /// Takes the finished charts out of the way, for coming back to them. What they leave to look at
  /// and to go on from stays.
  void setAside();
  /// The seeds that a sketch of the present values begins with; none: their own.
  std::vector<Index> seedsAtHand() const;
  /// Forgets the flat stages that do not belong to the present labels and parameters.
  void dropStaleFlat();
  void tellNotFlat() const;
  void tellMargin() const;
  void takeMesh(std::shared_ptr<const Mesh> mesh);
  /// Builds the mesh anew from the same file with the present parameters.
  void glueAnew(Progress& progress);
  void tellAboveLimit() const;
  void makeGaussArea(Progress& progress);
  void makeGraph(Progress& progress);
  /// Forgets of the present seeds what does not hold for the new values.
  void reviseSeeds(const Document& before);
  void dropNewestSeeds(std::size_t wanted);
  /// Whether charts that are made now begin from creases, and with which generator seed: not where
  /// seeds are placed by hand.
  std::optional<std::uint32_t> wantsCreases() const;
  /// What a stepper that is made now begins with when it is to search fast.
  std::optional<FastFlood> wantsFast() const;
  /// Makes a stepper that begins with the present seeds, if there are any.
  void makeStepper(std::size_t maxIterations);
  void makeStepper(std::size_t maxIterations, std::optional<std::uint32_t> creases,
                   const std::optional<FastFlood>& fast);
  /// Begins again where the stepper stands, so that the next rounds know of changed locks.
  void takeLocks(Progress& progress);
  void noteFlood(const FloodBegun& begun);
  /// Keeps the log of the last flood where that is done.
  void keepFlood();
  void tell(Notice::Kind kind, std::string text) const;
  void tellChartCount();
  void tellParts(std::size_t wanted, const std::string& number);
  void tellTooSmall();
  void tellOutcome();

  Listener listener_;
  Document document_;
  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const GaussArea> gauss_;
  std::shared_ptr<const FloodGraph> graph_;
  ChartRun run_;
  Depth depth_ = Depth::Whole;               ///< of steppers that are made now
  bool overtaken_ = false;                   ///< values have come whose charts were not made yet
  KeptRuns kept_;                            ///< other runs on the mesh
  std::shared_ptr<const RunSet> chartRuns_;  ///< of the mesh
  FloodLogs logs_ = FloodLogs::EveryRound;
  bool tellsOutcome_ = true;    ///< says why a run has ended; an answer to values is no event
  bool seedsVoid_ = false;      ///< the mesh was built anew with other faces
  std::size_t toldCharts_ = 0;  ///< changed K that the user was told of
  bool toldLiteral_ = false;    ///< the user was told that the mesh is too small to search fast
  std::size_t features_ = 0;    ///< of the mesh, see featureCount()
  std::uint64_t meshVersion_ = 0, gaussVersion_ = 0;
};

}  // namespace chartflood
