#pragma once
/// The triangles of a chart one by one in the plane, undistorted: what every map is compared with.

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/index.h"
#include "core/model/chart_surface.h"
#include "core/param/thin_triangles.h"

namespace chartflood {

/// Lengths are in units of sqrt(chart area), so that the weights add up to 1 whatever the scale.
/// Triangles much thinner than the others (collinear, vanishing edges) get a somewhat thicker one
/// in their place, so that all numbers stay in range and the others need not follow them.
struct RestShape {
  explicit RestShape(const ChartSurface& surface);

  std::size_t triangleCount() const { return weight.size(); }
  std::size_t vertexCount() const { return vertices; }

  std::span<const std::array<Index, 3>> triangles;  ///< of the surface, which must outlive this
  std::size_t vertices = 0;
  std::vector<double> weight;  ///< area of each triangle, in all 1
  /// Gradients of the barycentric coordinates of corners 1 and 2, in the triangle's own frame
  /// (counter-clockwise); that of corner 0 is minus their sum.
  std::vector<std::array<glm::dvec2, 2>> gradient;
  double unit = 1;  ///< normalised units per unit of length here
  ChartThinness thinness;
};

/// A linear map of the plane as z -> alpha z + beta conj(z). alpha is its part without shear.
/// |alpha| + |beta| and |alpha| - |beta| are the singular values (the second signed), so that
/// |alpha|^2 - |beta|^2 is the determinant.
struct PlaneMap {
  std::complex<double> alpha, beta;
  double determinant() const { return std::norm(alpha) - std::norm(beta); }
  double squaredNorm() const { return 2 * (std::norm(alpha) + std::norm(beta)); }
};

/// From the rest shape of a triangle to its place in the plane.
PlaneMap planeMap(const RestShape& rest, std::size_t triangle, std::span<const glm::dvec2> uv);

/// Area of a triangle in the plane, negative when clockwise.
inline double signedArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Sum of the signed areas of all triangles.
double signedArea(const RestShape& rest, std::span<const glm::dvec2> uv);

/// True when every triangle is counter-clockwise with an area above 0 (and finite).
bool allPositive(const RestShape& rest, std::span<const glm::dvec2> uv);

/// True when every triangle is counter-clockwise and no height is below 1e-7 of the square root of
/// the chart's area: places rounded to 9 digits of a texture then still face the same way, even
/// where the chart is a thousandth of it.
bool sturdy(const RestShape& rest, std::span<const glm::dvec2> uv);

/// Scales the chart to area 1, mirrored when most of it is clockwise, its centre at the origin.
/// False, and nothing changed, when it has no area or is not finite.
bool scaleToUnitArea(const RestShape& rest, std::span<glm::dvec2> uv);

}  // namespace chartflood
