#pragma once
/// A heap of faces by time in eight bytes an entry.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// A time with a face. Times are not negative, so their bit patterns are ordered like them: one
/// integer comparison orders by time, then by face number.
using TimedFace = std::uint64_t;

inline TimedFace timedFace(float time, Index face) {
  return static_cast<TimedFace>(std::bit_cast<std::uint32_t>(time)) << 32 | face;
}
inline float timeOf(TimedFace entry) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(entry >> 32));
}
inline Index faceOf(TimedFace entry) { return static_cast<Index>(entry); }

/// 8-ary min-heap: shallow, and the children of a node share a cache line or two.
class MinHeap {
 public:
  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  TimedFace top() const { return entries_.front(); }
  /// Entry i in heap order; 1 to 8 hold the next candidates.
  TimedFace entry(std::size_t i) const { return entries_[i]; }
  void clear() { entries_.clear(); }

  void push(TimedFace entry) {
    std::size_t i = entries_.size();
    entries_.push_back(entry);
    while (i > 0) {
      const std::size_t parent = (i - 1) / kArity;
      if (entries_[parent] <= entry) break;
      entries_[i] = entries_[parent];
      i = parent;
    }
    entries_[i] = entry;
  }

  void pop() {
    const TimedFace last = entries_.back();
    entries_.pop_back();
    if (!entries_.empty()) siftDown(last);
  }

  /// Same as pop() and push(entry), in one pass.
  void replaceTop(TimedFace entry) { siftDown(entry); }

 private:
  static constexpr std::size_t kArity = 8;

  /// Smallest of a full node's children. A tree of comparisons: the processor overlaps them.
  std::size_t smallestOfEight(std::size_t first) const {
    const TimedFace* e = entries_.data() + first;
    const std::size_t a = e[1] < e[0] ? 1 : 0, b = e[3] < e[2] ? 3 : 2;
    const std::size_t c = e[5] < e[4] ? 5 : 4, d = e[7] < e[6] ? 7 : 6;
    const std::size_t ab = e[b] < e[a] ? b : a, cd = e[d] < e[c] ? d : c;
    return first + (e[cd] < e[ab] ? cd : ab);
  }

  /// Puts `entry` in place of the top.
  void siftDown(TimedFace entry) {
    const std::size_t size = entries_.size();
    std::size_t i = 0;
    while (true) {
      const std::size_t first = kArity * i + 1;
      if (first >= size) break;
      std::size_t smallest = first;
      if (first + kArity <= size) {
        smallest = smallestOfEight(first);
      } else {
        for (std::size_t c = first + 1; c < size; ++c) {
          if (entries_[c] < entries_[smallest]) smallest = c;
        }
      }
      if (entries_[smallest] >= entry) break;
      entries_[i] = entries_[smallest];
      i = smallest;
    }
    entries_[i] = entry;
  }

  std::vector<TimedFace> entries_;
};

}  // namespace chartflood
