#pragma once
/// Stereolithography files, binary and ASCII.

#include "core/io/text/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads the triangles, and polygons where a text has them; corners with exactly the same
/// coordinates become one vertex, in the order in which they are met. Stored normals are left
/// aside. \throws ReadError with line or byte; also when the file has fewer triangles than its
/// header says.
InputMesh readStl(const Source& source);

/// Whether the length of a file fits the triangle count in it, as in a binary STL file.
bool looksLikeBinaryStl(std::string_view bytes);

}  // namespace chartflood
