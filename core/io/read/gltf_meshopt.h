#pragma once
/// Views of a glTF file that meshoptimizer compressed (EXT_meshopt_compression).

#include <string>
#include <string_view>

#include "core/io/read/gltf_document.h"

namespace chartflood {

struct MeshoptResult {
  std::string bytes;    ///< `count` elements of `stride` bytes
  std::string refusal;  ///< why there are none, as a part of a sentence
};

/// Unpacks a view. Safe for hostile data: nothing larger than the packed bytes can be worth is
/// asked of memory.
MeshoptResult decodeMeshopt(const GltfMeshopt& packed, std::string_view bytes);

}  // namespace chartflood
