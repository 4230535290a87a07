#include "core/segment/seam_band.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/flood/build_flood_graph.h"

namespace chartflood {

namespace {

constexpr std::size_t kSeamBlock = 1 << 14;
constexpr std::size_t kAhead = 16;  // faces between fetching and use

/// Says which faces stay.
class BandFinder {
 public:
  BandFinder(const Mesh& mesh, std::span<const Index> label) : mesh_(mesh), label_(label) {}

  /// Chart of each face that stays, kNone for those that are freed.
  std::vector<Index> rests(std::span<const Index> seeds, std::size_t rings) {
    free_.assign(label_.size(), 0);
    freeNearSeams(rings);
    findParts(seeds);
    std::vector<Index> rest(label_.size(), kNone);
    for (Index f = 0; f < rest.size(); ++f) {
      if (free_[f] == 0 && chosen_[label_[f]] == part_[f]) rest[f] = label_[f];
    }
    for (Index chart = 0; chart < seeds.size(); ++chart) {
      if (rest[seeds[chart]] == kNone) keepWay(seeds[chart], rest);
    }
    return rest;
  }

 private:
  template <class Visit>
  void forNeighbours(Index f, const Visit& visit) const {
    const auto opposite = mesh_.opposite();
    for (Index s = 3 * mesh_.triangleBegin(f); s < 3 * mesh_.triangleBegin(f + 1); ++s) {
      if (opposite[s] != kNone) visit(mesh_.faceOf(opposite[s] / 3));
    }
  }

  void freeNearSeams(std::size_t rings) {
    const std::size_t blocks = (label_.size() + kSeamBlock - 1) / kSeamBlock;
    std::vector<std::vector<Index>> found(blocks);
    parallelBlocks(label_.size(), kSeamBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        bool seam = false;
        forNeighbours(static_cast<Index>(f),
                      [&](Index g) { seam = seam || label_[g] != label_[f]; });
        if (seam) found[begin / kSeamBlock].push_back(static_cast<Index>(f));
      }
    });
    std::vector<Index> front, next;
    for (const auto& list : found) front.insert(front.end(), list.begin(), list.end());
    for (const Index f : front) free_[f] = 1;
    for (std::size_t ring = 0; ring < rings && !front.empty(); ++ring) {
      next.clear();
      for (const Index f : front) {
        forNeighbours(f, [&](Index g) {
          if (free_[g] != 0) return;
          free_[g] = 1;
          next.push_back(g);
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
    std::vector<Index> queue(label_.size());
    Index parts = 0;
    for (Index start = 0; start < label_.size(); ++start) {
      if (free_[start] != 0 || part_[start] != kNone) continue;
      part_[start] = parts;
      queue[0] = start;
      std::size_t filled = 1;
      for (std::size_t i = 0; i < filled; ++i) {
        if (i + kAhead < filled) {
          __builtin_prefetch(&mesh_.opposite()[3 * mesh_.triangleBegin(queue[i + kAhead])]);
        }
        forNeighbours(queue[i], [&](Index g) {
          if (free_[g] != 0 || part_[g] != kNone) return;
          part_[g] = parts;
          queue[filled++] = g;
        });
      }
      const Index chart = label_[start];
      if (filled > size[chart]) {
        size[chart] = filled;
        chosen_[chart] = parts;
      }
      ++parts;
    }
    for (Index chart = 0; chart < seeds.size(); ++chart) {
      if (free_[seeds[chart]] == 0) chosen_[chart] = part_[seeds[chart]];
    }
  }

  /// Keeps the seed and the shortest way from it to the rest of its chart, if there is one.
  void keepWay(Index seed, std::vector<Index>& rest) const {
    const Index chart = label_[seed];
    rest[seed] = chart;
    if (chosen_[chart] == kNone) return;
    std::vector<std::pair<Index, Index>> queue = {{seed, kNone}};  // face, place of the one before
    std::vector<Index> seen = {seed};
    std::vector<bool> met(label_.size(), false);
    met[seed] = true;
    Index found = kNone;
    for (Index i = 0; i < queue.size() && found == kNone; ++i) {
      forNeighbours(queue[i].first, [&](Index g) {
        if (found != kNone || met[g] || label_[g] != chart) return;
        met[g] = true;
        if (rest[g] == chart) found = i;
        queue.emplace_back(g, i);
      });
    }
    for (Index i = found; i != kNone; i = queue[i].second) rest[queue[i].first] = chart;
  }

  const Mesh& mesh_;
  std::span<const Index> label_;
  std::vector<std::uint8_t> free_;
  std::vector<Index> part_;    ///< of faces that are not free
  std::vector<Index> chosen_;  ///< part of each chart that stays
};

glm::dvec3 centroidOf(const Mesh& mesh, Index face) {
  glm::dvec3 sum(0);
  const Index begin = mesh.triangleBegin(face), end = mesh.triangleBegin(face + 1);
  for (Index t = begin; t < end; ++t) {
    for (const Index v : mesh.triangles()[t]) sum += mesh.positions()[v];
  }
  return sum / (3.0 * static_cast<double>(end - begin));
}

}  // namespace

SeamBand makeSeamBand(const NodeGraphSource& source, std::span<const Index> label,
                      std::span<const Index> seeds, std::size_t rings) {
  const Mesh& mesh = source.mesh;
  SeamBand band;
  std::vector<Index> nodeOfFace = BandFinder(mesh, label).rests(seeds, rings);
  for (const Index rest : nodeOfFace) band.freeFaces += rest == kNone ? 1 : 0;
  Index next = 0;
  for (Index& node : nodeOfFace) {
    node = node == kNone ? next++ : static_cast<Index>(band.freeFaces) + node;
  }
  for (Index chart = 0; chart < seeds.size(); ++chart) {
    band.seeds.push_back(static_cast<Index>(band.freeFaces) + chart);
  }
  std::vector<Index> sideOfArc;
  band.nodes =
      buildNodeGraph(source, std::move(nodeOfFace), band.freeFaces + seeds.size(), sideOfArc);
  if (mesh.facesAreTriangles()) band.nodes.flood.firstHub = static_cast<Index>(band.freeFaces);
  std::vector<FloodArc>& arcs = band.nodes.flood.arcs;
  parallelBlocks(arcs.size(), kSeamBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index side = sideOfArc[i];
      arcs[i].delay =
          static_cast<float>(glm::length(centroidOf(mesh, mesh.faceOf(side / 3)) -
                                         centroidOf(mesh, mesh.faceOf(mesh.opposite()[side] / 3))));
    }
  });
  return band;
}

}  // namespace chartflood
