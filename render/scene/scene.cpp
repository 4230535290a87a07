#include "render/scene/scene.h"

#include <algorithm>

#include "core/base/error.h"

namespace chartflood {

glm::dvec3 faceMiddle(const Mesh& mesh, Index face) {
  glm::dvec3 sum(0);
  double weight = 0;
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    const double area = std::max(mesh.triangleArea()[t], 1e-30);
    for (const Index vertex : mesh.triangles()[t]) sum += mesh.positions()[vertex] * (area / 3);
    weight += area;
  }
  return sum / weight;
}

namespace render {

std::span<const Index> shownLabels(const Scene& scene) {
  if (scene.labels) return *scene.labels;
  if (scene.source.segmentation) return scene.source.segmentation->label;
  return {};
}

void checkScene(const Scene& scene) {
  if (!scene.source.mesh) return;
  const Mesh& mesh = *scene.source.mesh;
  const auto labels = shownLabels(scene);
  if (!labels.empty() && labels.size() != mesh.faceCount()) {
    throw Error("There must be one label for each face.");
  }
  const Shared<UvLayout>& layout = scene.source.layout;
  if (layout && !layout->empty() && layout->corners.size() != 3 * mesh.triangleCount()) {
    throw Error("There must be three texture places for each triangle.");
  }
}

}  // namespace render

}  // namespace chartflood
