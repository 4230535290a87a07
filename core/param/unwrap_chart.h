#pragma once
/// Lays one disk flat, with relief cuts where it would stretch too much.

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
};

/// Lays a chart flat. Relief cuts are appended to it, at most 8.
/// \return anything when cancelled
FlatChart unwrapChart(CutChart& chart, const UnwrapOptions& options, const Progress& progress);

}  // namespace chartflood
