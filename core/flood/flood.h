#pragma once
/// One t-flooding round: charts grow from their seeds, the one with the least Gauss area next
/// (paper section 3.3, the multi-heap flood with lookahead).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/model/flood_graph.h"
#include "core/model/flood_record.h"

namespace chartflood {

/// Operation counts of a flood, for benchmarks and tests of cost.
struct FloodCounts {
  std::uint64_t takes = 0;
  std::uint64_t pushes = 0;
  std::uint64_t pops = 0;         ///< includes faces that another chart had taken
  std::uint64_t relaxations = 0;  ///< distances lowered by the last farthestFromBorder()
};

/// When a face may enter a chart's heap.
enum class OfferRule {
  FirstIncidence,  ///< once, when the chart first touches it: the paper's rule
  ShortestTimes,   ///< each time a neighbour is taken; the earliest time counts
};

/// A flood that can stop after any face and go on. Keeps its buffers between rounds.
class Flood {
 public:
  virtual ~Flood() = default;

  /// Dry mesh, seeds chosen, nothing taken. `seeds` are distinct faces, one a chart; `offsets` (in
  /// steradians, one a chart) delay charts against each other (section 3.5). With `lookahead`
  /// the gain of a chart's next face counts before it is taken. `record`, when given, receives
  /// every incorporation and must outlive the round.
  virtual void start(std::span<const Index> seeds, std::span<const double> offsets, bool lookahead,
                     std::shared_ptr<FloodRecord> record) = 0;

  /// Takes up to `count` more faces; returns how many it took. Stops early when `progress` is
  /// cancelled or no chart can grow.
  virtual std::size_t advance(std::size_t count, Progress* progress) = 0;

  /// True when no chart can grow any more.
  virtual bool finished() const = 0;
  virtual std::size_t taken() const = 0;
  /// Chart of each face, kNone while free.
  virtual void copyLabels(std::vector<Index>& labels) const = 0;
  virtual const FloodCounts& counts() const = 0;

  /// For each chart the face farthest from the chart's border (section 3.4), measured over the
  /// dual graph inside the chart with the delays as lengths: border faces, which touch another
  /// chart or the mesh border, have distance 0. A seed that is among the farthest stays, else ties
  /// go to the lowest face; a chart without border keeps its seed. Call it on a finished flood.
  virtual std::vector<Index> farthestFromBorder(std::span<const Index> seeds) = 0;
};

/// A flood over `graph`, which must outlive it, with room for `chartCount` charts.
/// \pre graphs for shortest times have the layout of arcs
std::unique_ptr<Flood> makeFlood(const FloodGraph& graph, std::size_t chartCount,
                                 OfferRule rule = OfferRule::FirstIncidence);

}  // namespace chartflood
