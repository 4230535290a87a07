#pragma once
/// How much a chart is distorted in the plane (paper section 4; Sander, Snyder, Gortler, Hoppe
/// 2001, "Texture mapping progressive meshes").

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/model/chart_surface.h"
#include "core/model/unwrap.h"

namespace chartflood {

/// Area of a chart in space, squared normalised units.
double surfaceArea(const ChartSurface& surface);

/// Distortion of one triangle of a chart, compared with the chart as a whole: 1 is none.
struct TriangleDistortion {
  double l2 = 1;         ///< root mean square stretch over all directions
  double linf = 1;       ///< largest stretch: 1 / the smaller singular value
  double areaRatio = 1;  ///< area in the plane over area in space, over that of the chart
  double angle = 1;      ///< s1 / s2, the singular values of the map, at least 1
  bool flipped = false;  ///< faces the other way than most
};

/// One entry a triangle. A triangle's area in the plane counts as at least 1e-10 of the mean (or
/// 1e-3 of what it would be without stretch, if that is less), and one that is degenerate in space
/// has distortion 1, so that all figures are finite.
/// \param uv place of each vertex of the surface
std::vector<TriangleDistortion> triangleDistortion(const ChartSurface& surface,
                                                   std::span<const glm::dvec2> uv);

/// Figures of the chart: means are weighted with the areas in space, those of L2 square.
Distortion chartDistortion(const ChartSurface& surface,
                           std::span<const TriangleDistortion> triangles);

}  // namespace chartflood
