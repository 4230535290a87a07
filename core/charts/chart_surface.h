#pragma once
/// Takes charts out of a mesh, opens them along edges, and tells their topology. The cutters are
/// made of these.

#include <span>
#include <vector>

#include "core/model/chart_surface.h"
#include "core/model/mesh.h"

namespace chartflood {

/// The surface of every chart, in the order of their numbers. Faces without a chart are left out.
/// \param label chart of each face of the mesh, below `chartCount` or kNone
/// Cost: linear in the number of triangles.
std::vector<ChartSurface> extractCharts(const Mesh& mesh, std::span<const Index> label,
                                        std::size_t chartCount);

/// Opens the surface along the edges of the given sides (either side of an edge may stand for it;
/// boundary sides are ignored) and gives every fan its own vertex. Vertices keep their numbers;
/// copies are added at the end. Cost: linear in the size of the surface.
/// \pre no side is a diagonal
void openAlong(ChartSurface& surface, std::span<const Index> sides);

ChartTopology topologyOf(const ChartSurface& surface);

/// The boundary loops: sides in order along each, the surface on their left; the loop with the
/// smallest side first.
std::vector<std::vector<Index>> boundaryLoops(const ChartSurface& surface);

/// Length of an edge, normalised units.
double sideLength(const ChartSurface& surface, Index side);

}  // namespace chartflood
