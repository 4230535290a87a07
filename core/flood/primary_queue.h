#pragma once
/// The primary heap of charts: which chart grows next (paper section 3.3).

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// Charts by key, ties by chart number: a tournament tree whose nodes hold the winners' keys, so
/// that a new key is carried to the root by one comparison a level and no search. Who wins is
/// anyone's guess, so that the comparisons select by masks: a branch would be mispredicted.
class PrimaryQueue {
 public:
  static constexpr double kFinished = std::numeric_limits<double>::infinity();

  /// A chart with its key in a form that is ordered as keys are.
  struct Ranked {
    std::uint64_t key;
    Index chart;

    bool before(const Ranked& other) const {
      return key < other.key || (key == other.key && chart < other.chart);
    }
    bool canGrow() const { return key != bitsOf(kFinished); }
  };

  /// All of `count` charts finished.
  void reset(std::size_t count) {
    leaves_ = 1;
    while (leaves_ < count) leaves_ *= 2;
    key_.assign(2 * leaves_, bitsOf(kFinished));
    chart_.resize(2 * leaves_);
    for (std::size_t i = 0; i < leaves_; ++i) chart_[leaves_ + i] = static_cast<Index>(i);
    for (std::size_t i = leaves_ - 1; i > 0; --i) chart_[i] = chart_[2 * i];
  }

  Ranked setKey(Index chart, double key) {
    std::uint64_t* const keys = key_.data();
    Index* const charts = chart_.data();
    std::size_t i = leaves_ + chart;
    const Ranked ranked{bitsOf(key), chart};
    std::uint64_t winnerKey = ranked.key;
    Index winner = chart;
    keys[i] = winnerKey;
    while (i > 1) {
      const std::uint64_t otherKey = keys[i ^ 1];
      const Index other = charts[i ^ 1];
      // The other one has lower charts when this is a right child: it wins ties then.
      const bool lost = otherKey < winnerKey + (i & 1);
      winnerKey = lost ? otherKey : winnerKey;
      winner ^= (winner ^ other) & (0u - static_cast<Index>(lost));
      i /= 2;
      keys[i] = winnerKey;
      charts[i] = winner;
    }
    return ranked;
  }

  /// The first of all charts but one: known before that one's key is.
  Ranked firstBut(Index chart) const {
    const std::uint64_t* const keys = key_.data();
    const Index* const charts = chart_.data();
    std::size_t i = leaves_ + chart;
    std::uint64_t key = bitsOf(kFinished);
    Index first = kNone;
    for (; i > 1; i /= 2) {
      const std::uint64_t otherKey = keys[i ^ 1];
      const Index other = charts[i ^ 1];
      const bool sooner = otherKey < key + (i & 1);
      key = sooner ? otherKey : key;
      first ^= (first ^ other) & (0u - static_cast<Index>(sooner));
    }
    return {key, first};
  }

  /// The chart with the smallest key.
  Index top() const { return chart_[1]; }
  /// True when no chart can grow.
  bool finished() const { return !Ranked{key_[1], chart_[1]}.canGrow(); }

 private:
  /// Ordered as the keys are.
  static constexpr std::uint64_t bitsOf(double key) {
    const auto bits = std::bit_cast<std::uint64_t>(key + 0.0);  // no negative zero
    const std::uint64_t sign = std::uint64_t{1} << 63;
    return (bits & sign) != 0 ? ~bits : bits | sign;
  }

  std::size_t leaves_ = 1;
  // Of nodes: 1 is the root, leaves from `leaves_` on.
  std::vector<std::uint64_t> key_;
  std::vector<Index> chart_;
};

}  // namespace chartflood
