#pragma once
/// A chart seen from afar: the same shape in fewer triangles, on which many maps can be tried.

#include <cstddef>

#include "core/model/chart_surface.h"

namespace chartflood {

/// Takes inner vertices of a disk out one by one, where the shape changes least (Garland and
/// Heckbert 1997, "Surface simplification using quadric error metrics"), each moved onto a
/// neighbour, until about `triangles` are left or no more can go. The boundary stays as it is, and
/// so does the disk. Vertices of the answer stand where vertices of the chart do: `meshVertex`
/// names these. Cost: n log n.
ChartSurface coarseChart(const ChartSurface& chart, std::size_t triangles);

}  // namespace chartflood
