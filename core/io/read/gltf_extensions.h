#pragma once
/// What an extension of glTF means for the geometry.

#include <string_view>

#include "core/io/read/gltf_json.h"

namespace chartflood {

/// Whether a file that requires the extension can be read: it is read here, is known to leave the
/// geometry alone (materials, metadata, poses, visibility), or does not stand on any part that
/// geometry is made of.
/// \param file all of it
bool leavesGeometryReadable(std::string_view extension, const GltfJson& file);

}  // namespace chartflood
