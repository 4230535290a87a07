#pragma once
/// Formats that the import library opens: FBX, Collada, 3DS and more.

#include <string_view>

#include "core/io/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads every mesh of the scene with the nodes' transforms applied; polygons are kept. Corners
/// with exactly the same coordinates become one vertex, because the library gives each face corners
/// of its own. Materials, pictures and poses are left aside; no other file is opened. \param
/// extension lower case, without the dot: how the library knows the format \throws ReadError with
/// what the library says
InputMesh readAssimp(const Source& source, std::string_view extension);

}  // namespace chartflood
