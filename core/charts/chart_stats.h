#pragma once
/// Figures of every chart of a segmentation.

#include "core/model/chart_stats.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"

namespace chartflood {

/// Measures the charts: sizes, borders, topology, and the spread of their Gauss areas. Faces
/// without a chart are left out. Each chart is taken as a surface of its own: its triangles glued
/// across the edges that have both their triangles in the chart. Cost: linear in the number of
/// triangles.
ChartStats measureCharts(const Mesh& mesh, const Segmentation& segmentation);

}  // namespace chartflood
