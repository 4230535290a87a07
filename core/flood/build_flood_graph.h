#pragma once
/// Delays between neighbouring faces (paper section 3.3, equations 6 to 9).

#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/model/face_values.h"
#include "core/model/flood_graph.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Which of the two layouts of FloodGraph to fill.
enum class FloodLayout {
  Automatic,  ///< packed when every face is a triangle
  Arcs,       ///< always arcs: the plain layout that tests compare with
};

/// For each ordered pair of neighbour faces f -> g across the edge e
///
///   delay(f, g) = |centroid_f - centroid_g| * (min(1, K / Kmax) + epsilon)^p,
///   K = (A_G(g) + A_G(e)) / area(g),
///
/// which is f(x) = (x + epsilon Kmax)^p of equation 7 divided by Kmax^p. Local times are only
/// compared inside one chart, so any constant factor drops out; the one used here centres the range
/// of speeds on 1 so that single precision holds it.
/// Cost: linear, one pass.
FloodGraph buildFloodGraph(const Mesh& mesh, const GaussArea& gauss, const FloodSpeeds& speeds,
                           FloodLayout layout = FloodLayout::Automatic);

/// Distance between the centroids of a triangle and of the one across its side k, normalised units.
/// \pre `across` is FloodFace::neighbour[k] of the triangle, not kNone
inline double centroidDistance(const Mesh& mesh, Index triangle, Index k, Index across) {
  const auto corner = [&](Index t, Index i) -> const glm::dvec3& {
    return mesh.positions()[mesh.triangles()[t][i % 3]];
  };
  // Two corners are common: the centroids differ by a third of what the others do.
  return glm::length(corner(across >> 2, (across & 3) + 2) - corner(triangle, k + 2)) / 3.0;
}

/// Area-weighted centroid of each face in normalised units.
std::vector<glm::dvec3> faceCentroids(const Mesh& mesh);

/// Area of each face in squared normalised units; a view of the mesh where faces are triangles.
FaceValues faceAreas(const Mesh& mesh);

}  // namespace chartflood
