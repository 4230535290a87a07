#include "render/passes/cut_layer.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace chartflood {

CutLayer::CutLayer(const Mesh& mesh, std::span<const Index> sides)
    : edges_(measureCuts(mesh, sides)) {
  std::vector<glm::vec4> ends;
  for (const CutEdge& edge : edges_) {
    triangle_.push_back(edge.side / 3);
    ends.emplace_back(glm::vec3(mesh.positions()[mesh.sideStart(edge.side)]), edge.from);
    ends.emplace_back(glm::vec3(mesh.positions()[mesh.sideEnd(edge.side)]), edge.to);
  }
  segments_.upload<glm::vec4>(GL_RGBA32F, ends);
}

}  // namespace chartflood
