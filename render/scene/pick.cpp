#include "render/scene/pick.h"

#include <functional>

#include <glm/gtc/matrix_inverse.hpp>

#include "render/scene/render_settings.h"

namespace chartflood {

Pick pickModel(const TriangleTree& tree, const BoundingSphere& bounds, const Camera& camera,
               const PicturePixel& pixel, std::span<const Index> labels,
               const std::vector<Index>& hidden) {
  if (!pixel.inside()) return {};
  const Mesh& mesh = *tree.mesh();
  const double aspect = double(pixel.width) / pixel.height;
  const glm::dmat4 toSpace =
      glm::inverse(camera.projectionMatrix(aspect, bounds) * camera.viewMatrix());
  const auto inSpace = [&](double depth) {
    const glm::dvec4 point = toSpace * glm::dvec4(2 * (pixel.x + 0.5) / pixel.width - 1,
                                                  1 - 2 * (pixel.y + 0.5) / pixel.height, depth, 1);
    return glm::dvec3(point) / point.w;
  };
  const auto chartOf = [&](Index triangle) {
    return labels.empty() ? kNone : labels[mesh.faceOf(triangle)];
  };
  std::function<bool(Index)> counts;
  if (!hidden.empty()) {
    counts = [&](Index triangle) { return !holdsChart(hidden, chartOf(triangle)); };
  }
  const auto hit = tree.first(inSpace(-1), inSpace(1), counts);
  if (!hit) return {};
  return {hit->triangle, mesh.faceOf(hit->triangle), chartOf(hit->triangle), hit->point};
}

}  // namespace chartflood
