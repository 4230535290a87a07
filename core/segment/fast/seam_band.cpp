#include "core/segment/fast/seam_band.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/flood/build_flood_graph.h"
#include "core/segment/fast/band_graph.h"

namespace chartflood {

namespace {

constexpr std::size_t kArcBlock = 1 << 14;

/// Says which clusters stay.
class RestFinder {
 public:
  RestFinder(const FloodGraph& graph, std::span<const Index> label)
      : graph_(graph), label_(label), free_(label.size(), 0) {}

  /// Chart of each cluster that stays, kNone for those that are freed.
  std::vector<Index> rests(std::span<const Index> seeds, std::size_t rings) {
    freeNearSeams(rings);
    findParts(seeds);
    std::vector<Index> rest(label_.size(), kNone);
    for (Index n = 0; n < rest.size(); ++n) {
      if (free_[n] == 0 && chosen_[label_[n]] == part_[n]) rest[n] = label_[n];
    }
    for (const Index seed : seeds) {
      if (rest[seed] == kNone) keepWay(seed, rest);
    }
    return rest;
  }

 private:
  template <class Visit>
  void forNeighbours(Index node, const Visit& visit) const {
    for (Index i = graph_.arcBegin[node]; i < graph_.arcBegin[node + 1]; ++i) {
      visit(graph_.arcs[i].face);
    }
  }

  void freeNearSeams(std::size_t rings) {
    std::vector<Index> front, next;
    for (Index n = 0; n < label_.size(); ++n) {
      bool seam = false;
      forNeighbours(n, [&](Index other) { seam = seam || label_[other] != label_[n]; });
      if (seam) front.push_back(n);
    }
    for (const Index n : front) free_[n] = 1;
    for (std::size_t ring = 1; ring < rings; ++ring) {
      next.clear();
      for (const Index n : front) {
        forNeighbours(n, [&](Index other) {
          if (free_[other] != 0) return;
          free_[other] = 1;
          next.push_back(other);
        });
      }
      front.swap(next);
    }
  }

  /// Connected parts of what is not free; of each chart the one with the seed or the largest.
  void findParts(std::span<const Index> seeds) {
    part_.assign(label_.size(), kNone);
    chosen_.assign(seeds.size(), kNone);
    std::vector<std::size_t> size(seeds.size(), 0);
    std::vector<Index> queue;
    Index parts = 0;
    for (Index start = 0; start < label_.size(); ++start) {
      if (free_[start] != 0 || part_[start] != kNone) continue;
      const Index chart = label_[start];
      part_[start] = parts;
      queue.assign(1, start);
      for (std::size_t i = 0; i < queue.size(); ++i) {
        forNeighbours(queue[i], [&](Index other) {
          if (free_[other] != 0 || part_[other] != kNone || label_[other] != chart) return;
          part_[other] = parts;
          queue.push_back(other);
        });
      }
      if (queue.size() > size[chart]) {
        size[chart] = queue.size();
        chosen_[chart] = parts;
      }
      ++parts;
    }
    for (const Index seed : seeds) {
      if (free_[seed] == 0) chosen_[label_[seed]] = part_[seed];
    }
  }

  /// Keeps the seed and the shortest way from it to the rest of its chart, if there is one.
  void keepWay(Index seed, std::vector<Index>& rest) const {
    const Index chart = label_[seed];
    rest[seed] = chart;
    if (chosen_[chart] == kNone) return;
    std::vector<std::pair<Index, Index>> queue = {{seed, kNone}};  // node, place of the one before
    std::vector<bool> met(label_.size(), false);
    met[seed] = true;
    Index found = kNone;
    for (Index i = 0; i < queue.size() && found == kNone; ++i) {
      forNeighbours(queue[i].first, [&](Index other) {
        if (found != kNone || met[other] || label_[other] != chart) return;
        met[other] = true;
        if (rest[other] == chart) found = i;
        queue.emplace_back(other, i);
      });
    }
    for (Index i = found; i != kNone; i = queue[i].second) rest[queue[i].first] = chart;
  }

  const FloodGraph& graph_;
  std::span<const Index> label_;
  std::vector<std::uint8_t> free_;
  std::vector<Index> part_;    ///< of clusters that are not free
  std::vector<Index> chosen_;  ///< part of each chart that stays
};

/// The band of a mesh of polygons.
NodeGraph polygonBand(const NodeGraphSource& source, std::vector<Index> nodeOfFace,
                      std::size_t nodes) {
  const Mesh& mesh = source.mesh;
  const std::vector<glm::dvec3> centroid = faceCentroids(mesh);
  std::vector<Index> sideOfArc;
  NodeGraph graph = buildNodeGraph(source, std::move(nodeOfFace), nodes, sideOfArc);
  parallelBlocks(sideOfArc.size(), kArcBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index from = mesh.faceOf(sideOfArc[i] / 3);
      const Index to = mesh.faceOf(mesh.opposite()[sideOfArc[i]] / 3);
      graph.flood.arcs[i].delay = static_cast<float>(glm::length(centroid[from] - centroid[to]));
    }
  });
  return graph;
}

}  // namespace

SeamBand makeSeamBand(const NodeGraphSource& source, const NodeGraph& clusters,
                      std::span<const Index> label, std::span<const Index> seeds,
                      std::size_t rings) {
  const std::vector<Index> rest = RestFinder(clusters.flood, label).rests(seeds, rings);
  BandFaces faces = numberBandFaces(clusters, rest);
  SeamBand band;
  band.freeFaces = faces.free.size();
  for (Index chart = 0; chart < seeds.size(); ++chart) {
    band.seeds.push_back(static_cast<Index>(band.freeFaces) + chart);
  }
  band.nodes =
      source.flood.packed()
          ? triangleBand(source, clusters, rest, seeds.size(), std::move(faces))
          : polygonBand(source, std::move(faces.nodeOfFace), band.freeFaces + seeds.size());
  return band;
}

}  // namespace chartflood
