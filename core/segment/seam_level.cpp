#include "core/segment/seam_level.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/flood/build_flood_graph.h"
#include "core/segment/face_clusters.h"

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
  for (const Index s : gauss.sharpEdges) {
    tables.sideLength[s] *= creaseWeight;
    tables.sideLength[mesh.opposite()[s]] *= creaseWeight;
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

/// Fills a level from the mesh, part by part.
class LevelBuilder {
 public:
  LevelBuilder(const Mesh& mesh, const SeamTables& tables, SeamLevel& level)
      : mesh_(mesh), tables_(tables), level_(level) {}

  void addFaces() {
    const std::size_t nodes = level_.value.size();
    level_.area.assign(nodes, 0);
    level_.euler.assign(nodes, 0);
    level_.center.assign(nodes, glm::dvec3(0));
    level_.fixed.assign(nodes, 0);
    std::vector<Index> faces(nodes, 0);
    std::vector<glm::dvec3> plain(nodes, glm::dvec3(0));
    for (Index f = 0; f < mesh_.faceCount(); ++f) {
      const Index node = level_.nodeOfFace[f];
      level_.value[node] += tables_.faceValue[f];
      level_.area[node] += tables_.faceArea[f];
      level_.center[node] += tables_.faceArea[f] * tables_.center[f];
      level_.euler[node] += static_cast<int>(mesh_.triangleBegin(f + 1) - mesh_.triangleBegin(f));
      plain[node] += tables_.center[f];
      ++faces[node];
    }
    for (std::size_t i = 0; i < nodes; ++i) {
      level_.center[i] = level_.area[i] > 1e-300 ? level_.center[i] / level_.area[i]
                                                 : plain[i] / static_cast<double>(faces[i]);
    }
  }

  /// Sums edges inside nodes and gathers those between nodes into arcs.
  void addEdges() {
    const auto opposite = mesh_.opposite();
    const std::size_t nodes = level_.value.size();
    std::vector<Index> begin(nodes + 2, 0);
    for (Index s = 0; s < opposite.size(); ++s) {
      const Index other = opposite[s];
      if (other == kNone) continue;
      const Index f = mesh_.faceOf(s / 3), g = mesh_.faceOf(other / 3);
      const Index i = level_.nodeOfFace[f], j = level_.nodeOfFace[g];
      if (i != j) {
        ++begin[i + 2];
      } else if (s < other) {
        --level_.euler[i];
        // A diagonal's Gauss area is part of its face's.
        if (f != g && !tables_.sideGauss.empty()) level_.value[i] += tables_.sideGauss[s];
      }
    }
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<std::pair<Index, Index>> between(begin.back());  // head, side
    for (Index s = 0; s < opposite.size(); ++s) {
      if (opposite[s] == kNone) continue;
      const Index i = nodeOfSide(s), j = nodeOfSide(opposite[s]);
      if (i != j) between[begin[i + 1]++] = {j, s};
    }
    level_.arcBegin.assign(1, 0);
    level_.arcBegin.reserve(nodes + 1);
    for (std::size_t i = 0; i < nodes; ++i) {
      std::sort(between.begin() + begin[i], between.begin() + begin[i + 1]);
      joinArcs(std::span(between).subspan(begin[i], begin[i + 1] - begin[i]));
      level_.arcBegin.push_back(static_cast<Index>(level_.arcHead.size()));
    }
    pairArcs();
  }

  /// Sums vertices inside nodes, adds those between two to their arc, and lists the rest.
  void addVertices() {
    level_.cornerNodeBegin.assign(1, 0);
    std::vector<Index> around;
    for (Index v = 0; v < mesh_.vertexCount(); ++v) {
      if (!clustersAround(mesh_, level_.nodeOfFace, v, around)) continue;
      const double gauss = tables_.vertexGauss.empty() ? 0.0 : tables_.vertexGauss[v];
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
    listCorners();
  }

 private:
  Index nodeOfSide(Index side) const { return level_.nodeOfFace[mesh_.faceOf(side / 3)]; }

  void joinArcs(std::span<const std::pair<Index, Index>> between) {
    for (std::size_t k = 0; k < between.size(); ++k) {
      const auto [head, side] = between[k];
      if (k == 0 || between[k - 1].first != head) {
        level_.arcHead.push_back(head);
        level_.arcLength.push_back(0);
        level_.arcValue.push_back(0);
        level_.arcEuler.push_back(0);
      }
      level_.arcLength.back() += tables_.sideLength[side];
      if (!tables_.sideGauss.empty()) level_.arcValue.back() += tables_.sideGauss[side];
      --level_.arcEuler.back();
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
    const std::size_t nodes = level_.value.size();
    std::vector<Index> begin(nodes + 2, 0);
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
};

}  // namespace

SeamLevel buildSeamLevel(const Mesh& mesh, const SeamTables& tables, std::vector<Index> nodeOfFace,
                         std::size_t nodes) {
  SeamLevel level;
  level.nodeOfFace = std::move(nodeOfFace);
  level.value.assign(nodes, 0);
  LevelBuilder builder(mesh, tables, level);
  builder.addFaces();
  builder.addEdges();
  builder.addVertices();
  return level;
}

}  // namespace chartflood
