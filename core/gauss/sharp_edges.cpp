#include "core/gauss/sharp_edges.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/base/raw_vector.h"

namespace chartflood {

namespace {

constexpr std::size_t kEdgeBlock = 1 << 14;
constexpr float kNormalError = 1e-5f;  // more than of dot products in single precision

/// Of a triangle that is not degenerate.
glm::dvec3 unitNormal(const Mesh& mesh, Index triangle) {
  const auto positions = mesh.positions();
  const auto& v = mesh.triangles()[triangle];
  return glm::normalize(
      glm::cross(positions[v[1]] - positions[v[0]], positions[v[2]] - positions[v[0]]));
}

/// Normals by their angle; the arc tangent decides only where the cosine is too close to call.
bool differsByMore(const glm::dvec3& a, const glm::dvec3& b, double angle, double cosine) {
  const double dot = glm::dot(a, b);
  if (dot > cosine + 1e-9) return false;
  if (dot < cosine - 1e-9) return true;
  return std::atan2(glm::length(glm::cross(a, b)), dot) > angle + 1e-12;
}

}  // namespace

std::vector<std::uint8_t> findSharpSides(const Mesh& mesh, double sharpAngle) {
  const std::size_t count = mesh.triangleCount();
  std::vector<std::uint8_t> sharp(3 * count, 0);
  if (sharpAngle >= 180) return sharp;
  // Single precision tells nearly all edges, in half the memory.
  RawVector<glm::vec3> normal;
  normal.resize(count);
  parallelBlocks(count, kEdgeBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Index triangle = static_cast<Index>(t);
      normal[t] = mesh.degenerate(triangle) ? glm::vec3(0) : glm::vec3(unitNormal(mesh, triangle));
    }
  });
  const double angle = sharpAngle * std::numbers::pi / 180;
  const double cosine = std::cos(angle);
  const float surelySmooth = static_cast<float>(cosine) + kNormalError;
  const auto opposite = mesh.opposite();
  parallelBlocks(count, kEdgeBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (std::size_t s = 3 * t; s < 3 * t + 3; ++s) {
        if (opposite[s] == kNone || opposite[s] < s) continue;
        const Index other = opposite[s] / 3, triangle = static_cast<Index>(t);
        if (glm::dot(normal[t], normal[other]) > surelySmooth) continue;
        if (mesh.degenerate(triangle) || mesh.degenerate(other)) continue;
        if (differsByMore(unitNormal(mesh, triangle), unitNormal(mesh, other), angle, cosine)) {
          sharp[s] = sharp[opposite[s]] = 1;
        }
      }
    }
  });
  return sharp;
}

}  // namespace chartflood
