#pragma once
/// From the faces of a file to a manifold mesh: fans polygons, glues edges, splits what cannot be
/// glued, and says what it did.

#include <memory>

#include "core/model/input_mesh.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Builds the mesh.
///
/// - Polygons are fanned from their first corner; triangles that repeat a vertex are dropped.
/// - Two triangles are neighbours across an edge only if exactly two triangles use that vertex pair
///   and in opposite directions; every other edge is a border on each of its sides. The diagonals
///   of one polygon always glue.
/// - Afterwards every vertex owns exactly one fan of triangles: further fans get a copy of it.
/// - Every repair is counted in Mesh::repairs(), after those of the reader.
///
/// \throws ReadError when a position is not finite or no triangle is left.
/// Cost: linear, about 0.1 us a triangle.
std::shared_ptr<const Mesh> buildMesh(std::shared_ptr<const InputMesh> input);

}  // namespace chartflood
