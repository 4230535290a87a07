#include "render/scene/first_view.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/base/text.h"

namespace chartflood {

namespace {

/// Share of the ground below a model that its faces lie on, for one of its axes as the upright one.
double flatSupport(const Mesh& mesh, int axis, const glm::dvec3& low, const glm::dvec3& high) {
  constexpr double kNear = 0.01;  // of the height
  const glm::dvec3 size = high - low;
  const double ground = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  const double reach = low[axis] + kNear * size[axis];
  const auto p = mesh.positions();
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    if (std::max({p[a][axis], p[b][axis], p[c][axis]}) > reach) continue;
    const double down = -0.5 * glm::cross(p[b] - p[a], p[c] - p[a])[axis];
    area += std::max(down, 0.0);
  }
  return ground > 0 ? area / ground : 0;
}

/// In the axes of a model with Y upright.
glm::dvec3 toYUp(const glm::dvec3& v, UpAxis up) {
  return up == UpAxis::Y ? v : glm::dvec3(v.x, v.z, -v.y);
}
glm::dvec3 fromYUp(const glm::dvec3& v, UpAxis up) {
  return up == UpAxis::Y ? v : glm::dvec3(v.x, -v.z, v.y);
}

/// Second moments of the surface over the ground, x and z.
struct Moments {
  double area = 0, x = 0, z = 0, xx = 0, xz = 0, zz = 0;
};

Moments momentsOf(const Mesh& mesh, UpAxis up) {
  Moments sum;
  const auto p = mesh.positions();
  for (const auto& [a, b, c] : mesh.triangles()) {
    const double area = glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
    const glm::dvec3 u = toYUp(p[a], up), v = toYUp(p[b], up), w = toYUp(p[c], up), all = u + v + w;
    // Over a triangle the mean of a product is that of its corners and of their sum by 1 to 1.
    const auto mean = [&](auto product) {
      return (product(u) + product(v) + product(w) + product(all)) / 12;
    };
    sum.area += area;
    sum.x += area * all.x / 3;
    sum.z += area * all.z / 3;
    sum.xx += area * mean([](const glm::dvec3& q) { return q.x * q.x; });
    sum.xz += area * mean([](const glm::dvec3& q) { return q.x * q.z; });
    sum.zz += area * mean([](const glm::dvec3& q) { return q.z * q.z; });
  }
  return sum;
}

/// Share of what is seen along a direction that faces the eye almost straight: a view of one flat
/// side tells little of a shape.
double facingShare(const Mesh& mesh, const glm::dvec3& sight) {
  const double straight = std::cos(glm::radians(40.0));
  const auto p = mesh.positions();
  double seen = 0, facing = 0;
  for (const auto& [a, b, c] : mesh.triangles()) {
    const glm::dvec3 normal = glm::cross(p[b] - p[a], p[c] - p[a]);
    const double towards = -glm::dot(normal, sight);
    if (towards <= 0) continue;
    seen += towards;
    if (towards > straight * glm::length(normal)) facing += towards;
  }
  return seen > 0 ? facing / seen : 0;
}

/// The direction to the eye, turned about the upright axis as little as helps.
glm::dvec3 turnedAside(const Mesh& mesh, UpAxis up, const glm::dvec3& eye) {
  constexpr double kFlat = 0.6;
  glm::dvec3 best = eye;
  double least = 2;
  for (const double degrees : {0.0, 25.0, -25.0, 50.0, -50.0, 75.0, -75.0}) {
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    const glm::dvec3 turned(c * eye.x + s * eye.z, eye.y, c * eye.z - s * eye.x);
    const double share = facingShare(mesh, fromYUp(-turned, up));
    if (share < least) best = turned, least = share;
    if (share < kFlat) break;
  }
  return best;
}

}  // namespace

UpAxis likelyUpAxis(const Mesh& mesh) {
  constexpr double kFlat = 0.2, kFlatter = 2, kTaller = 1.6;
  const std::string ending =
      lowerCase(std::filesystem::path(mesh.input().file).extension().string());
  if (ending == ".gltf" || ending == ".glb") return UpAxis::Y;
  if (ending == ".3mf") return UpAxis::Z;
  if (mesh.positions().empty()) return UpAxis::Y;
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  for (const glm::dvec3& point : mesh.positions()) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  const double onY = flatSupport(mesh, 1, low, high), onZ = flatSupport(mesh, 2, low, high);
  if (onZ > kFlat && onZ > kFlatter * onY) return UpAxis::Z;
  if (onY > kFlat && onY > kFlatter * onZ) return UpAxis::Y;
  const glm::dvec3 size = high - low;
  return size.z > kTaller * std::max(size.x, size.y) ? UpAxis::Z : UpAxis::Y;
}

void lookAtFirst(Camera& camera, const Mesh& mesh) {
  constexpr double kDistinct = 1.1, kTurn = glm::radians(35.0), kFromAbove = 0.43;
  camera.look(StandardView::Oblique);
  const Moments m = momentsOf(mesh, camera.up);
  if (!(m.area > 0)) return;
  const double x = m.x / m.area, z = m.z / m.area;
  const double xx = m.xx / m.area - x * x, zz = m.zz / m.area - z * z, xz = m.xz / m.area - x * z;
  const double middle = (xx + zz) / 2, spread = std::hypot((xx - zz) / 2, xz);
  // Of both ways along the axes those that turn to where the oblique view is taken from.
  const glm::dvec3 usual(0.5, 0, 0.85);
  const auto facing = [&](const glm::dvec3& way) { return glm::dot(way, usual) < 0 ? -way : way; };
  glm::dvec3 eye = glm::normalize(usual);
  if (middle - spread >= 0 && middle + spread > kDistinct * (middle - spread)) {
    const double angle = 0.5 * std::atan2(2 * xz, xx - zz);
    const glm::dvec3 along = facing({std::cos(angle), 0, std::sin(angle)});
    const glm::dvec3 across = facing({-std::sin(angle), 0, std::cos(angle)});
    eye = glm::normalize(std::cos(kTurn) * across + std::sin(kTurn) * along);
  }
  eye = turnedAside(mesh, camera.up, glm::normalize(eye + glm::dvec3(0, kFromAbove, 0)));
  camera.lookAlong(fromYUp(-eye, camera.up), fromYUp({0, 1, 0}, camera.up));
}

}  // namespace chartflood
