#pragma once
/// What chart growth by shortest paths pays for a face while seams are shortened.

#include <algorithm>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/segment/growth/growth_flood.h"
#include "core/segment/parts/chart_price.h"

namespace chartflood {

/// Its own cost: of the path from the chart's seed to the face with the chart's normal, mean over
/// faces and over the square root of the area. Paths lead through the chart and those beside it;
/// elsewhere a face costs more than any seam. Seeds rest, normals are fitted where that lowers the
/// cost.
/// \param graph outlives the price \param lambda as in the growth
std::unique_ptr<ChartPrice> makeMcgimPrice(const GrowthGraph& graph, const GrowthStart& start,
                                           float lambda);

/// To step to a face of that normal over that length: dearer where it turns away from the chart.
inline float mcgimStep(float lambda, const glm::vec3& chart, const glm::vec3& face, float length) {
  return std::max(0.0f, lambda - glm::dot(chart, face)) * length;
}

}  // namespace chartflood
