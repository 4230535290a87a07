#pragma once
/// What happens to the borders of charts after a method is done, the same for all methods.

#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/model/seam_record.h"
#include "core/segment/borders/border_moves.h"
#include "core/segment/borders/seam_cuts.h"
#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// Refines labels as `RefineOptions` ask: by seam cuts, after which single faces even out what is
/// left of the imbalance, where that costs little length; by single faces alone; or not at all.
class BorderRefiner {
 public:
  /// \param seeds faces that keep their chart; one a chart, or none at all
  BorderRefiner(const SegmentInputs& inputs, std::span<const double> faceGauss,
                std::vector<Index> label, std::size_t charts, std::vector<Index> seeds,
                const RefineOptions& options);

  /// Works until done or `progress` is cancelled; true when done. A cancelled run goes on where it
  /// stopped.
  bool run(Progress& progress);

  std::span<const Index> labels() const { return label_; }
  /// What was done, step by step; null before run() is done and when nothing was to do.
  std::shared_ptr<const SeamRecord> record() const { return record_; }

 private:
  void beginMoves();
  void evenOutAfterCuts();
  void finishRecord();

  SegmentInputs in_;
  std::span<const double> faceGauss_;
  RefineOptions options_;
  std::vector<Index> label_;
  std::vector<Index> start_;  ///< labels before moves without cuts
  std::size_t charts_;
  std::vector<Index> seeds_;
  std::unique_ptr<SeamCuts> cuts_;
  std::unique_ptr<BorderMoves> moves_;
  std::shared_ptr<const SeamRecord> record_;
  bool done_ = false;
};

}  // namespace chartflood
