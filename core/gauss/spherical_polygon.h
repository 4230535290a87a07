#pragma once
/// Areas on the unit sphere (paper section 3.2: "the area of this polygon is equal to Delta A_G").

#include <span>

#include <glm/vec3.hpp>

namespace chartflood {

/// Signed area of the spherical triangle a, b, c (unit vectors), positive when counter-clockwise
/// seen from outside, in (-2 pi, 2 pi]. A triangle with two antipodal or three coplanar corners
/// that leave it undefined has area 0.
double signedTriangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Sum of the signed triangles of the fan from the first corner.
double signedPolygonArea(std::span<const glm::dvec3> corners);

/// Integral of |dA| over a closed polygon of unit vectors, in [0, 4 pi].
///
/// The paper is silent about polygons that cross themselves: here the loop is split wherever two of
/// its arcs cross properly and the areas of the simple loops are added, which for a bow-tie is the
/// absolute area of both wings. A simple loop has area min(A, 4 pi - A) of its signed area.
/// Cost: linear for triangles, quadratic in the number of corners.
double absolutePolygonArea(std::span<const glm::dvec3> corners);

}  // namespace chartflood
