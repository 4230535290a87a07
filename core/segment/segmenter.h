#pragma once
/// The small interface that every segmentation method implements.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/model/flood_record.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"

namespace chartflood {

struct FloodGraph;

/// How far one call goes.
enum class StepUnit {
  Face,   ///< count incorporations; a finished flood goes on with the next one
  Flood,  ///< to the end of the present flood (of the next one when it is complete), count times
  Iteration,  ///< finish the present flood, move the seeds and flood again, count times
  Converged,  ///< until a stop rule fires, then refine the borders of the best round
};

enum class StepOutcome {
  Advanced,   ///< went as far as asked
  Finished,   ///< a stop rule fired: stopReason() says which
  Cancelled,  ///< asked to stop; the state is valid and can go on
};

/// A segmentation under way. One thread drives it; what it hands out is immutable (records grow)
/// and may be read by any thread. However the way is cut into calls, the results are equal.
class Stepper {
 public:
  virtual ~Stepper() = default;

  virtual StepOutcome advance(StepUnit unit, std::size_t count, Progress& progress) = 0;

  /// The labels as they are now; after Finished the final ones.
  virtual std::shared_ptr<const Segmentation> state() const = 0;
  /// Log of the present flood. Grows while advance() runs.
  virtual std::shared_ptr<const FloodRecord> record() const = 0;
  /// Finished rounds, oldest first.
  virtual std::span<const IterationSummary> history() const = 0;
  /// Index into history() of the best round so far; 0 when there is none yet.
  virtual std::size_t bestIteration() const = 0;
  virtual StopReason stopReason() const = 0;
};

}  // namespace chartflood
