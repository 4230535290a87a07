#pragma once
/// The vertices of the input, repeated where charts need them with several texture coordinates.

#include <vector>

#include "core/io/write/charted_mesh.h"

namespace chartflood {

struct SplitVertices {
  std::vector<Index> copyOf;  ///< input vertex of each vertex behind those of the input
  std::vector<Index> place;   ///< of each vertex, copies last; kNone where none is known
  std::vector<Index> chart;   ///< that the place belongs to
  std::vector<Index> corner;  ///< vertex of each corner of the input
};

/// Every vertex gets one place at most. The first corner that needs an input vertex keeps its
/// number; corners without a place, or with one in a chart that is not laid flat, always do.
/// Cost: linear in the corners, times the copies of a vertex (few).
SplitVertices splitVertices(const ChartedMesh& charted, const ChartPlaces& places);

}  // namespace chartflood
