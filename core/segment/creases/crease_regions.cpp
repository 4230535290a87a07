#include "core/segment/creases/crease_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/creases/region_graph.h"
#include "core/segment/creases/split_chart.h"

namespace chartflood {

namespace {

constexpr double kSmallest = 0.002;  // share of the surface that a region needs
// Of a model that creases divide:
constexpr std::size_t kDivisions = 3;   // parts that creases add to separate ones, at least
constexpr double kLargestShare = 0.6;   // share of the largest part
constexpr double kLargestCurved = 0.4;  // the same where that is curved
constexpr double kInLarge = 0.95;       // share of the surface in parts that are not small
/// What a split's way over a crease is longer by, in widths of the chart. One: splits follow the
/// creases of fandisk's kind where seams get 2 % longer by it at most. Four, longer than nearly all
/// ways around: wherever they can.
constexpr double kAcross = 1, kAcrossFirst = 4;

/// Numbers the labels without gaps, by their first face.
CreaseRegions numbered(std::span<const Index> label, std::size_t bound) {
  CreaseRegions regions;
  std::vector<Index> number(bound, kNone);
  for (const Index l : label) {
    if (number[l] == kNone) number[l] = static_cast<Index>(regions.count++);
    regions.label.push_back(number[l]);
  }
  return regions;
}

/// Faces that can be reached without crossing a sharp edge.
CreaseRegions smoothParts(const Mesh& mesh, const GaussArea& gauss) {
  const auto opposite = mesh.opposite();
  std::vector<bool> sharp(opposite.size(), false);
  for (const Index s : gauss.sharpEdges) sharp[s] = sharp[opposite[s]] = true;
  CreaseRegions regions;
  regions.label.assign(mesh.faceCount(), kNone);
  std::vector<Index> queue;
  for (Index start = 0; start < mesh.faceCount(); ++start) {
    if (regions.label[start] != kNone) continue;
    const Index number = static_cast<Index>(regions.count++);
    regions.label[start] = number;
    queue.assign(1, start);
    while (!queue.empty()) {
      const Index f = queue.back();
      queue.pop_back();
      for (Index s = 3 * mesh.triangleBegin(f); s < 3 * mesh.triangleBegin(f + 1); ++s) {
        if (opposite[s] == kNone || sharp[s]) continue;
        const Index g = mesh.faceOf(opposite[s] / 3);
        if (regions.label[g] != kNone) continue;
        regions.label[g] = number;
        queue.push_back(g);
      }
    }
  }
  return regions;
}

/// 1 for sides of sharp edges with the same part on both sides, for creases that fade out and those
/// of parts that meet themselves: no region ends there, but splits of one do. Walls of small holes,
/// which were joined with what is around them, are no place to split at.
std::vector<std::uint8_t> fadingCreases(const Mesh& mesh, const GaussArea& gauss) {
  if (gauss.sharpEdges.empty()) return {};
  const CreaseRegions parts = smoothParts(mesh, gauss);
  std::vector<std::uint8_t> fading(mesh.opposite().size(), 0);
  for (const Index s : gauss.sharpEdges) {
    const Index other = mesh.opposite()[s];
    if (parts.label[mesh.faceOf(s / 3)] != parts.label[mesh.faceOf(other / 3)]) continue;
    fading[s] = fading[other] = 1;
  }
  return fading;
}

std::vector<double> regionAreas(const Mesh& mesh, const CreaseRegions& regions) {
  std::vector<double> area(regions.count, 0);
  const FaceValues faceArea = faceAreas(mesh);
  for (Index f = 0; f < faceArea.size(); ++f) area[regions.label[f]] += faceArea[f];
  return area;
}

}  // namespace

CreaseRegions creaseRegions(const Mesh& mesh, const GaussArea& gauss) {
  const CreaseRegions parts = smoothParts(mesh, gauss);
  const auto opposite = mesh.opposite();
  const auto positions = mesh.positions();
  std::vector<std::map<Index, double>> border(parts.count);  // length against each neighbour
  for (Index s = 0; s < opposite.size(); ++s) {
    if (opposite[s] == kNone) continue;
    const Index a = parts.label[mesh.faceOf(s / 3)];
    const Index b = parts.label[mesh.faceOf(opposite[s] / 3)];
    if (a == b) continue;
    border[a][b] += glm::length(positions[mesh.sideStart(s)] - positions[mesh.sideEnd(s)]);
  }
  std::vector<double> area = regionAreas(mesh, parts);
  std::vector<Index> into(parts.count);
  const double least = kSmallest * mesh.surfaceArea();
  std::set<std::pair<double, Index>> small;  // the smallest first
  for (Index r = 0; r < parts.count; ++r) {
    into[r] = r;
    if (area[r] < least) small.emplace(area[r], r);
  }
  while (!small.empty()) {
    const Index r = small.begin()->second;
    small.erase(small.begin());
    Index best = kNone;
    double longest = -1;
    for (const auto& [other, length] : border[r]) {
      if (length > longest) best = other;
      longest = std::max(longest, length);
    }
    if (best == kNone) continue;  // a part of its own
    small.erase({area[best], best});
    area[best] += area[r];
    if (area[best] < least) small.emplace(area[best], best);
    into[r] = best;
    for (const auto& [other, length] : border[r]) {
      border[other].erase(r);
      if (other == best) continue;
      border[best][other] += length;
      border[other][best] += length;
    }
    border[r].clear();
  }
  std::vector<Index> label(parts.label);
  for (Index& l : label) {
    while (into[l] != l) l = into[l] = into[into[l]];
  }
  return numbered(label, parts.count);
}

bool dividedByCreases(const Mesh& mesh, const GaussArea& gauss) {
  const CreaseRegions parts = smoothParts(mesh, gauss);
  if (parts.count < mesh.componentCount() + kDivisions) return false;
  const double surface = mesh.surfaceArea();
  const std::vector<double> area = regionAreas(mesh, parts);
  const FaceValues faceGauss = faceGaussArea(mesh, gauss);
  std::vector<double> curved(parts.count, 0);
  for (Index f = 0; f < faceGauss.size(); ++f) curved[parts.label[f]] += faceGauss[f];
  double large = 0;
  for (Index r = 0; r < parts.count; ++r) {
    const bool soft = curved[r] > std::numbers::pi;
    if (area[r] > (soft ? kLargestCurved : kLargestShare) * surface) return false;
    if (area[r] >= kSmallest * surface) large += area[r];
  }
  double length = 0, between = 0;
  for (const Index s : gauss.sharpEdges) {
    const Index other = mesh.opposite()[s];
    const double l =
        glm::length(mesh.positions()[mesh.sideStart(s)] - mesh.positions()[mesh.sideEnd(s)]);
    length += l;
    if (parts.label[mesh.faceOf(s / 3)] != parts.label[mesh.faceOf(other / 3)]) between += l;
  }
  return large >= kInLarge * surface && between >= length / 2;
}

CreaseRegions chartsFromCreases(const Mesh& mesh, const GaussArea& gauss,
                                std::span<const double> faceGauss, CreaseRegions regions,
                                std::size_t charts, Rng& rng, const CreaseRules& rules) {
  if (regions.count > charts) {
    RegionGraph graph(mesh, regions.label, regions.count);
    while (graph.count() > charts &&
           ((!rules.partner.empty() && graph.joinLone()) || graph.joinBest())) {
    }
    std::vector<Index> label(regions.label);
    for (Index& l : label) l = graph.regionNow(l);
    return numbered(label, regions.count);
  }
  const std::vector<std::uint8_t> fading = fadingCreases(mesh, gauss);
  // Quads are parted once all charts are single ones.
  const double across = rules.first ? kAcrossFirst : kAcross;
  for (const std::span<const Index> together : {rules.partner, std::span<const Index>()}) {
    ChartSplitter splitter(mesh, gauss, faceGauss, std::move(regions.label), regions.count,
                           {together, rules.most, fading, across});
    while (splitter.count() < charts && splitter.splitNext(rng)) {
    }
    regions = numbered(splitter.labels(), splitter.count());
    if (together.empty() || regions.count == charts) break;
  }
  return regions;
}

}  // namespace chartflood
