#pragma once
/// All charts placed in one texture.

#include <cstddef>
#include <vector>

#include <glm/exponential.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// From the plane of an unwrapped chart to the texture: turn, scale, then move.
struct Placement {
  double angle = 0;  ///< radians, counter-clockwise
  double scale = 0;  ///< texture units per normalised unit; 0: the chart is not placed
  glm::dvec2 offset{0};

  bool placed() const { return scale > 0; }
  glm::dvec2 at(const glm::dvec2& p) const {
    const double c = glm::cos(angle), s = glm::sin(angle);
    return offset + scale * glm::dvec2(c * p.x - s * p.y, s * p.x + c * p.y);
  }
};

/// One entry a chart, by its number; belongs to one ChartSet and Unwrap.
struct Atlas {
  std::vector<Placement> placement;
  /// Texture place of each vertex of each chart's surface, in [0, 1], v upwards; empty for a chart
  /// that is not laid flat.
  std::vector<std::vector<glm::dvec2>> uv;
  int textureSize = 0;    ///< pixels a side that the margin was kept for
  int margin = 0;         ///< pixels; less than asked for where many charts leave no room for it
  double efficiency = 0;  ///< share of the texture that charts cover
};

/// Pixels of the texture per unit of the model, over all charts as one: the root of their pixels
/// over their surface. 0 where nothing is placed.
inline double texelDensity(const Atlas& atlas, const Mesh& mesh) {
  const double units = mesh.scale() * glm::sqrt(mesh.surfaceArea());
  return units > 0 ? atlas.textureSize * glm::sqrt(atlas.efficiency) / units : 0;
}

/// The same of one chart; 0 where it is not placed.
inline double texelDensity(const Atlas& atlas, const Mesh& mesh, Index chart) {
  const bool placed = chart < atlas.placement.size() && atlas.placement[chart].placed();
  return placed ? atlas.textureSize * atlas.placement[chart].scale / mesh.scale() : 0;
}

}  // namespace chartflood
