#include "core/segment/fast/node_graph.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/segment/parts/face_clusters.h"

namespace chartflood {

namespace {

constexpr std::size_t kSides = 3 << 14;  // of a block

/// A side of the mesh between two nodes, or at the mesh border.
struct Crossing {
  Index from, to, side;
};

/// Fills a node graph from the mesh, part by part.
class NodeGraphBuilder {
 public:
  NodeGraphBuilder(const NodeGraphSource& source, NodeGraph& graph)
      : mesh_(source.mesh), gauss_(source.gauss), faceGauss_(source.faceGauss), graph_(graph),
        surface_(graph.gauss.size(), 0) {}

  void addFaces() {
    const auto area = mesh_.triangleArea();
    for (Index f = 0; f < mesh_.faceCount(); ++f) {
      const Index node = graph_.nodeOfFace[f];
      graph_.gauss[node] += faceGauss_[f];
      for (Index t = mesh_.triangleBegin(f); t < mesh_.triangleBegin(f + 1); ++t) {
        surface_[node] += area[t];
      }
    }
  }

  /// One arc for each pair of nodes that share a side.
  void addArcs(std::vector<Index>& sideOfArc) {
    FloodGraph& flood = graph_.flood;
    const auto opposite = mesh_.opposite();
    const std::size_t nodes = graph_.nodeCount();
    flood.atMeshBorder.assign(nodes, 0);
    std::vector<std::vector<Crossing>> crossings((opposite.size() + kSides - 1) / kSides);
    parallelBlocks(opposite.size(), kSides, [&](std::size_t first, std::size_t last) {
      std::vector<Crossing>& found = crossings[first / kSides];
      for (Index s = static_cast<Index>(first); s < last; ++s) {
        const Index i = nodeOfSide(s);
        const Index j = opposite[s] == kNone ? kNone : nodeOfSide(opposite[s]);
        if (i != j) found.push_back({i, j, s});
      }
    });
    std::vector<Index> begin(nodes + 2, 0);
    for (const auto& block : crossings) {
      for (const Crossing& c : block) {
        if (c.to == kNone) {
          flood.atMeshBorder[c.from] = 1;
        } else {
          ++begin[c.from + 2];
        }
      }
    }
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<std::pair<Index, Index>> between(begin.back());  // head, side
    for (auto& block : crossings) {
      for (const Crossing& c : block) {
        if (c.to != kNone) between[begin[c.from + 1]++] = {c.to, c.side};
      }
      block = {};
    }
    flood.arcBegin.assign(1, 0);
    flood.arcBegin.reserve(nodes + 1);
    for (std::size_t i = 0; i < nodes; ++i) {
      std::sort(between.begin() + begin[i], between.begin() + begin[i + 1]);
      for (Index k = begin[i]; k < begin[i + 1]; ++k) {
        if (k > begin[i] && between[k - 1].first == between[k].first) continue;
        flood.arcs.push_back({between[k].first, kNone, 0.0f, 0.0f});
        sideOfArc.push_back(between[k].second);
      }
      flood.arcBegin.push_back(static_cast<Index>(flood.arcs.size()));
    }
    // Heads ascend at each node, so the arcs back are met in the same order.
    std::vector<Index> next(flood.arcBegin.begin(), flood.arcBegin.end() - 1);
    for (FloodArc& arc : flood.arcs) arc.reverse = next[arc.face]++;
  }

  void addSharpEdges() {
    for (std::size_t i = 0; i < gauss_.sharpEdges.size(); ++i) {
      const Index side = gauss_.sharpEdges[i], other = mesh_.opposite()[side];
      if (mesh_.faceOf(side / 3) == mesh_.faceOf(other / 3)) continue;  // part of its face
      const Index a = nodeOfSide(side), b = nodeOfSide(other);
      if (a == b) {
        graph_.gauss[a] += gauss_.edge[i];
        continue;
      }
      graph_.edges.push_back({a, b, gauss_.edge[i]});
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        findArc(from, to).edgeGain += static_cast<float>(gauss_.edge[i]);
      }
    }
  }

  void addCorners() {
    graph_.cornerNodeBegin.assign(1, 0);
    std::vector<Index> around;
    for (std::size_t i = 0; i < gauss_.corners.size(); ++i) {
      if (!(gauss_.corner[i] > 0)) continue;
      clustersAround(mesh_, graph_.nodeOfFace, gauss_.corners[i], around);
      if (around.size() == 1) {
        graph_.gauss[around[0]] += gauss_.corner[i];
        continue;
      }
      graph_.cornerNode.insert(graph_.cornerNode.end(), around.begin(), around.end());
      graph_.cornerNodeBegin.push_back(static_cast<Index>(graph_.cornerNode.size()));
      graph_.cornerGauss.push_back(gauss_.corner[i]);
    }
    FloodGraph& flood = graph_.flood;
    flood.cornerBegin.assign(graph_.nodeCount() + 1, 0);
    for (const Index node : graph_.cornerNode) ++flood.cornerBegin[node + 1];
    for (std::size_t n = 0; n < graph_.nodeCount(); ++n) {
      flood.cornerBegin[n + 1] += flood.cornerBegin[n];
    }
    flood.corners.resize(graph_.cornerNode.size());
    std::vector<Index> next(flood.cornerBegin.begin(), flood.cornerBegin.end() - 1);
    for (Index c = 0; c < graph_.cornerGauss.size(); ++c) {
      const Index end = graph_.cornerNodeBegin[c + 1];
      for (Index k = graph_.cornerNodeBegin[c]; k < end; ++k) {
        flood.corners[next[graph_.cornerNode[k]]++] = {c, 1};
      }
      flood.cornerGain.push_back(static_cast<float>(graph_.cornerGauss[c]));
      flood.cornerTimes.push_back(end - graph_.cornerNodeBegin[c]);
    }
  }

  void addGains() {
    FloodGraph& flood = graph_.flood;
    flood.gain.resize(graph_.nodeCount());
    for (std::size_t n = 0; n < flood.gain.size(); ++n) {
      flood.gain[n] = static_cast<float>(graph_.gauss[n] + flood.eta * surface_[n]);
    }
  }

 private:
  Index nodeOfSide(Index side) const { return graph_.nodeOfFace[mesh_.faceOf(side / 3)]; }

  FloodArc& findArc(Index from, Index to) {
    const auto first = graph_.flood.arcs.begin() + graph_.flood.arcBegin[from];
    const auto last = graph_.flood.arcs.begin() + graph_.flood.arcBegin[from + 1];
    return *std::lower_bound(first, last, to,
                             [](const FloodArc& arc, Index face) { return arc.face < face; });
  }

  const Mesh& mesh_;
  const GaussArea& gauss_;
  std::span<const double> faceGauss_;
  NodeGraph& graph_;
  std::vector<double> surface_;  ///< of each node
};

}  // namespace

std::vector<double> NodeGraph::chartGauss(std::span<const Index> nodeLabel,
                                          std::size_t charts) const {
  std::vector<double> area(charts, 0);
  for (std::size_t n = 0; n < gauss.size(); ++n) area[nodeLabel[n]] += gauss[n];
  for (const Edge& edge : edges) {
    if (nodeLabel[edge.a] == nodeLabel[edge.b]) area[nodeLabel[edge.a]] += edge.gauss;
  }
  for (std::size_t c = 0; c < cornerGauss.size(); ++c) {
    const Index chart = commonOf(c, nodeLabel);
    if (chart != kNone) area[chart] += cornerGauss[c];
  }
  return area;
}

Index NodeGraph::commonOf(std::size_t corner, std::span<const Index> nodeLabel) const {
  const Index label = nodeLabel[cornerNode[cornerNodeBegin[corner]]];
  for (Index i = cornerNodeBegin[corner] + 1; i < cornerNodeBegin[corner + 1]; ++i) {
    if (nodeLabel[cornerNode[i]] != label) return kNone;
  }
  return label;
}

NodeGraph buildNodeGraph(const NodeGraphSource& source, std::vector<Index> nodeOfFace,
                         std::size_t nodes, std::vector<Index>& sideOfArc) {
  NodeGraph graph;
  graph.nodeOfFace = std::move(nodeOfFace);
  graph.gauss.assign(nodes, 0);
  graph.flood.speeds = source.flood.speeds;
  graph.flood.eta = source.flood.eta;
  graph.flood.faceCount = nodes;
  sideOfArc.clear();
  NodeGraphBuilder builder(source, graph);
  builder.addFaces();
  builder.addArcs(sideOfArc);
  builder.addSharpEdges();
  builder.addCorners();
  builder.addGains();
  return graph;
}

NodeFaces::NodeFaces(const Mesh& mesh, std::span<const Index> nodeOfFace, std::size_t nodes)
    : begin(nodes + 1, 0), face(nodeOfFace.size()) {
  for (const Index node : nodeOfFace) ++begin[node + 1];
  for (std::size_t n = 0; n < nodes; ++n) begin[n + 1] += begin[n];
  std::vector<bool> listed(nodeOfFace.size(), false);
  std::vector<Index> end(begin.begin(), begin.end() - 1);
  for (Index start = 0; start < nodeOfFace.size(); ++start) {
    if (listed[start]) continue;
    const Index node = nodeOfFace[start];
    Index next = end[node];
    const auto list = [&](Index f) {
      listed[f] = true;
      face[end[node]++] = f;
    };
    for (list(start); next < end[node]; ++next) {
      const Index f = face[next];
      for (Index s = 3 * mesh.triangleBegin(f); s < 3 * mesh.triangleBegin(f + 1); ++s) {
        if (mesh.opposite()[s] == kNone) continue;
        const Index g = mesh.faceOf(mesh.opposite()[s] / 3);
        if (!listed[g] && nodeOfFace[g] == node) list(g);
      }
    }
  }
}

}  // namespace chartflood
