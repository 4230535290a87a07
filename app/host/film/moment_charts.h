#pragma once
/// The charts of the moment that is shown: their labels and figures, kept up to date by the steps
/// between one moment and the next.

#include <cstddef>
#include <memory>
#include <span>

#include "app/host/insight/errand.h"
#include "core/model/chart_stats.h"
#include "core/segment/parts/flood_cursor.h"
#include "core/session/session.h"

namespace chartflood {

/// A near moment is there when the call returns. The way to a far one is gone on another thread
/// while the one before stays; the caller asks again until it has come. Not for several threads.
class MomentCharts {
 public:
  /// `place`: where far moments are made.
  explicit MomentCharts(WorkPlace place);

  /// To a moment of a flood on the mesh of the results; null: all dry.
  void show(const Results& results, const std::shared_ptr<const FloodRecord>& record,
            std::size_t step);
  /// To a moment of the refinement of borders after the flood that the results were made from.
  void showBorders(const Results& results, std::size_t step);
  void clear();

  /// Chart of each face, kNone while dry; empty before the first moment.
  std::span<const Index> labels() const;
  /// Faces and areas of the charts, and their balance; nothing of borders. A new object whenever
  /// the moment is another one; null before the first.
  const std::shared_ptr<const ChartStats>& stats() const { return stats_; }
  /// True for a chart without free faces beside it while there are some elsewhere.
  bool closedOff(Index chart) const;

 private:
  struct Moment {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const GaussArea> gauss;
    std::shared_ptr<const FloodRecord> record;
    std::shared_ptr<const SeamRecord> seams;  ///< null in a flood
    std::size_t step = 0;
    std::size_t charts = 0;  ///< at least so many have figures

    bool operator==(const Moment&) const = default;
  };
  /// A moment that was gone to on another thread.
  struct Arrival {
    Moment moment;
    std::unique_ptr<FloodCursor> cursor;
    std::shared_ptr<const ChartStats> stats;
  };

  void go(const Moment& wanted);
  bool isNear(const Moment& wanted) const;
  void take(const std::shared_ptr<const Mesh>& mesh);
  static Arrival arrive(const Moment& wanted, std::unique_ptr<FloodCursor> cursor);

  WorkPlace place_;
  Moment shown_;
  std::unique_ptr<FloodCursor> cursor_;  ///< at the moment shown
  std::unique_ptr<FloodCursor> spare_;   ///< goes the next far way
  std::shared_ptr<const ChartStats> stats_;
  Errand<Arrival> errand_;
};

}  // namespace chartflood
