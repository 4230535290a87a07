#include "core/io/read/gltf_geometry.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace chartflood {

namespace {

bool hasTriangles(const GltfPrimitive& primitive) {
  const auto mode = static_cast<GltfMode>(primitive.mode);
  const bool known =
      mode == GltfMode::Triangles || mode == GltfMode::Strip || mode == GltfMode::Fan;
  return known && (primitive.position != kNoPart || primitive.draco);
}

class GeometryReader {
 public:
  GeometryReader(const GltfData& data, const DracoDecoder& draco) : data_(data), draco_(draco) {}

  void add(const GltfPrimitive& primitive);
  GltfGeometry take() { return std::move(out_); }

 private:
  void addDraco(const GltfDraco& draco);
  void addTriangles(GltfMode mode, const std::vector<std::uint32_t>& corners, Index offset);
  Index append(const std::vector<glm::dvec3>& positions);
  void requireVertices(const std::vector<std::uint32_t>& corners, std::size_t count) const;

  const GltfData& data_;
  const DracoDecoder& draco_;
  GltfGeometry out_;
  /// First vertex and number of vertices of each accessor of positions.
  std::map<std::size_t, std::pair<Index, std::size_t>> known_;
};

Index GeometryReader::append(const std::vector<glm::dvec3>& positions) {
  if (positions.size() >= kNone - out_.positions.size()) {
    data_.source.fail("it has too many vertices");
  }
  const auto first = static_cast<Index>(out_.positions.size());
  out_.positions.insert(out_.positions.end(), positions.begin(), positions.end());
  return first;
}

void GeometryReader::requireVertices(const std::vector<std::uint32_t>& corners,
                                     std::size_t count) const {
  for (const std::uint32_t corner : corners) {
    if (corner < count) continue;
    data_.source.fail("a face names vertex " + std::to_string(corner) + " but there are " +
                      std::to_string(count) + " (counted from 0)");
  }
}

void GeometryReader::add(const GltfPrimitive& primitive) {
  if (!hasTriangles(primitive)) {
    ++out_.otherPrimitives;
    return;
  }
  if (needsDraco(data_.document, primitive)) return addDraco(*primitive.draco);
  auto known = known_.find(primitive.position);
  if (known == known_.end()) {
    const std::vector<glm::dvec3> positions = gltfPositions(data_, primitive.position);
    const std::pair place(append(positions), positions.size());
    known = known_.emplace(primitive.position, place).first;
  }
  const auto [first, count] = known->second;
  std::vector<std::uint32_t> corners;
  if (primitive.indices != kNoPart) {
    corners = gltfIndices(data_, primitive.indices);
    requireVertices(corners, count);
  } else {
    corners.resize(count);
    std::iota(corners.begin(), corners.end(), 0u);
  }
  addTriangles(static_cast<GltfMode>(primitive.mode), corners, first);
}

/// Whatever the mode says, what Draco unpacks is a list of triangles.
void GeometryReader::addDraco(const GltfDraco& draco) {
  const std::string_view bytes = data_.buffers.view(draco.view, "its compressed geometry");
  const DracoMesh mesh = draco_(bytes, draco.position);
  if (!mesh.refusal.empty()) {
    data_.source.fail("its geometry is compressed (KHR_draco_mesh_compression) and cannot be "
                      "unpacked: " +
                      mesh.refusal);
  }
  requireVertices(mesh.corners, mesh.positions.size());
  addTriangles(GltfMode::Triangles, mesh.corners, append(mesh.positions));
}

/// The triangles of a list, strip or fan.
void GeometryReader::addTriangles(GltfMode mode, const std::vector<std::uint32_t>& corners,
                                  Index offset) {
  const bool list = mode == GltfMode::Triangles, fan = mode == GltfMode::Fan;
  if (list && corners.size() % 3 != 0) {
    data_.source.fail("it has a list of triangles with " + std::to_string(corners.size()) +
                      " corners, which is not a multiple of 3");
  }
  for (std::size_t i = 2; i < corners.size(); i += list ? 3 : 1) {
    Index a = corners[fan ? 0 : i - 2], b = corners[i - 1];
    const Index c = corners[i];
    if (!list && !fan && i % 2 == 1) std::swap(a, b);
    // In a strip, triangles that repeat a vertex only lead it around a corner.
    if (!list && (a == b || b == c || c == a)) continue;
    out_.corners.insert(out_.corners.end(), {offset + a, offset + b, offset + c});
  }
}

}  // namespace

bool needsDraco(const GltfDocument& document, const GltfPrimitive& primitive) {
  if (!primitive.draco) return false;
  const bool required = std::find(document.required.begin(), document.required.end(),
                                  "KHR_draco_mesh_compression") != document.required.end();
  const auto hasData = [&](std::size_t accessor) {
    return accessor < document.accessors.size() && document.accessors[accessor].view != kNoPart;
  };
  const bool hasPlain =
      hasData(primitive.position) && (primitive.indices == kNoPart || hasData(primitive.indices));
  return required || !hasPlain;
}

GltfGeometry readGltfGeometry(const GltfData& data, std::size_t mesh, const DracoDecoder& draco) {
  GeometryReader reader(data, draco);
  for (const GltfPrimitive& primitive : data.document.meshes[mesh].primitives) {
    reader.add(primitive);
  }
  return reader.take();
}

}  // namespace chartflood
