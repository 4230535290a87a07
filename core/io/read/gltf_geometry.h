#pragma once
/// The triangles of one mesh of a glTF file, before any node places it.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/io/read/gltf_accessor.h"

namespace chartflood {

struct GltfGeometry {
  std::vector<glm::dvec3> positions;
  std::vector<Index> corners;       ///< three a triangle
  std::size_t otherPrimitives = 0;  ///< of points and lines, left out
};

/// What came of compressed triangles; `refusal` tells why there are none.
struct DracoMesh {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> corners;
  std::string refusal;
};

/// Unpacks Draco's bytes; the number is that of the attribute with the positions.
using DracoDecoder = std::function<DracoMesh(std::string_view bytes, std::size_t position)>;

/// Reads the mesh's primitives in their order. Primitives that share an accessor share its
/// vertices.
/// \param draco may be empty where no primitive is compressed with Draco
/// \throws ReadError
GltfGeometry readGltfGeometry(const GltfData& data, std::size_t mesh, const DracoDecoder& draco);

/// Whether reading the primitive takes the Draco decoder: it has no plain data beside.
bool needsDraco(const GltfDocument& document, const GltfPrimitive& primitive);

}  // namespace chartflood
