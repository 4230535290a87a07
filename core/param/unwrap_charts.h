#pragma once
/// Lays every chart flat (paper section 4).

#include <memory>

#include "core/base/progress.h"
#include "core/model/chart_set.h"
#include "core/model/mesh.h"
#include "core/model/unwrap.h"

namespace chartflood {

struct UnwrapOptions {
  enum class Boundary {
    Circle,  ///< the boundary on a circle by arc length, the inside conformal, as in the paper
    Free,    ///< no flips, no overlap, as little stretch as the program can reach
  };
  Boundary boundary = Boundary::Free;
  double reliefStretch = 1.5;  ///< L2 stretch from which a chart is slit; 0: never

  /// Free maps after fewer steps where these do, for a look while values are dragged.
  bool sketch = false;

  bool operator==(const UnwrapOptions&) const = default;
};

/// The L2 stretch that relief cuts are to keep each chart to: that of the options, and four times
/// as much for circles, which squeeze every boundary.
double reliefLimit(const UnwrapOptions& options);

struct UnwrapResult {
  std::shared_ptr<const ChartSet> charts;  ///< the given ones, with relief cuts added
  std::shared_ptr<const Unwrap> unwrap;    ///< of `charts`
};

/// Lays flat every chart that is a disk; others say why not in ChartUv::problem. The charts are
/// independent of each other and shared out over the threads; results do not depend on their
/// number. \return nothing in both members when cancelled
UnwrapResult unwrapCharts(const Mesh& mesh, const std::shared_ptr<const ChartSet>& charts,
                          const UnwrapOptions& options, Progress& progress);

}  // namespace chartflood
