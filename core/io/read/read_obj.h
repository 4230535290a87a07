#pragma once
/// Wavefront OBJ: vertices and faces; curves, materials and texture coordinates are left aside.

#include "core/io/text/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads `v` and `f` lines. Faces may name vertices that follow later, from the end with negative
/// numbers, and texture coordinates and normals in any of the usual forms, which only count when
/// they name something that does not exist (said in the repairs).
/// \throws ReadError with the line: a coordinate or index that is not a number, an index that names
///   no vertex, or a file without faces.
InputMesh readObj(const Source& source);

}  // namespace chartflood
