#pragma once
/// The normals of a chart on the unit sphere (Gauss map): what its Gauss area is the area of (paper
/// section 3.2, figure 1).

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "app/host/insight/surface_derived.h"
#include "core/model/segmentation.h"

namespace chartflood {

/// A small flat piece of the sphere: a triangle, or a quadrilateral of the sampling grid.
struct SphereFacet {
  std::array<glm::vec3, 4> corner;  ///< unit vectors; the fourth is unused by triangles
  int corners = 3;
  float layers = 1;  ///< how often the chart's normals cover it
};

/// The arc of normals across one end of a crease, the shorter way.
struct SphereArc {
  glm::vec3 from, to;
  bool inside = true;  ///< both triangles are the chart's; else its border follows the crease
};

struct SpherePatch {
  Index chart = kNone;
  std::vector<SphereFacet> facets;
  /// True when there were too many triangles to keep one by one: the facets are then cells of a
  /// grid with the mean number of layers in each.
  bool sampled = false;
  std::vector<glm::vec3> points;  ///< normals of flat triangles, each direction about once
  std::vector<SphereArc> arcs;
  std::vector<std::vector<glm::vec3>> corners;        ///< polygons of sector normals
  double faceArea = 0, edgeArea = 0, cornerArea = 0;  ///< the chart's Gauss area, steradians

  double area() const { return faceArea + edgeArea + cornerArea; }
};

/// Facets kept one by one; above that the sphere is sampled.
inline constexpr std::size_t kMostFacets = 3000;
/// Arcs kept, evenly taken from all.
inline constexpr std::size_t kMostArcs = 1200;

/// The elements that the chart holds entirely. Cost: linear in the mesh, times up to about a
/// thousand where triangles span much of the sphere.
/// \pre labels, normals and Gauss area belong to the same mesh
SpherePatch spherePatch(const SurfaceDerived& surface, const Segmentation& segmentation,
                        Index chart);

/// A normal of the surface to stand for its neighbourhood.
struct SphereDot {
  glm::vec3 normal;
  Index face = kNone;
};
/// At most `most` triangles, evenly taken by their numbers.
std::vector<SphereDot> sphereDots(const SurfaceDerived& surface, std::size_t most);

}  // namespace chartflood
