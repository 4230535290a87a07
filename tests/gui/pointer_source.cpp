#include "tests/gui/pointer_source.h"

#include <limits>

#include <glm/geometric.hpp>

namespace chartflood {

Pick PointerSource::pick(int x, int y) {
  Pick pick;
  if (state_ == nullptr || !state_->hasMesh()) return pick;
  const Mesh& mesh = *state_->results().mesh;
  const glm::dvec2 ndc(2 * (x + 0.5) / width_ - 1, 1 - 2 * (y + 0.5) / height_);
  const Ray ray = state_->view.camera.ray(ndc, static_cast<double>(width_) / height_);
  double nearest = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const auto corner = [&](std::size_t i) { return mesh.positions()[mesh.triangles()[t][i]]; };
    const glm::dvec3 a = corner(0), u = corner(1) - a, v = corner(2) - a;
    const glm::dvec3 p = glm::cross(ray.direction, v), s = ray.origin - a, q = glm::cross(s, u);
    const double det = glm::dot(u, p);
    if (det == 0) continue;
    const double b = glm::dot(s, p) / det, c = glm::dot(ray.direction, q) / det;
    const double distance = glm::dot(v, q) / det;
    if (b < 0 || c < 0 || b + c > 1 || distance <= 0 || distance >= nearest) continue;
    nearest = distance;
    pick.triangle = t;
    pick.face = mesh.faceOf(t);
    pick.chart = state_->chartOfFace(pick.face);
    pick.point = ray.origin + distance * ray.direction;
  }
  return pick;
}

}  // namespace chartflood
