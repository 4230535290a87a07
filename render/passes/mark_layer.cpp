#include "render/passes/mark_layer.h"

#include <algorithm>
#include <cstdint>

#include <glm/vec4.hpp>

#include "core/base/check.h"

namespace chartflood {

MarkLayer::MarkLayer(const Mesh& mesh, const SurfaceMarks& marks) {
  CF_CHECK(marks.triangles.empty() || marks.triangles.size() == mesh.triangleCount());
  std::vector<std::uint8_t> bytes;
  bytes.reserve(marks.triangles.size());
  for (const TriangleMark mark : marks.triangles) bytes.push_back(static_cast<std::uint8_t>(mark));
  marksTriangles_ = std::any_of(bytes.begin(), bytes.end(), [](auto byte) { return byte != 0; });
  triangles_.upload<std::uint8_t>(GL_R8UI, bytes);
  for (const EdgeLines& each : marks.lines) {
    lines_.push_back(
        {CutLayer(mesh, each.sides), {{}, each.color, each.width, each.dashed}, {}, 0});
  }
}

void MarkLayer::setTexture(const Mesh& mesh, const UvLayout* layout) {
  for (Lines& each : lines_) {
    const std::vector<glm::vec4> segments = layout == nullptr
                                                ? std::vector<glm::vec4>()
                                                : uvSegments(mesh, *layout, each.edges.edges());
    each.inTexture.upload<glm::vec4>(GL_RGBA32F, segments);
    each.inTextureCount = segments.size() / 2;
  }
}

}  // namespace chartflood
