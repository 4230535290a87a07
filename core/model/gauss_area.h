#pragma once
/// Gauss area of every mesh element: the absolute area of its normals on the unit sphere (paper
/// section 3.2, Delta A_G of equation 2).

#include <vector>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Steradians everywhere. Border edges and border vertices have none.
struct GaussArea {
  double sharpAngle = 45;  ///< T_a in degrees

  std::vector<double> triangle;  ///< one value a triangle, in [0, 2 pi]
  /// Interior edges whose face normals differ by more than T_a, by their smaller side, ascending.
  std::vector<Index> sharpEdges;
  std::vector<double> edge;  ///< one value per entry of sharpEdges, in [0, 2 pi]
  /// Vertices with three or more smooth regions (corners), ascending.
  std::vector<Index> corners;
  std::vector<double> corner;  ///< one value per entry of corners, in [0, 4 pi]

  double triangleTotal = 0, edgeTotal = 0, cornerTotal = 0;
  /// Sum of the signed areas; 4 pi times an integer on a closed mesh.
  double signedTotal = 0;
  /// The largest Gauss area over area of any element, per squared normalised unit; 1 if none has
  /// Gauss area (paper section 3.3: max_j |K_j|).
  double maxCurvature = 1;

  double total() const { return triangleTotal + edgeTotal + cornerTotal; }
};

/// Lower bound of the area by which a Gauss area is divided: 1e-9 of the mean triangle's.
double smallestArea(const Mesh& mesh);

}  // namespace chartflood
