#pragma once
/// Areas on the unit sphere (paper section 3.2: "the area of this polygon is equal to Delta A_G").

#include <span>

#include <glm/vec3.hpp>

namespace chartflood {

/// Signed area of the spherical triangle a, b, c (unit vectors), positive when counter-clockwise
/// seen from outside, in (-2 pi, 2 pi]. A triangle with two antipodal or three coplanar corners
/// that leave it undefined has area 0.
double signedTriangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Area of a closed polygon of unit vectors, its sides the shorter arcs.
struct PolygonArea {
  double absolute = 0;    ///< integral of |winding number|, at most 4 pi
  double signedArea = 0;  ///< integral of the winding number
};

/// The paper is silent about polygons that cross themselves. Here every point of the sphere counts
/// as often as the polygon runs around it: a bow-tie has the area of both wings. Winding numbers on
/// a sphere are known up to a constant, which is the one that makes `absolute` least (a simple loop
/// bounds the smaller of its two sides); of equals, the one with the larger signed area.
///
/// Neither value depends on the corner that the polygon begins with, beyond rounding.
/// Cost: linear for up to four corners; else quadratic, and with c crossings c times the corners.
PolygonArea polygonArea(std::span<const glm::dvec3> corners);

}  // namespace chartflood
