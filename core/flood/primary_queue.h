#pragma once
/// The primary heap of charts: which chart grows next (paper section 3.3).

#include <cstddef>
#include <limits>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// Charts by key, ties by chart number: a tournament tree whose nodes hold the winners' keys, so
/// that a new key is carried to the root by one comparison a level and no search.
class PrimaryQueue {
 public:
  static constexpr double kFinished = std::numeric_limits<double>::infinity();

  /// All of `count` charts finished.
  void reset(std::size_t count) {
    leaves_ = 1;
    while (leaves_ < count) leaves_ *= 2;
    nodes_.resize(2 * leaves_);
    for (std::size_t i = 0; i < leaves_; ++i) {
      nodes_[leaves_ + i] = {kFinished, static_cast<Index>(i)};
    }
    for (std::size_t i = leaves_ - 1; i > 0; --i) nodes_[i] = nodes_[2 * i];
  }

  void setKey(Index chart, double key) {
    Node winner{key, chart};
    std::size_t i = leaves_ + chart;
    nodes_[i] = winner;
    while (i > 1) {
      const Node other = nodes_[i ^ 1];
      const bool lost =
          other.key < winner.key || (other.key == winner.key && other.chart < winner.chart);
      winner = lost ? other : winner;
      i /= 2;
      nodes_[i] = winner;
    }
  }

  /// The chart with the smallest key.
  Index top() const { return nodes_[1].chart; }
  /// Its key; kFinished when no chart can grow.
  double topKey() const { return nodes_[1].key; }

 private:
  struct Node {
    double key;
    Index chart;
  };
  std::size_t leaves_ = 1;
  std::vector<Node> nodes_;  ///< node 1 is the root, leaves from `leaves_` on
};

}  // namespace chartflood
