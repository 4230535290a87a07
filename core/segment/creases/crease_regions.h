#pragma once
/// Charts made from the sharp edges of a model: how one would cut machine parts by hand. Beyond the
/// paper, whose Gauss area says nothing about planes.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/base/rng.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// A division of the faces; every region is connected, numbered by its first face.
struct CreaseRegions {
  std::vector<Index> label;  ///< region of each face
  std::size_t count = 0;
};

/// Parts of the surface that no path leaves without crossing a sharp edge. Those below 0.2 % of the
/// surface join the neighbour with the longest common border. Their number is the natural number of
/// charts. Cost: about linear.
CreaseRegions creaseRegions(const Mesh& mesh, const GaussArea& gauss);

/// True when sharp edges divide the model by themselves, as they do machine parts. Of the parts
/// that no path leaves without crossing a sharp edge
/// - there are at least 3 more than separate parts, the largest holds at most 60 % of the surface,
/// and at most 40 % when it is
///   curved as much as a quarter of a sphere: a soft body with hard details has to be divided by
///   its curvature;
/// - those of 0.2 % of the surface and more hold at least 95 % of it: a sponge is none;
/// - and at least half the length of all sharp edges lies between two of them.
/// Cost: linear.
bool dividedByCreases(const Mesh& mesh, const GaussArea& gauss);

/// What charts made from crease regions heed.
struct CreaseRules {
  std::span<const std::size_t> most = {};  ///< as in PartShares; empty: no limit
  /// As quadPartners() has it: single triangles are joined first, and quads are parted when nothing
  /// else is left; empty: faces are alike.
  std::span<const Index> partner = {};
  bool first = false;  ///< creases come first: splits follow them whatever the length of seams
};

/// Joins regions along flat and long borders, or splits the largest and most curved in two, rings
/// first, until there are `charts` (as far as separate parts allow). Splits go along creases inside
/// a region where that is no long way around.
/// \param faceGauss faceGaussArea() of the mesh
/// \param rng where splits begin to look for faces far from each other
CreaseRegions chartsFromCreases(const Mesh& mesh, const GaussArea& gauss,
                                std::span<const double> faceGauss, CreaseRegions regions,
                                std::size_t charts, Rng& rng, const CreaseRules& rules = {});

}  // namespace chartflood
