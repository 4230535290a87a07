#pragma once
/// 3MF: packages of slicers and CAD programs.

#include "core/io/text/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads what the file builds, item by item, with the transforms of items and components; objects
/// in other parts of the package too (production extension). Where it builds nothing, all objects
/// that are no component of another. Coordinates are in the unit of the main part. Pictures,
/// colours, slices and settings are left aside; beams and boolean shapes are counted in the
/// repairs. \throws ReadError with part and line
InputMesh read3mf(const Source& source);

}  // namespace chartflood
