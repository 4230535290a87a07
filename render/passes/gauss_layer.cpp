#include "render/passes/gauss_layer.h"

namespace chartflood {

GaussLayer::GaussLayer(const GaussValues& values)
    : edgeCount_(values.edges.size() / 2), vertexCount_(values.vertices.size() / 2) {
  edges_.upload<glm::vec4>(GL_RGBA32F, values.edges);
  vertices_.upload<glm::vec4>(GL_RGBA32F, values.vertices);
}

}  // namespace chartflood
