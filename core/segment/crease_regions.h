#pragma once
/// Charts made from the sharp edges of a model: how one would cut machine parts by hand. Beyond the
/// paper, whose Gauss area says nothing about planes.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// A division of the faces; every region is connected, numbered by its first face.
struct CreaseRegions {
  std::vector<Index> label;  ///< region of each face
  std::size_t count = 0;
};

/// Parts of the surface that no path leaves without crossing a sharp edge. Those below 0.3 % of the
/// surface join the neighbour with the longest common border. Their number is the natural number of
/// charts. Cost: about linear.
CreaseRegions creaseRegions(const Mesh& mesh, const GaussArea& gauss);

/// True when sharp edges divide the model by themselves: into at least 4 regions, none of which
/// holds more than 60 % of the surface.
bool dividedByCreases(const Mesh& mesh, const CreaseRegions& regions);

/// Joins regions along flat and long borders, or splits the largest and most curved in two, rings
/// first, until there are `charts` (as far as separate parts allow).
/// \param faceGauss faceGaussArea() of the mesh
CreaseRegions chartsFromCreases(const Mesh& mesh, const GaussArea& gauss,
                                std::span<const double> faceGauss, CreaseRegions regions,
                                std::size_t charts);

}  // namespace chartflood
