#include "core/segment/fast/band_graph.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/flood/build_flood_graph.h"

namespace chartflood {

namespace {

constexpr std::size_t kBandBlock = 1 << 14;  // faces

std::size_t bandBlocks(std::size_t count) { return (count + kBandBlock - 1) / kBandBlock; }

/// A side of a free triangle against a rest.
struct Contact {
  Index hub;
  Index side;  ///< 4 * node + side
  float delay;
};

/// Fills the graph of a band, part by part.
class BandBuilder {
 public:
  BandBuilder(const NodeGraphSource& source, std::span<const Index> free, NodeGraph& graph,
              std::size_t charts)
      : source_(source), mesh_(source.mesh), free_(free), charts_(charts), graph_(graph) {}

  void addFaces() {
    RawVector<FloodFace>& faces = graph_.flood.faces;
    faces.resize(free_.size());
    contacts_.resize(bandBlocks(free_.size()));
    parallelBlocks(free_.size(), kBandBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t node = begin; node < end; ++node) {
        faces[node] = recordOf(static_cast<Index>(node), contacts_[begin / kBandBlock]);
        graph_.gauss[node] = source_.faceGauss[free_[node]];
      }
    });
    // Only entries of free faces are kept.
    std::vector<FloodExtra>& extras = graph_.flood.extras;
    extras.assign(1, {});
    for (FloodFace& face : faces) {
      if (face.extra == 0) continue;
      extras.push_back(source_.flood.extras[face.extra]);
      face.extra = static_cast<Index>(extras.size() - 1);
    }
  }

  /// What lies inside each rest.
  void addRests(const NodeGraph& clusters, std::span<const Index> rest) {
    std::vector<double> gain(charts_, 0);
    const auto add = [&](Index chart, double gauss, double gained) {
      graph_.gauss[free_.size() + chart] += gauss;
      gain[chart] += gained;
    };
    for (std::size_t n = 0; n < rest.size(); ++n) {
      if (rest[n] == kNone) continue;
      add(rest[n], clusters.gauss[n], static_cast<double>(clusters.flood.gain[n]));
    }
    for (const NodeGraph::Edge& edge : clusters.edges) {
      const Index chart = rest[edge.a];
      if (chart != kNone && rest[edge.b] == chart) add(chart, edge.gauss, edge.gauss);
    }
    for (std::size_t c = 0; c < clusters.cornerGauss.size(); ++c) {
      const Index chart = clusters.commonOf(c, rest);
      if (chart != kNone) add(chart, clusters.cornerGauss[c], clusters.cornerGauss[c]);
    }
    for (const double g : gain) graph_.flood.hubs.push_back({static_cast<float>(g), 0, 0});
  }

  /// What the rests touch. \pre addFaces(), addRests()
  void addContacts() {
    FloodGraph& flood = graph_.flood;
    std::vector<Contact> all;
    for (auto& block : contacts_) all.insert(all.end(), block.begin(), block.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Contact& a, const Contact& b) { return a.hub < b.hub; });
    for (std::size_t i = 0; i < all.size();) {
      // A triangle that touches a rest with several sides is reached by the shortest way.
      std::size_t next = i;
      float delay = all[i].delay;
      for (; next < all.size() && all[next].hub == all[i].hub &&
             all[next].side >> 2 == all[i].side >> 2;
           ++next) {
        delay = std::min(delay, all[next].delay);
      }
      for (; i < next; ++i) flood.hubSides.push_back({all[i].side, delay});
      flood.hubs[all[i - 1].hub].sideEnd = static_cast<Index>(flood.hubSides.size());
    }
    for (std::size_t h = 1; h < flood.hubs.size(); ++h) {
      flood.hubs[h].sideEnd = std::max(flood.hubs[h].sideEnd, flood.hubs[h - 1].sideEnd);
    }
  }

  /// Sharp edges between nodes. Those inside a rest are counted there.
  void addSharpEdges() {
    const GaussArea& gauss = source_.gauss;
    for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
      const Index side = gauss.sharpEdges[i];
      const Index a = graph_.nodeOfFace[side / 3];
      const Index b = graph_.nodeOfFace[mesh_.opposite()[side] / 3];
      if (a != b) graph_.edges.push_back({a, b, gauss.edge[i]});
    }
  }

  /// Corners that free faces touch, in their order on the mesh.
  void addCorners() {
    FloodGraph& flood = graph_.flood;
    const FloodGraph& all = source_.flood;
    std::vector<Index> touched(all.cornerGain.size(), 0);  // times, then the number here
    for (const FloodExtra& extra : std::span(flood.extras).subspan(1)) {
      for (const Index corner : extra.corner) {
        if (corner != kNone) ++touched[corner];
      }
    }
    std::vector<std::pair<Index, FloodCorner>> atHubs;
    graph_.cornerNodeBegin.assign(1, 0);
    Index ofMesh = 0;
    for (std::size_t i = 0; i < source_.gauss.corners.size(); ++i) {
      if (!(source_.gauss.corner[i] > 0)) continue;
      const Index here = ofMesh++, times = touched[here];
      if (times == 0) continue;
      const Index number = static_cast<Index>(graph_.cornerGauss.size());
      touched[here] = number;
      graph_.cornerGauss.push_back(source_.gauss.corner[i]);
      flood.cornerGain.push_back(all.cornerGain[here]);
      flood.cornerTimes.push_back(all.cornerTimes[here]);
      const std::size_t before = atHubs.size();
      if (times < all.cornerTimes[here]) hubsAround(source_.gauss.corners[i], number, atHubs);
      graph_.cornerNodeBegin.push_back(graph_.cornerNodeBegin.back() + times +
                                       static_cast<Index>(atHubs.size() - before));
    }
    listCorners(touched, atHubs);
    std::stable_sort(atHubs.begin(), atHubs.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [hub, corner] : atHubs) {
      flood.hubCorners.push_back(corner);
      flood.hubs[hub].cornerEnd = static_cast<Index>(flood.hubCorners.size());
    }
    for (std::size_t h = 1; h < flood.hubs.size(); ++h) {
      flood.hubs[h].cornerEnd = std::max(flood.hubs[h].cornerEnd, flood.hubs[h - 1].cornerEnd);
    }
  }

 private:
  FloodFace recordOf(Index node, std::vector<Contact>& contacts) const {
    const Index face = free_[node];
    FloodFace record = source_.flood.faces[face];
    for (Index k = 0; k < 3; ++k) {
      if (record.neighbour[k] == kNone) continue;
      const Index across = record.neighbour[k];
      record.delay[k] = static_cast<float>(centroidDistance(mesh_, face, k, across));
      const Index there = graph_.nodeOfFace[across >> 2];
      if (there < free_.size()) {
        record.neighbour[k] = 4 * there + (across & 3);
      } else {
        record.neighbour[k] = kNone;
        contacts.push_back(
            {there - static_cast<Index>(free_.size()), 4 * node + k, record.delay[k]});
      }
    }
    return record;
  }

  /// Appends the rests around a vertex with how many faces of theirs touch it.
  void hubsAround(Index vertex, Index corner,
                  std::vector<std::pair<Index, FloodCorner>>& atHubs) const {
    const auto first = static_cast<std::ptrdiff_t>(atHubs.size());
    const Index begin = mesh_.vertexSide()[vertex];
    Index side = begin;
    do {
      const Index node = graph_.nodeOfFace[side / 3];
      if (node >= free_.size()) {
        const Index hub = node - static_cast<Index>(free_.size());
        const auto found = std::find_if(atHubs.begin() + first, atHubs.end(),
                                        [&](const auto& at) { return at.first == hub; });
        if (found == atHubs.end()) {
          atHubs.push_back({hub, {corner, 1}});
        } else {
          ++found->second.times;
        }
      }
      side = mesh_.turn(side);
    } while (side != begin);
  }

  /// Lists the nodes around each corner and renumbers the corners of the free faces.
  void listCorners(std::span<const Index> number,
                   std::span<const std::pair<Index, FloodCorner>> atHubs) {
    FloodGraph& flood = graph_.flood;
    std::vector<Index>& begin = graph_.cornerNodeBegin;
    graph_.cornerNode.resize(begin.back());
    std::vector<Index> next(begin.begin(), begin.end() - 1);
    for (Index node = 0; node < flood.faces.size(); ++node) {
      if (flood.faces[node].extra == 0) continue;
      for (Index& corner : flood.extras[flood.faces[node].extra].corner) {
        if (corner == kNone) continue;
        corner = number[corner];
        graph_.cornerNode[next[corner]++] = node;
      }
    }
    for (const auto& [hub, corner] : atHubs) {
      graph_.cornerNode[next[corner.corner]++] = static_cast<Index>(free_.size()) + hub;
    }
  }

  const NodeGraphSource& source_;
  const Mesh& mesh_;
  std::span<const Index> free_;
  std::size_t charts_;
  NodeGraph& graph_;
  std::vector<std::vector<Contact>> contacts_;  ///< of each block
};

}  // namespace

BandFaces numberBandFaces(const NodeGraph& clusters, std::span<const Index> rest) {
  const std::span<const Index> clusterOf = clusters.nodeOfFace;
  std::vector<Index> first(bandBlocks(clusterOf.size()) + 1, 0);
  parallelBlocks(clusterOf.size(), kBandBlock, [&](std::size_t begin, std::size_t end) {
    Index count = 0;
    for (std::size_t f = begin; f < end; ++f) count += rest[clusterOf[f]] == kNone ? 1 : 0;
    first[begin / kBandBlock + 1] = count;
  });
  for (std::size_t b = 1; b < first.size(); ++b) first[b] += first[b - 1];
  BandFaces faces;
  faces.free.resize(first.back());
  faces.nodeOfFace.resize(clusterOf.size());
  parallelBlocks(clusterOf.size(), kBandBlock, [&](std::size_t begin, std::size_t end) {
    Index next = first[begin / kBandBlock];
    for (std::size_t f = begin; f < end; ++f) {
      const Index chart = rest[clusterOf[f]];
      if (chart != kNone) {
        faces.nodeOfFace[f] = first.back() + chart;
      } else {
        faces.free[next] = static_cast<Index>(f);
        faces.nodeOfFace[f] = next++;
      }
    }
  });
  return faces;
}

NodeGraph triangleBand(const NodeGraphSource& source, const NodeGraph& clusters,
                       std::span<const Index> rest, std::size_t charts, BandFaces faces) {
  NodeGraph graph;
  graph.nodeOfFace = std::move(faces.nodeOfFace);
  graph.gauss.assign(faces.free.size() + charts, 0);
  graph.flood.speeds = source.flood.speeds;
  graph.flood.eta = source.flood.eta;
  graph.flood.faceCount = graph.gauss.size();
  BandBuilder builder(source, faces.free, graph, charts);
  builder.addFaces();
  builder.addRests(clusters, rest);
  builder.addContacts();
  builder.addSharpEdges();
  builder.addCorners();
  return graph;
}

}  // namespace chartflood
