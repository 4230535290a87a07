#pragma once
/// Minimum cuts of small undirected graphs by two search trees that are kept from one augmenting
/// path to the next (Boykov and Kolmogorov 2004), on flat arrays.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// A graph whose nodes are tied to the source (positive terminal) or to the sink (negative), with
/// capacities in whole numbers. Storage is kept from one graph to the next.
class MaxFlow {
 public:
  using Amount = std::int64_t;

  /// Begins a graph: arcs of node i are [begin[i], begin[i + 1]) once they are added.
  void reset(std::size_t nodes);
  /// Adds an arc from the newest node begun with beginNode(); its reverse is told by setReverse().
  Index addArc(Index head, Amount capacity);
  void beginNode() { nodes_[begun_++].begin = static_cast<Index>(arcs_.size()); }
  void endNodes() { beginNode(); }
  void setReverse(Index arc, Index reverse) { arcs_[arc].reverse = reverse; }

  /// Adds to what ties a node to the source (above 0) or the sink (below 0). A flow found before
  /// stays valid: the same sum on both ties of a node changes no minimum cut.
  void addTerminal(Index node, Amount amount) { nodes_[node].terminal += amount; }

  /// Sends as much flow as possible, on top of what flows already.
  void solve();
  /// After solve(): true for the nodes that can still be reached from the source, the smallest
  /// source side of all minimum cuts. It is the same for every greatest flow.
  bool onSourceSide(Index node) const { return nodes_[node].tree == kSource; }

 private:
  enum Tree : std::uint8_t { kFree, kSource, kSink };
  struct Arc {
    Amount rest;  ///< capacity left
    Index head, reverse;
  };
  struct Node {
    Amount terminal = 0;               ///< what is left
    Index begin = 0;                   ///< of its arcs
    Index parent = 0;                  ///< arc to the node's parent; kRoot, kOrphan
    unsigned distance = 0, stamp = 0;  ///< to the root, and when that was so
    Tree tree = kFree;
    bool active = false;
  };

  void plantTrees();
  Index grow(Index node);
  void augment(Index bridge);
  void adopt();
  void findParent(Index node);
  unsigned distanceToRoot(Index node);
  void activate(Index node);
  Index nextActive();
  /// What can still flow from the source tree's node outwards, or inwards to the sink tree's.
  Amount restAlong(const Arc& arc, Tree tree) const {
    return tree == kSource ? arc.rest : arcs_[arc.reverse].rest;
  }

  std::vector<Arc> arcs_;
  std::vector<Node> nodes_;  ///< and one behind the last
  std::size_t begun_ = 0;
  unsigned time_ = 0;
  std::vector<Index> active_, orphans_;
  std::size_t nextActive_ = 0;
};

}  // namespace chartflood
