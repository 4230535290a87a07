#pragma once
/// Minimum cuts of small undirected graphs by blocking flows (Dinic 1970), on flat arrays.

#include <cstddef>
#include <cstdint>
#include <span>
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
  void beginNode() { begin_.push_back(static_cast<Index>(head_.size())); }
  void endNodes() { beginNode(); }
  void setReverse(Index arc, Index reverse) { reverse_[arc] = reverse; }

  /// Adds to what ties a node to the source (above 0) or the sink (below 0). A flow found before
  /// stays valid: the same sum on both ties of a node changes no minimum cut.
  void addTerminal(Index node, Amount amount) { terminal_[node] += amount; }

  /// Sends as much flow as possible, on top of what flows already.
  void solve();
  /// After solve(): true for the nodes that can still be reached from the source, the smallest
  /// source side of all minimum cuts.
  bool onSourceSide(Index node) const { return level_[node] != kNone; }

 private:
  bool findLevels();
  void sendFrom(Index source);

  std::vector<Index> begin_, head_, reverse_;
  std::vector<Amount> rest_;      ///< capacity left of each arc
  std::vector<Amount> terminal_;  ///< of each node, what is left
  std::vector<Index> level_, next_, queue_, path_;
};

}  // namespace chartflood
