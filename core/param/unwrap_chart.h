#pragma once
/// Lays one disk flat, with relief cuts where it would stretch too much.

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/model/chart_set.h"
#include "core/model/unwrap.h"
#include "core/param/stretch.h"
#include "core/param/unwrap_charts.h"

namespace chartflood {

/// A flat chart with the distortion of each of its triangles.
struct FlatChart {
  ChartUv chart;
  std::vector<TriangleDistortion> triangles;  ///< empty when not laid flat
  std::optional<CutChart> relieved;           ///< the chart with its relief cuts, if it got any
};

/// Lays a chart flat, with relief cuts while it stretches more than reliefLimit().
/// \return anything when cancelled
FlatChart unwrapChart(const CutChart& chart, const UnwrapOptions& options,
                      const Progress& progress);

}  // namespace chartflood
