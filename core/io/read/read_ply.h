#pragma once
/// Stanford PLY: ASCII and both byte orders, any property types.

#include "core/io/text/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads x, y, z of the element "vertex", and faces from the element "face" (list vertex_indices or
/// vertex_index) or "tristrips" (-1 begins a new strip; every triangle of three different vertices
/// becomes a face). Every other element and property is passed over.
/// \throws ReadError with line or byte; also when the header counts more than the file holds.
InputMesh readPly(const Source& source);

}  // namespace chartflood
