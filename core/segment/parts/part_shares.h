#pragma once
/// How many charts a model of several connected parts has, and what each part may have of them.
/// Beyond the paper, whose models are in one part.

#include <cstddef>
#include <span>
#include <vector>

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// What decides which part gets the next chart.
struct PartShares {
  std::vector<double> weight;  ///< what each part has to share out among its charts, not negative
  /// Charts that each part may have while another can take one; empty: as many as there are.
  std::vector<std::size_t> most;
};

/// The number of charts of a model in parts, and why it is not the one that was asked for.
struct PartCount {
  std::size_t charts = 0;
  std::size_t parts = 0;
  std::size_t small = 0;  ///< parts that get a chart each beside those asked for
};

/// Every part needs a chart. Parts that are small take none from the others: they come on top.
/// Small is
///
/// - a crumb: it holds less than a twenty-fifth of the surface that a chart has on average;
/// - where parts outnumber the charts that are asked for: what holds less than a quarter of it; its
///   own share of them is not given to the others.
///
/// Asking for more never gives fewer. Cost: parts times their logarithm, and a pass over the faces
/// where there are several.
PartCount countWithParts(const Mesh& mesh, std::size_t asked);

/// Weight: Gauss area and eta times the area, so that charts of all parts can come out equal. Parts
/// without Gauss area get one chart, and so do parts that are too small for charts of an eighth of
/// the mean area: the Gauss area of every closed part is at least 4 pi, however small it is.
/// \param faceGauss faceGaussArea() of the mesh
/// \param eta steradians that a squared normalised unit of surface counts as
/// \param asked the number of charts that is asked for
PartShares partShares(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
                      double eta, std::size_t asked);

}  // namespace chartflood
