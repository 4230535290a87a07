#include "core/segment/borders/seam_level.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/flood/build_flood_graph.h"
#include "core/segment/borders/crease_lines.h"
#include "core/segment/parts/face_clusters.h"

namespace chartflood {

SeamTables makeSeamTables(const Mesh& mesh, const GaussArea& gauss,
                          std::span<const double> faceGauss, double creaseWeight, double eta,
                          std::span<const double> sideFactor) {
  SeamTables tables;
  const auto positions = mesh.positions();
  tables.sideLength.resize(3 * mesh.triangleCount());
  for (Index s = 0; s < tables.sideLength.size(); ++s) {
    tables.sideLength[s] = glm::length(positions[mesh.sideStart(s)] - positions[mesh.sideEnd(s)]);
  }
  const std::vector<std::uint8_t> line = creaseLines(mesh, gauss);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == 0) continue;
    const Index side = gauss.sharpEdges[i];
    tables.sideLength[side] *= creaseWeight;
    tables.sideLength[mesh.opposite()[side]] *= creaseWeight;
  }
  for (Index s = 0; s < sideFactor.size(); ++s) tables.sideLength[s] *= sideFactor[s];
  if (!gauss.sharpEdges.empty()) tables.sideGauss.assign(tables.sideLength.size(), 0);
  for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
    const Index side = gauss.sharpEdges[i];
    tables.sideGauss[side] = tables.sideGauss[mesh.opposite()[side]] = gauss.edge[i];
  }
  if (!gauss.corners.empty()) tables.vertexGauss.assign(mesh.vertexCount(), 0);
  for (std::size_t i = 0; i < gauss.corners.size(); ++i) {
    tables.vertexGauss[gauss.corners[i]] = gauss.corner[i];
  }
  tables.faceArea = faceAreas(mesh);
  tables.center = faceCentroids(mesh);
  tables.faceValue.resize(mesh.faceCount());
  for (std::size_t f = 0; f < tables.faceValue.size(); ++f) {
    tables.faceValue[f] = faceGauss[f] + eta * tables.faceArea[f];
  }
  return tables;
}

namespace {

/// Fills a level from the mesh, part by part. Blocks of work are of about equal numbers of faces or
/// vertices, whatever the number of threads, and every sum runs over ascending faces and sides.
class LevelBuilder {
 public:
  LevelBuilder(const Mesh& mesh, const SeamTables& tables, SeamLevel& level, std::size_t nodes)
      : mesh_(mesh), tables_(tables), level_(level), nodes_(nodes) {}

  void addFaces() {
    level_.value.assign(nodes_, 0);
    level_.area.assign(nodes_, 0);
    level_.euler.assign(nodes_, 0);
    level_.center.assign(nodes_, glm::dvec3(0));
    level_.fixed.assign(nodes_, 0);
    listFaces();
    parallelFor(blocks_.size() - 1, [&](std::size_t block) {
      for (Index i = blocks_[block]; i < blocks_[block + 1]; ++i) addFacesOf(i);
    });
  }

  /// Sums edges inside nodes and gathers those between nodes into arcs.
  void addEdges() {
    std::vector<Arcs> parts(blocks_.size() - 1);
    level_.arcBegin.assign(nodes_ + 1, 0);
    parallelFor(parts.size(), [&](std::size_t block) {
      std::vector<std::pair<Index, Index>> between;
      for (Index i = blocks_[block]; i < blocks_[block + 1]; ++i) {
        between.clear();
        addEdgesOf(i, between);
        std::sort(between.begin(), between.end());
        level_.arcBegin[i + 1] = joinArcs(between, parts[block]);
      }
    });
    for (std::size_t i = 0; i < nodes_; ++i) level_.arcBegin[i + 1] += level_.arcBegin[i];
    level_.arcHead.resize(level_.arcBegin.back());
    level_.arcLength.resize(level_.arcHead.size());
    level_.arcValue.resize(level_.arcHead.size());
    level_.arcEuler.resize(level_.arcHead.size());
    parallelFor(parts.size(), [&](std::size_t block) {
      const auto to = static_cast<std::ptrdiff_t>(level_.arcBegin[blocks_[block]]);
      const Arcs& part = parts[block];
      std::copy(part.head.begin(), part.head.end(), level_.arcHead.begin() + to);
      std::copy(part.length.begin(), part.length.end(), level_.arcLength.begin() + to);
      std::copy(part.value.begin(), part.value.end(), level_.arcValue.begin() + to);
      std::copy(part.euler.begin(), part.euler.end(), level_.arcEuler.begin() + to);
    });
    pairArcs();
  }

  /// Sums vertices inside nodes, adds those between two to their arc, and lists the rest.
  void addVertices() {
    constexpr std::size_t kBlock = 4096;
    const std::size_t count = mesh_.vertexCount();
    std::vector<std::vector<Index>> parts((count + kBlock - 1) / kBlock);
    parallelBlocks(count, kBlock, [&](std::size_t begin, std::size_t end) {
      std::vector<Index>& list = parts[begin / kBlock];
      std::vector<Index> around;
      for (std::size_t v = begin; v < end; ++v) {
        if (!clustersAround(mesh_, level_.nodeOfFace, static_cast<Index>(v), around)) continue;
        list.push_back(static_cast<Index>(v));
        list.push_back(static_cast<Index>(around.size()));
        list.insert(list.end(), around.begin(), around.end());
      }
    });
    level_.cornerNodeBegin.assign(1, 0);
    for (const std::vector<Index>& list : parts) {
      for (std::size_t at = 0; at < list.size();) {
        const Index vertex = list[at], size = list[at + 1];
        addVertex(vertex, std::span(list).subspan(at + 2, size));
        at += 2 + size;
      }
    }
    listCorners();
  }

 private:
  /// Arcs of a block of nodes.
  struct Arcs {
    std::vector<Index> head;
    std::vector<double> length, value;
    std::vector<int> euler;
  };

  Index nodeOfSide(Index side) const { return level_.nodeOfFace[mesh_.faceOf(side / 3)]; }

  /// The faces of each node, and blocks of nodes with about as many faces each.
  void listFaces() {
    constexpr Index kBlockFaces = 4096;
    std::vector<Index>& begin = level_.faceBegin;
    begin.assign(nodes_ + 2, 0);
    for (const Index node : level_.nodeOfFace) ++begin[node + 2];
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    level_.faceOfNode.resize(level_.nodeOfFace.size());
    for (Index f = 0; f < level_.nodeOfFace.size(); ++f) {
      level_.faceOfNode[begin[level_.nodeOfFace[f] + 1]++] = f;
    }
    begin.pop_back();
    blocks_.assign(1, 0);
    for (Index i = 0; i < nodes_; ++i) {
      if (begin[i + 1] - begin[blocks_.back()] >= kBlockFaces) blocks_.push_back(i + 1);
    }
    if (blocks_.back() != nodes_) blocks_.push_back(static_cast<Index>(nodes_));
  }

  void addFacesOf(Index node) {
    const Index begin = level_.faceBegin[node], end = level_.faceBegin[node + 1];
    glm::dvec3 center(0), plain(0);
    for (Index k = begin; k < end; ++k) {
      const Index f = level_.faceOfNode[k];
      level_.value[node] += tables_.faceValue[f];
      level_.area[node] += tables_.faceArea[f];
      level_.euler[node] += static_cast<int>(mesh_.triangleBegin(f + 1) - mesh_.triangleBegin(f));
      center += tables_.faceArea[f] * tables_.center[f];
      plain += tables_.center[f];
    }
    level_.center[node] = level_.area[node] > 1e-300 ? center / level_.area[node]
                                                     : plain / static_cast<double>(end - begin);
  }

  /// \param between takes the node across and the side, of each side between nodes
  void addEdgesOf(Index node, std::vector<std::pair<Index, Index>>& between) {
    const auto opposite = mesh_.opposite();
    for (Index k = level_.faceBegin[node]; k < level_.faceBegin[node + 1]; ++k) {
      const Index f = level_.faceOfNode[k];
      for (Index s = 3 * mesh_.triangleBegin(f); s < 3 * mesh_.triangleBegin(f + 1); ++s) {
        const Index other = opposite[s];
        if (other == kNone) continue;
        const Index across = nodeOfSide(other);
        if (across != node) {
          between.emplace_back(across, s);
        } else if (s < other) {
          --level_.euler[node];
          // A diagonal's Gauss area is part of its face's.
          const bool diagonal = mesh_.faceOf(other / 3) == f;
          if (!diagonal && !tables_.sideGauss.empty()) level_.value[node] += tables_.sideGauss[s];
        }
      }
    }
  }

  /// \return how many arcs there are
  Index joinArcs(std::span<const std::pair<Index, Index>> between, Arcs& arcs) const {
    Index count = 0;
    for (std::size_t k = 0; k < between.size(); ++k) {
      const auto [head, side] = between[k];
      if (k == 0 || between[k - 1].first != head) {
        arcs.head.push_back(head);
        arcs.length.push_back(0);
        arcs.value.push_back(0);
        arcs.euler.push_back(0);
        ++count;
      }
      arcs.length.back() += tables_.sideLength[side];
      if (!tables_.sideGauss.empty()) arcs.value.back() += tables_.sideGauss[side];
      --arcs.euler.back();
    }
    return count;
  }

  void addVertex(Index vertex, std::span<const Index> around) {
    const double gauss = tables_.vertexGauss.empty() ? 0.0 : tables_.vertexGauss[vertex];
    if (around.size() == 1) {
      level_.value[around[0]] += gauss;
      ++level_.euler[around[0]];
    } else if (around.size() == 2) {
      const Index arc = findArc(around[0], around[1]);
      for (const Index a : {arc, level_.arcTwin[arc]}) {
        level_.arcValue[a] += gauss;
        ++level_.arcEuler[a];
      }
    } else {
      level_.cornerNode.insert(level_.cornerNode.end(), around.begin(), around.end());
      level_.cornerNodeBegin.push_back(static_cast<Index>(level_.cornerNode.size()));
      level_.cornerValue.push_back(gauss);
    }
  }

  /// Heads ascend at each node, so the arcs back are met in the same order.
  void pairArcs() {
    std::vector<Index> next(level_.arcBegin.begin(), level_.arcBegin.end() - 1);
    level_.arcTwin.resize(level_.arcHead.size());
    for (Index arc = 0; arc < level_.arcHead.size(); ++arc) {
      level_.arcTwin[arc] = next[level_.arcHead[arc]]++;
    }
  }

  Index findArc(Index from, Index to) const {
    Index arc = level_.arcBegin[from];
    while (level_.arcHead[arc] != to) ++arc;
    return arc;
  }

  void listCorners() {
    std::vector<Index> begin(nodes_ + 2, 0);
    for (const Index node : level_.cornerNode) ++begin[node + 2];
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    level_.nodeCorner.resize(level_.cornerNode.size());
    for (Index c = 0; c < level_.cornerCount(); ++c) {
      for (Index k = level_.cornerNodeBegin[c]; k < level_.cornerNodeBegin[c + 1]; ++k) {
        level_.nodeCorner[begin[level_.cornerNode[k] + 1]++] = c;
      }
    }
    begin.pop_back();
    level_.cornerBegin = std::move(begin);
  }

  const Mesh& mesh_;
  const SeamTables& tables_;
  SeamLevel& level_;
  const std::size_t nodes_;
  std::vector<Index> blocks_;  ///< first node of each block, and the number of nodes
};

}  // namespace

SeamLevel buildSeamLevel(const Mesh& mesh, const SeamTables& tables, std::vector<Index> nodeOfFace,
                         std::size_t nodes) {
  SeamLevel level;
  level.nodeOfFace = std::move(nodeOfFace);
  LevelBuilder builder(mesh, tables, level, nodes);
  builder.addFaces();
  builder.addEdges();
  builder.addVertices();
  return level;
}

}  // namespace chartflood
