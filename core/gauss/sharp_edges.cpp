#include "core/gauss/sharp_edges.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"

namespace chartflood {

namespace {

constexpr std::size_t kEdgeBlock = 1 << 14;

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
  std::vector<glm::dvec3> normal(count);
  const auto positions = mesh.positions();
  parallelBlocks(count, kEdgeBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (mesh.degenerate(static_cast<Index>(t))) continue;
      const auto& v = mesh.triangles()[t];
      normal[t] = glm::normalize(
          glm::cross(positions[v[1]] - positions[v[0]], positions[v[2]] - positions[v[0]]));
    }
  });
  const double angle = sharpAngle * std::numbers::pi / 180;
  const double cosine = std::cos(angle);
  const auto opposite = mesh.opposite();
  parallelBlocks(count, kEdgeBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (mesh.degenerate(static_cast<Index>(t))) continue;
      for (std::size_t s = 3 * t; s < 3 * t + 3; ++s) {
        if (opposite[s] == kNone) continue;
        const Index other = opposite[s] / 3;
        if (mesh.degenerate(other)) continue;
        sharp[s] = differsByMore(normal[t], normal[other], angle, cosine) ? 1 : 0;
      }
    }
  });
  return sharp;
}

}  // namespace chartflood
