#pragma once
/// From the faces of a file to a manifold mesh: cuts polygons into triangles, glues edges, joins
/// vertices at one place, turns faces over, splits what cannot be glued, and says what it did.

#include <memory>

#include "core/model/input_mesh.h"
#include "core/model/mesh.h"

namespace chartflood {

/// No vertices but those that the file itself shares; see buildMesh().
constexpr double kNoWeld = -1;

/// Builds the mesh.
///
/// - Polygons are triangulated over their own corners, see PolygonTriangulator; corners that repeat
///   the one before are dropped. The diagonals of one polygon always glue.
/// - Two triangles are neighbours across an edge only if exactly two triangles use that vertex pair
///   and in opposite directions; every other edge is a border on each of its sides.
/// - Borders along which the file repeats vertices are glued, see weldBorders().
/// - Faces that run against most of their part are turned over where that makes neighbours of them,
///   see orientFaces().
/// - Afterwards every vertex owns exactly one fan of triangles: further fans get a copy of it.
/// - Every repair is counted in Mesh::repairs(), after those of the reader. Faces, their corners
/// and
///   the vertices of the input stay as they are; Mesh::inputCorner() leads to them.
///
/// \param weld how far vertices that are joined may lie apart, in the file's units; 0: not at all,
///   equal bit by bit; kNoWeld: none are joined
/// \throws ReadError when a position is not finite or no triangle is left.
/// Cost: linear, about 0.1 us a triangle.
std::shared_ptr<const Mesh> buildMesh(std::shared_ptr<const InputMesh> input, double weld = 0);

}  // namespace chartflood
