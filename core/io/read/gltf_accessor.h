#pragma once
/// Numbers out of the buffers of a glTF file, every access checked.

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/io/read/gltf_buffers.h"
#include "core/io/read/gltf_document.h"
#include "core/io/text/source.h"

namespace chartflood {

/// A glTF file as far as its numbers are concerned.
struct GltfData {
  const Source& source;
  const GltfDocument& document;
  GltfBuffers& buffers;
};

/// The positions of an accessor of 3-vectors, floats or quantized, sparse entries applied.
/// \throws ReadError when it is none or reaches outside of its buffer.
std::vector<glm::dvec3> gltfPositions(const GltfData& data, std::size_t accessor);

/// The 4-vectors of an accessor, as gltfPositions(). \throws ReadError
std::vector<glm::dvec4> gltfRotations(const GltfData& data, std::size_t accessor);

/// The whole numbers of an accessor of unsigned scalars. \throws ReadError
std::vector<std::uint32_t> gltfIndices(const GltfData& data, std::size_t accessor);

}  // namespace chartflood
