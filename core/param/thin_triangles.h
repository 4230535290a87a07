#pragma once
/// How thin the triangles of a chart are, and the exact shape of each however thin it is.

#include <array>
#include <cstddef>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/model/chart_surface.h"

namespace chartflood {

/// Height over longest edge up to which a triangle has no shape: the roundings of its corners may
/// be a thousandth of it.
inline constexpr double kNoShape = 1e-12;

/// A triangle in a plane of its own: its longest edge along x, counter-clockwise. Each edge comes
/// from the difference of its own two ends, so that a short one is as exact as a long one; corners
/// that are added up along two of them would differ by roundings of the longest.
struct FlatTriangle {
  /// Edge i runs from corner i to corner i + 1.
  std::array<glm::dvec2, 3> edge;
  std::size_t longest = 0;  ///< number of the longest edge

  explicit FlatTriangle(const std::array<glm::dvec3, 3>& corners);
  double length() const { return edge[longest].x; }
  /// Over the longest edge.
  double height() const { return edge[(longest + 1) % 3].y; }
  /// Height over length; 0 when all corners are in one point.
  double thinness() const { return length() > 0 ? height() / length() : 0; }
  double area() const { return 0.5 * length() * height(); }
  double shortest() const;
  bool hasShape() const { return thinness() > kNoShape; }
};

FlatTriangle flatTriangle(const ChartSurface& surface, std::size_t triangle);

/// What decides how a chart is laid flat.
struct ChartThinness {
  /// Some triangle is so thin that the equations of a map would have to follow it alone.
  bool slivers = false;
  /// Most of the area is in thin triangles: rods, needles, fans and the like.
  bool mostlyThin = false;
  bool any() const { return slivers || mostlyThin; }
  /// Height over longest edge that a triangle's shape gets at least in a map's equations: well
  /// below that of all but a hundredth of the area.
  double usual = 0;
};

ChartThinness thinnessOf(const ChartSurface& surface);

}  // namespace chartflood
