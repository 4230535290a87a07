#pragma once
/// Numbers out of the buffers of a glTF file, every access checked.

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/io/source.h"

namespace tinygltf {
class Model;
}

namespace chartflood {

/// The positions of an accessor of 3-vectors, floats or quantized, sparse entries applied.
/// \throws ReadError when it is none or reaches outside of its buffer.
std::vector<glm::dvec3> gltfPositions(const Source& source, const tinygltf::Model& model,
                                      int accessor);

/// The whole numbers of an accessor of unsigned scalars. \throws ReadError
std::vector<std::uint32_t> gltfIndices(const Source& source, const tinygltf::Model& model,
                                       int accessor);

}  // namespace chartflood
