#pragma once
/// Gauss area of all vertices, edges and triangles (paper section 3.2, figure 1).

#include "core/model/face_values.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Computes the Gauss area of every element for the crease threshold T_a = `sharpAngle` degrees in
/// [0, 180].
///
/// - Triangle: spherical triangle of its three corner normals.
/// - Sharp edge v0 v1 with triangle L on its left and R on its right: polygon
///   nL(v1), nL(v0), nR(v0), nR(v1). Other edges have none.
/// - Interior vertex with three or more sectors: polygon of the sector normals. Others have none.
///
/// Cost: linear, in parallel over fixed blocks; the result does not depend on the threads.
GaussArea computeGaussArea(const Mesh& mesh, double sharpAngle);

/// Gauss area of each face, steradians: its triangles and the edges between them. A view of `gauss`
/// where faces are triangles.
FaceValues faceGaussArea(const Mesh& mesh, const GaussArea& gauss);

}  // namespace chartflood
