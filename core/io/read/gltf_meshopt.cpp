#include "core/io/read/gltf_meshopt.h"

#include <meshoptimizer.h>

namespace chartflood {

namespace {

/// Bytes that one packed byte can become: a vertex block has 2 bits for 16 equal bytes.
constexpr std::size_t kMostExpansion = 64;

/// What the decoders assert instead of checking; "" when all is well.
std::string shapeProblem(const GltfMeshopt& packed, std::size_t size) {
  const bool vertices = packed.mode == "ATTRIBUTES", triangles = packed.mode == "TRIANGLES";
  if (!vertices && !triangles && packed.mode != "INDICES") return "its mode is not known";
  if (vertices && (packed.stride == 0 || packed.stride > 256 || packed.stride % 4 != 0)) {
    return "its elements are of a size that cannot be";
  }
  if (!vertices && packed.stride != 2 && packed.stride != 4) {
    return "its indices are of a size that cannot be";
  }
  if (triangles && packed.count % 3 != 0) return "its corners are no multiple of 3";
  if (packed.count / kMostExpansion * packed.stride > size + packed.stride) {
    return "it counts more elements than it can hold";
  }
  return "";
}

/// "" when the filter was undone.
std::string undoFilter(const GltfMeshopt& packed, void* data) {
  if (packed.filter.empty() || packed.filter == "NONE") return "";
  if (packed.mode != "ATTRIBUTES") return "it has a filter that only vertices can have";
  if (packed.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(data, packed.count, packed.stride);
    return "";
  }
  if (packed.filter == "QUATERNION" && packed.stride == 8) {
    meshopt_decodeFilterQuat(data, packed.count, packed.stride);
    return "";
  }
  if (packed.filter == "OCTAHEDRAL" && (packed.stride == 4 || packed.stride == 8)) {
    meshopt_decodeFilterOct(data, packed.count, packed.stride);
    return "";
  }
  return "its filter is not known";
}

}  // namespace

MeshoptResult decodeMeshopt(const GltfMeshopt& packed, std::string_view bytes) {
  if (std::string problem = shapeProblem(packed, bytes.size()); !problem.empty()) {
    return {"", std::move(problem)};
  }
  std::string data(packed.count * packed.stride, '\0');
  if (packed.count == 0) return {std::move(data), ""};
  const auto* const begin = reinterpret_cast<const unsigned char*>(bytes.data());
  int error = 0;
  if (packed.mode == "ATTRIBUTES") {
    error =
        meshopt_decodeVertexBuffer(data.data(), packed.count, packed.stride, begin, bytes.size());
  } else if (packed.mode == "TRIANGLES") {
    error =
        meshopt_decodeIndexBuffer(data.data(), packed.count, packed.stride, begin, bytes.size());
  } else {
    error =
        meshopt_decodeIndexSequence(data.data(), packed.count, packed.stride, begin, bytes.size());
  }
  if (error == -1) return {"", "it is not of the format that the extension has"};
  if (error != 0) return {"", "its data are broken or cut off"};
  std::string problem = undoFilter(packed, data.data());
  if (!problem.empty()) return {"", std::move(problem)};
  return {std::move(data), ""};
}

}  // namespace chartflood
