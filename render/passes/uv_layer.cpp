#include "render/passes/uv_layer.h"

#include <cmath>
#include <utility>

namespace chartflood {

UvLayer::UvLayer(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const UvLayout> layout)
    : mesh_(std::move(mesh)), layout_(std::move(layout)) {
  setCuts({});
}

void UvLayer::setCuts(std::span<const CutEdge> cuts) {
  UvLines lines = uvLines(*mesh_, *layout_, cuts);
  outlines_.upload<glm::vec4>(GL_RGBA32F, lines.outline);
  cuts_.upload<glm::vec4>(GL_RGBA32F, lines.cuts);
  outlineCount_ = lines.outline.size() / 2;
  cutTriangle_ = std::move(lines.cutTriangle);
  outlineOf_ = std::move(lines.outlineOf);
}

glm::dvec3 UvLayer::surfacePoint(Index triangle, const glm::dvec2& uv) const {
  const std::size_t first = std::size_t{3} * triangle;
  const std::vector<glm::vec3>& corners = layout_->corners;
  const glm::dvec2 a(corners[first]), b(corners[first + 1]), c(corners[first + 2]);
  const auto cross = [](const glm::dvec2& p, const glm::dvec2& q) { return p.x * q.y - p.y * q.x; };
  const double whole = cross(b - a, c - a);
  const double atB = std::abs(whole) > 0 ? cross(uv - a, c - a) / whole : 0;
  const double atC = std::abs(whole) > 0 ? cross(b - a, uv - a) / whole : 0;
  const auto& corner = mesh_->triangles()[triangle];
  const auto places = mesh_->positions();
  return places[corner[0]] * (1 - atB - atC) + places[corner[1]] * atB + places[corner[2]] * atC;
}

}  // namespace chartflood
