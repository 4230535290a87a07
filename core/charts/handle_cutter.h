#pragma once
/// HandleCutter (paper section 3.6): opens the handles of a chart.

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/model/chart_set.h"
#include "core/model/handle_record.h"

namespace chartflood {

/// How loops to cut are found.
enum class HandleSearch : std::uint8_t {
  Shortest,   ///< always the shortest loop of edges that goes around a handle
  Wavefront,  ///< the paper's growing region and the loops that its fronts remember
};

/// Opens the surface until no handle is left. Each handle takes one cut with reason Handle: a
/// closed curve, or an arc between two points of one boundary loop, that does not part the chart
/// and lowers the number of handles by one. Where the way around a handle is shorter across several
/// boundary loops, arcs with reason Loop join these first. \param seed of the random face from
/// which the wavefront grows \pre the surface is in one piece Stops early when cancelled. Handles
/// that only go along diagonals of polygons stay.
std::vector<Cut> cutHandles(ChartSurface& surface, HandleSearch search, std::uint32_t seed,
                            const Progress& progress);

/// The wavefront's way over a chart, which is not changed, step by step; its cuts are those of
/// cutHandles() with the same seed. The region grows over the whole chart even where there is no
/// handle. An unfinished record when cancelled; no steps for a chart with polygons that are no
/// disks.
/// \pre the surface is in one piece
HandleRecord recordHandleCutter(const ChartSurface& surface, std::uint32_t seed,
                                const Progress& progress);

}  // namespace chartflood
