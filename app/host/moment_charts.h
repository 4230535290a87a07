#pragma once
/// The charts of the moment that is shown: their labels and figures, kept up to date by the steps
/// between one moment and the next.

#include <cstddef>
#include <memory>
#include <span>

#include "core/model/chart_stats.h"
#include "core/segment/flood_cursor.h"
#include "core/session/session.h"

namespace chartflood {

class MomentCharts {
 public:
  /// To a moment of a flood on the mesh of the results; null: all dry.
  void show(const Results& results, const std::shared_ptr<const FloodRecord>& record,
            std::size_t step);
  /// To a moment of the refinement of borders after the flood that the results were made from.
  void showBorders(const Results& results, std::size_t step);
  void clear();

  /// Chart of each face, kNone while dry.
  std::span<const Index> labels() const;
  /// Faces and areas of the charts, and their balance; nothing of borders. A new object whenever
  /// the moment is another one; null before the first.
  const std::shared_ptr<const ChartStats>& stats() const { return stats_; }
  /// True for a chart without free faces beside it while there are some elsewhere.
  bool closedOff(Index chart) const;

 private:
  bool prepare(const Results& results);
  void count(std::size_t charts);

  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const GaussArea> gauss_;
  std::shared_ptr<const FloodRecord> record_;
  std::shared_ptr<const SeamRecord> seams_;  ///< null in a flood
  std::size_t step_ = 0;
  std::unique_ptr<FloodCursor> cursor_;
  std::shared_ptr<const ChartStats> stats_;
};

}  // namespace chartflood
