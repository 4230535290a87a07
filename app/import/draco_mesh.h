#pragma once
/// Triangles that Draco compressed.

#include <cstddef>
#include <string_view>

#include "core/io/read/gltf_geometry.h"

namespace chartflood {

/// Unpacks a mesh. Draco asks for as much memory as the data claim to need: another reason why it
/// belongs into this program, which has limits.
/// \param position unique number of the attribute that has the positions; kNoPart: the one that
///   says so
DracoMesh decodeDraco(std::string_view bytes, std::size_t position);

}  // namespace chartflood
