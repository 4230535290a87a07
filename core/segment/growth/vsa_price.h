#pragma once
/// What variational shape approximation pays for a face while seams are shortened.

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "core/segment/growth/growth_graph.h"
#include "core/segment/parts/chart_price.h"

namespace chartflood {

/// Its own L2,1 cost, area * |n - N|^2, over the whole area. Proxies are fitted as by the method.
/// \param faces outlive the price
std::unique_ptr<ChartPrice> makeVsaPrice(const std::vector<GrowthFace>& faces,
                                         std::vector<glm::dvec3> normals);

}  // namespace chartflood
