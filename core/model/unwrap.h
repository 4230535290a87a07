#pragma once
/// The charts laid flat, and how much that distorts them.

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/index.h"

namespace chartflood {

/// Distortion of a chart. Every figure is 1 for a map that keeps all angles and, up to one scale,
/// all lengths.
struct Distortion {
  double l2 = 1;    ///< L2 geometric stretch (Sander 2001) times sqrt(UV area / surface area)
  double linf = 1;  ///< largest stretch of a direction, with the same factor
  /// Area-weighted mean of max(r, 1 / r), r = a triangle's area ratio over its chart's.
  double area = 1;
  double angle = 1;         ///< area-weighted mean of s1 / s2, the singular values
  std::size_t flipped = 0;  ///< triangles that face the other way than most
  /// Triangles that have no area in space, so that nothing about them can be measured.
  std::size_t shapeless = 0;
};

/// One chart in the plane.
struct ChartUv {
  /// Place of each vertex of the chart's surface, counter-clockwise triangles, scaled so that the
  /// chart has the same area in the plane as in space (normalised units). Empty: not laid flat.
  std::vector<glm::dvec2> uv;
  Distortion distortion;
  std::string problem;  ///< a sentence that says why there is no uv; "" when there is one
};

/// One entry a chart, by its number; belongs to one ChartSet.
struct Unwrap {
  std::vector<ChartUv> charts;
  /// One value a triangle of the mesh, as in Distortion; NaN where its chart is not laid flat.
  /// `area` holds log2 of the ratio r: above 0 the triangle is too large in the plane.
  std::vector<float> stretch, area, angle;
};

}  // namespace chartflood
