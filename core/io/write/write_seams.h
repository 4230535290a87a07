#pragma once
/// Seams as lines, for programs that mark edges.

#include <string>

#include "core/io/write/charted_mesh.h"

namespace chartflood {

/// OBJ with the vertices of the input, same number and order, and one line `l a b` for each edge
/// along which the surface is open: under `g seams` where two charts meet (or where gluing had to
/// part faces that share an edge of the file), under `g cuts` where a chart is cut. Open borders of
/// the mesh are no seams. Vertices that reading joined are named by the first of them.
/// Cost: linear. \pre as chartPlaces()
std::string seamsText(const ChartedMesh& charted);

}  // namespace chartflood
