#include "app/import/draco_mesh.h"

#include <array>
#include <memory>
#include <utility>

#include <draco/compression/decode.h>

namespace chartflood {

namespace {

DracoMesh refused(const char* why) { return {{}, {}, why}; }

const draco::PointAttribute* positionsOf(const draco::Mesh& mesh, std::size_t number) {
  if (number == kNoPart) return mesh.GetNamedAttribute(draco::GeometryAttribute::POSITION);
  return mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(number));
}

}  // namespace

DracoMesh decodeDraco(std::string_view bytes, std::size_t position) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return refused("its data are broken or cut off");
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  const draco::PointAttribute* attribute = mesh ? positionsOf(*mesh, position) : nullptr;
  if (attribute == nullptr || attribute->num_components() != 3) {
    return refused("it has no positions");
  }
  DracoMesh result;
  result.positions.resize(mesh->num_points());
  for (std::uint32_t i = 0; i < mesh->num_points(); ++i) {
    const draco::AttributeValueIndex value = attribute->mapped_index(draco::PointIndex(i));
    if (value.value() >= attribute->size() ||
        !attribute->ConvertValue<double, 3>(value, &result.positions[i].x)) {
      return refused("its positions are broken");
    }
  }
  result.corners.reserve(std::size_t{3} * mesh->num_faces());
  for (std::uint32_t f = 0; f < mesh->num_faces(); ++f) {
    const draco::Mesh::Face& face = mesh->face(draco::FaceIndex(f));
    for (const draco::PointIndex& corner : face) result.corners.push_back(corner.value());
  }
  return result;
}

}  // namespace chartflood
