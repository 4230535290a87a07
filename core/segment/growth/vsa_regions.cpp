#include "core/segment/growth/vsa_regions.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

double costOf(const GrowthFace& face, const glm::dvec3& normal) {
  const glm::dvec3 d = glm::dvec3(face.normal) - normal;
  return static_cast<double>(face.area) * glm::dot(d, d);
}

/// Costs of a region's extreme faces while it is measured.
struct Extremes {
  double best = std::numeric_limits<double>::infinity();
  double worst = -2, secondWorst = -2;
};

void measureFace(Index f, const GrowthFace& face, VsaRegion& region, Extremes& extremes) {
  const bool usable = face.area > 0;
  const double cost = usable ? costOf(face, region.normal) : -1;
  if (usable) {
    region.cost += cost;
    if (cost < extremes.best) {
      extremes.best = cost;
      region.best = f;
    }
  }
  if (cost > extremes.worst) {
    extremes.secondWorst = extremes.worst;
    region.secondWorst = region.worst;
    extremes.worst = cost;
    region.worst = f;
  } else if (cost > extremes.secondWorst) {
    extremes.secondWorst = cost;
    region.secondWorst = f;
  }
}

}  // namespace

std::vector<VsaRegion> fitRegions(const std::vector<GrowthFace>& faces,
                                  std::span<const glm::dvec3> present) {
  std::vector<VsaRegion> regions(present.size());
  for (const GrowthFace& face : faces) {
    VsaRegion& region = regions[face.label];
    region.sum += static_cast<double>(face.area) * glm::dvec3(face.normal);
    region.area += static_cast<double>(face.area);
  }
  for (std::size_t c = 0; c < regions.size(); ++c) {
    const double length = glm::length(regions[c].sum);
    const bool cancels = !(length > 1e-9 * regions[c].area);
    regions[c].normal = cancels ? present[c] : regions[c].sum / length;
  }
  std::vector<Extremes> extremes(regions.size());
  for (Index f = 0; f < faces.size(); ++f) {
    const Index chart = faces[f].label;
    measureFace(f, faces[f], regions[chart], extremes[chart]);
  }
  return regions;
}

double mergeCost(const VsaRegion& a, const VsaRegion& b) {
  const double apart = glm::length(a.sum) + glm::length(b.sum);
  return 2 * std::max(0.0, apart - glm::length(a.sum + b.sum));
}

Index bestOfTwo(const std::vector<GrowthFace>& faces, Index a, Index b, const glm::dvec3& normal) {
  Index best = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < faces.size(); ++f) {
    if ((faces[f].label != a && faces[f].label != b) || !(faces[f].area > 0)) continue;
    const double cost = costOf(faces[f], normal);
    if (!(cost < least)) continue;
    least = cost;
    best = f;
  }
  return best;
}

std::vector<std::pair<Index, Index>> neighbourCharts(const GrowthGraph& graph) {
  std::vector<std::pair<Index, Index>> pairs;
  for (Index f = 0; f < graph.faces.size(); ++f) {
    const Index here = graph.faces[f].label;
    for (Index a = graph.begin(f); a < graph.begin(f + 1); ++a) {
      if (graph.arcs[a].face == kNone) continue;
      const Index there = graph.faces[graph.arcs[a].face].label;
      if (here < there) pairs.emplace_back(here, there);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace chartflood
