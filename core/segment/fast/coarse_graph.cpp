#include "core/segment/fast/coarse_graph.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/flood/build_flood_graph.h"
#include "core/segment/parts/seed_spread.h"

namespace chartflood {

namespace {

constexpr std::size_t kFewClusters = 5000;      // at least, where there are faces enough
constexpr std::size_t kManyClusters = 8000;     // at least, on meshes that make them coarse
constexpr std::size_t kCoarseCluster = 128;     // faces of a cluster that is coarse
constexpr std::size_t kClustersPerChart = 200;  // fewer than 150 cost balance
constexpr std::size_t kSmallestCluster = 4, kLargestCluster = 256;  // faces a cluster

constexpr std::size_t kParallelFaces = 100000;  // from which sums are made in parts
constexpr std::size_t kParts = 4;

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

/// What the faces of a cluster add up to.
struct NodeSum {
  double weight = 0;
  glm::dvec3 center{0};  ///< times weight
  Ways ways;

  void add(const NodeSum& other) {
    weight += other.weight;
    center += other.center;
    ways.length += other.ways.length;
    ways.passed += other.ways.passed;
  }
};

/// Sizes and places of faces. Triangles tell them at once; of polygons they are kept.
class Faces {
 public:
  explicit Faces(const NodeGraphSource& source) : mesh_(source.mesh), flood_(source.flood) {
    if (!flood_.packed()) centroid_ = faceCentroids(mesh_);
  }

  double area(Index f) const {
    double sum = 0;
    for (Index t = mesh_.triangleBegin(f); t < mesh_.triangleBegin(f + 1); ++t) {
      sum += mesh_.triangleArea()[t];
    }
    return sum;
  }
  glm::dvec3 centroid(Index f) const {
    if (!flood_.packed()) return centroid_[f];
    return (corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3.0;
  }
  /// Calls `visit(g, distance, delay)` for each way from f to a face g.
  template <class Visit>
  void forWays(Index f, const Visit& visit) const {
    if (!flood_.packed()) {
      for (Index i = flood_.arcBegin[f]; i < flood_.arcBegin[f + 1]; ++i) {
        const FloodArc& arc = flood_.arcs[i];
        visit(arc.face, glm::length(centroid_[f] - centroid_[arc.face]), arc.delay);
      }
      return;
    }
    const FloodFace& record = flood_.faces[f];
    for (Index k = 0; k < 3; ++k) {
      if (record.neighbour[k] == kNone) continue;
      const Index across = record.neighbour[k];
      visit(across >> 2, centroidDistance(mesh_, f, k, across), record.delay[k]);
    }
  }

 private:
  const glm::dvec3& corner(Index f, Index k) const {
    return mesh_.positions()[mesh_.triangles()[f][k]];
  }

  const Mesh& mesh_;
  const FloodGraph& flood_;
  std::vector<glm::dvec3> centroid_;
};

/// Adds up the faces of one part of the mesh. Ways belong to the cluster that they lead into.
void addFaces(const Faces& faces, std::span<const Index> nodeOfFace, std::size_t begin,
              std::size_t end, std::span<NodeSum> sums) {
  for (Index f = static_cast<Index>(begin); f < end; ++f) {
    // The centroid of clusters without area is that of their faces.
    const double w = 1e-300 + faces.area(f);
    NodeSum& sum = sums[nodeOfFace[f]];
    sum.weight += w;
    sum.center += w * faces.centroid(f);
    faces.forWays(f, [&](Index g, double distance, float delay) {
      sums[nodeOfFace[g]].ways.add(distance, static_cast<double>(delay));
    });
  }
}

/// Area-weighted centres, and the mean slowness of each cluster.
std::vector<double> measureNodes(const NodeGraphSource& source, CoarseGraph& coarse) {
  const Faces all(source);
  const std::size_t nodes = coarse.nodeCount(), faces = source.mesh.faceCount();
  // The parts are the same for any number of threads, and so are the sums.
  const std::size_t parts = faces >= kParallelFaces ? kParts : 1;
  std::vector<std::vector<NodeSum>> sums(parts);
  parallelFor(parts, [&](std::size_t part) {
    sums[part].resize(nodes);
    addFaces(all, coarse.nodes.nodeOfFace, faces * part / parts, faces * (part + 1) / parts,
             sums[part]);
  });
  std::vector<double> slowness(nodes, 0);
  coarse.center.resize(nodes);
  for (std::size_t n = 0; n < nodes; ++n) {
    NodeSum sum;
    for (const auto& part : sums) sum.add(part[n]);
    coarse.center[n] = sum.center / sum.weight;
    if (sum.ways.passed > 0) slowness[n] = sum.ways.length / sum.ways.passed;
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
      visit(next, static_cast<float>(glm::length(graph.center[node] - graph.center[next])));
    }
  }
};

}  // namespace

std::size_t coarseClusterSize(std::size_t faces, std::size_t charts) {
  const std::size_t least = std::clamp(faces / kCoarseCluster, kFewClusters, kManyClusters);
  return std::clamp(faces / std::max(least, kClustersPerChart * charts), kSmallestCluster,
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
                                    std::size_t count, std::span<const Index> given,
                                    const PartShares& shares, Rng& rng) {
  return spreadSeeds(NodeDual{graph}, graph.component, components, count, given, shares, rng);
}

}  // namespace chartflood
