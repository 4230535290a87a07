#pragma once
/// Gauss area of charts, counted from the labels (paper equation 2).

#include <span>

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"

namespace chartflood {

/// A(c) = Gauss areas of the faces of c, of the edges with both faces in c, and of the vertices
/// whose whole fan is in c. What no chart holds entirely, free faces included, is `onSeams`, so
/// that everything adds up to the total. `faceGauss` is faceGaussArea() of the mesh.
ChartAreas chartAreas(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
                      std::span<const Index> label, std::size_t chartCount);

}  // namespace chartflood
