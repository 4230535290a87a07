#pragma once
/// Proxies of charts and what they cost (Cohen-Steiner et al. 2004, section 3.2, L2,1 metric).

#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/segment/growth/growth_graph.h"

namespace chartflood {

/// One chart with its proxy.
struct VsaRegion {
  glm::dvec3 sum{0};     ///< of area * normal
  double area = 0;       ///< of faces with a normal
  glm::dvec3 normal{0};  ///< the proxy: the sum's direction
  double cost = 0;       ///< sum of area * |n - N|^2
  Index best = kNone;    ///< cheapest face with a normal, lowest on ties; kNone without any
  /// The two dearest faces, lowest first on ties, faces without a normal last.
  Index worst = kNone, secondWorst = kNone;
};

/// Fits a proxy to every chart of `label` and measures it. Where normals cancel out, the chart's
/// entry of `present` stays its proxy. Cost: two linear passes.
std::vector<VsaRegion> fitRegions(const std::vector<GrowthFace>& faces,
                                  std::span<const glm::dvec3> present);

/// What two charts would cost more as one: E = 2 (A - |S|) for each with the best proxy.
double mergeCost(const VsaRegion& a, const VsaRegion& b);

/// The cheapest face of two charts for a common proxy, lowest on ties; kNone without any.
Index bestOfTwo(const std::vector<GrowthFace>& faces, Index a, Index b, const glm::dvec3& normal);

/// Pairs of charts that share an edge, smaller number first, ascending.
std::vector<std::pair<Index, Index>> neighbourCharts(const GrowthGraph& graph);

}  // namespace chartflood
