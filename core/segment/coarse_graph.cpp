#include "core/segment/coarse_graph.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/flood/build_flood_graph.h"
#include "core/segment/seed_spread.h"

namespace chartflood {

namespace {

constexpr std::size_t kClusters = 8000;         // at least, where there are faces enough
constexpr std::size_t kClustersPerChart = 200;  // fewer than 150 cost balance
constexpr std::size_t kSmallestCluster = 4, kLargestCluster = 256;  // faces a cluster

/// Ways into the faces of a cluster.
struct Ways {
  double length = 0;
  double passed = 0;  ///< sum of length / slowness

  void add(double distance, double delay) {
    if (!(delay > 0)) return;
    length += distance;
    passed += distance * distance / delay;
  }
};

/// Area-weighted centres, and the mean slowness of each cluster.
std::vector<double> measureNodes(const NodeGraphSource& source, CoarseGraph& coarse) {
  const Mesh& mesh = source.mesh;
  const std::vector<glm::dvec3> centroid = faceCentroids(mesh);
  const auto area = mesh.triangleArea();
  std::vector<double> weight(coarse.nodeCount(), 0);
  std::vector<Ways> ways(coarse.nodeCount());
  coarse.center.assign(coarse.nodeCount(), glm::dvec3(0));
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    double w = 1e-300;  // the centroid of clusters without area is that of their faces
    for (Index t = mesh.triangleBegin(f); t < mesh.triangleBegin(f + 1); ++t) w += area[t];
    const Index node = coarse.nodes.nodeOfFace[f];
    weight[node] += w;
    coarse.center[node] += w * centroid[f];
    const auto enter = [&](Index g, float delay) {
      ways[coarse.nodes.nodeOfFace[g]].add(glm::length(centroid[f] - centroid[g]),
                                           static_cast<double>(delay));
    };
    const FloodGraph& flood = source.flood;
    if (flood.packed()) {
      const FloodFace& record = flood.faces[f];
      for (int k = 0; k < 3; ++k) {
        if (record.neighbour[k] != kNone) enter(record.neighbour[k] >> 2, record.delay[k]);
      }
    } else {
      for (Index i = flood.arcBegin[f]; i < flood.arcBegin[f + 1]; ++i) {
        enter(flood.arcs[i].face, flood.arcs[i].delay);
      }
    }
  }
  std::vector<double> slowness(coarse.nodeCount(), 0);
  for (std::size_t n = 0; n < slowness.size(); ++n) {
    coarse.center[n] /= weight[n];
    if (ways[n].passed > 0) slowness[n] = ways[n].length / ways[n].passed;
  }
  return slowness;
}

/// Neighbours of nodes with the distances between centres.
struct NodeDual {
  const CoarseGraph& graph;

  template <class Visit>
  void forNeighbours(Index node, const Visit& visit) const {
    const FloodGraph& flood = graph.nodes.flood;
    for (Index i = flood.arcBegin[node]; i < flood.arcBegin[node + 1]; ++i) {
      const Index next = flood.arcs[i].face;
      visit(next, glm::length(graph.center[node] - graph.center[next]));
    }
  }
};

}  // namespace

std::size_t coarseClusterSize(std::size_t faces, std::size_t charts) {
  return std::clamp(faces / std::max(kClusters, kClustersPerChart * charts), kSmallestCluster,
                    kLargestCluster);
}

CoarseGraph makeCoarseGraph(const NodeGraphSource& source, FaceClusters clusters) {
  CoarseGraph coarse;
  coarse.start = std::move(clusters.start);
  for (const Index face : coarse.start) {
    coarse.component.push_back(source.mesh.faceComponent()[face]);
  }
  std::vector<Index> sideOfArc;
  coarse.nodes = buildNodeGraph(source, std::move(clusters.ofFace), clusters.count, sideOfArc);
  const std::vector<double> slowness = measureNodes(source, coarse);
  FloodGraph& flood = coarse.nodes.flood;
  for (Index n = 0; n < coarse.nodeCount(); ++n) {
    for (Index i = flood.arcBegin[n]; i < flood.arcBegin[n + 1]; ++i) {
      const Index next = flood.arcs[i].face;
      const double distance = glm::length(coarse.center[n] - coarse.center[next]);
      flood.arcs[i].delay = static_cast<float>(distance * 0.5 * (slowness[n] + slowness[next]));
    }
  }
  return coarse;
}

std::vector<Index> placeCoarseSeeds(const CoarseGraph& graph, std::size_t components,
                                    std::size_t count, std::span<const Index> given, Rng& rng) {
  std::vector<double> weight(components, 0);
  for (Index n = 0; n < graph.nodeCount(); ++n) {
    weight[graph.component[n]] += static_cast<double>(graph.nodes.flood.gain[n]);
  }
  return spreadSeeds(NodeDual{graph}, graph.component, components, count, given, weight, rng);
}

}  // namespace chartflood
