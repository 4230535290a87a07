#pragma once
/// One run from seeds to a texture: where it began, how far it has come and what was made of it.
/// Runs change hands as a whole, so that the charts of other values stay at hand.

#include <cstddef>
#include <functional>
#include <memory>

#include "core/model/atlas.h"
#include "core/model/chart_set.h"
#include "core/model/chart_stats.h"
#include "core/model/flood_graph.h"
#include "core/model/flood_record.h"
#include "core/model/gauss_area.h"
#include "core/model/segmentation.h"
#include "core/model/unwrap.h"
#include "core/segment/parts/segmenter.h"
#include "core/session/pipeline/document.h"
#include "core/session/pipeline/flood_history.h"
#include "core/session/pipeline/results.h"
#include "core/session/pipeline/run_set.h"

namespace chartflood {

/// How much work charts are worth.
enum class Depth {
  Sketch,  ///< few rounds, few cuts, few steps of the unwrap: for a look while values are dragged
  Whole,
};

/// The stages after the labels: what each was made from tells whether it is up to date.
struct FlatStages {
  std::shared_ptr<const Segmentation> of;  ///< whose charts these are
  Parameters parameters;                   ///< that they were made with
  std::shared_ptr<const ChartSet> cut;     ///< before relief cuts
  std::shared_ptr<const ChartSet> charts;  ///< with them
  std::shared_ptr<const Unwrap> unwrap;
  std::shared_ptr<const Atlas> atlas;
};

struct ChartRun {
  Document document;  ///< whose charts these are
  Depth depth = Depth::Whole;
  std::shared_ptr<const GaussArea> gauss;   ///< that it began with
  std::shared_ptr<const FloodGraph> graph;  ///< the same
  std::uint64_t gaussVersion = 0;
  FloodStart start;  ///< of the last flood, to go on from; without seeds: place anew
  std::unique_ptr<Stepper> stepper;
  /// What the stepper tells of floods; it goes where the stepper goes.
  std::shared_ptr<std::function<void(const FloodBegun&)>> onFlood;
  bool locksChanged = false;                         ///< since the stepper was made
  std::shared_ptr<const Segmentation> segmentation;  ///< last one measured
  std::shared_ptr<const ChartStats> stats;           ///< of `segmentation`
  FlatStages flat;           ///< being made; parts are null from the first stale one on
  FlatStages shownFlat;      ///< the last complete one
  bool unwrapAsked = false;  ///< of the present charts
  std::shared_ptr<const RunSet> seedRuns;    ///< of the present charts
  std::shared_ptr<const FloodRecord> flood;  ///< log of the last flood
  std::size_t floodRound = 0;                ///< that it was begun as
  std::size_t roundsSeen = 0;                ///< rounds of the stepper's history at the last look
  FloodHistory floods;
  Timing timing;

  bool finished() const { return stepper != nullptr && stepper->finished(); }
  /// From which the charts can be made again.
  FloodMoment moment() const;
};

/// Whether finished charts of one document are those of the other: what differs acts on them later
/// or not at all.
bool sameCharts(const Document& a, const Document& b);

/// Whether values of stages from `first` to `last` differ.
bool differWithin(const Parameters& a, const Parameters& b, Stage first, Stage last);

}  // namespace chartflood
