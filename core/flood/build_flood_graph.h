#pragma once
/// Delays between neighbouring faces (paper section 3.3, equations 6 to 9).

#include <vector>

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

/// Area-weighted centroid of each face in normalised units.
std::vector<glm::dvec3> faceCentroids(const Mesh& mesh);

/// Area of each face in squared normalised units; a view of the mesh where faces are triangles.
FaceValues faceAreas(const Mesh& mesh);

}  // namespace chartflood
