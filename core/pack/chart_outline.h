#pragma once
/// What packing knows of a chart: its outline in the plane.

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "core/model/chart_surface.h"

namespace chartflood {

using Segment2 = std::array<glm::dvec2, 2>;

struct ChartOutline {
  /// The boundary, loop after loop, in the chart's plane. A point is covered when the loops wind
  /// around it: triangles that face the other way than most have their own borders in the list.
  std::vector<Segment2> segments;
  std::vector<glm::dvec2> hull;  ///< corners of the convex hull, counter-clockwise
  double area = 0;               ///< sum of the triangles' areas
  bool empty() const { return hull.empty(); }
};

/// Empty when the chart is not laid flat or has a place that is not finite.
/// Cost: linear in the triangles, n log n in the boundary's vertices.
ChartOutline outlineOf(const ChartSurface& surface, const std::vector<glm::dvec2>& uv);

/// The smallest square around a set of points.
struct EnclosingSquare {
  double angle = 0;        ///< turn of the points, radians, that makes the square upright
  double side = 0;         ///< length of its sides
  glm::dvec2 center{0.0};  ///< of the turned points' bounding box
};

/// \param hull corners of a convex polygon, counter-clockwise
EnclosingSquare smallestSquare(const std::vector<glm::dvec2>& hull);

/// The box of the least area around a set of points.
struct EnclosingBox {
  double angle = 0;                ///< turn of the points, radians, that makes the box upright
  glm::dvec2 low{0.0}, size{0.0};  ///< of the turned points' bounding box, its long side across
};

/// \param hull corners of a convex polygon, counter-clockwise
EnclosingBox smallestBox(const std::vector<glm::dvec2>& hull);

/// Centre of a circle around the points that is at most 1 % larger than the smallest one.
glm::dvec2 circleCenter(const std::vector<glm::dvec2>& hull);

}  // namespace chartflood
