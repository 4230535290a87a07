#pragma once
/// A heap of faces by time in eight bytes an entry.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// 8-ary min-heap: shallow, and the children of a node are one cache line. Lines are filled up with
/// a value above all entries, so that no step asks how many children there are.
class MinHeap {
 public:
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  /// The first entry; of an empty heap, a value above all entries.
  TimedFace top() const { return lines_[0][kRoot]; }
  /// Of the entries right below the top, one of which is the next, the one that rose there last;
  /// the top while none did. Followed from step to step it names each of them once, in time to
  /// fetch what it stands for.
  TimedFace risen() const {
    const TimedFace entry = lines_[risen_ / kArity][risen_ % kArity];
    return entry != kNoEntry ? entry : top();
  }
  void clear() {
    lines_.assign(1, kNoEntries);
    size_ = 0;
    risen_ = kRoot;
  }

  void push(TimedFace entry) {
    std::size_t i = kRoot + size_++;
    if (i / kArity == lines_.size()) lines_.push_back(kNoEntries);
    while (i > kRoot) {
      const std::size_t parent = i / kArity + kRoot - 1;
      if (at(parent) <= entry) break;
      at(i) = at(parent);
      i = parent;
    }
    at(i) = entry;
  }

  void pop() {
    const std::size_t last = kRoot + --size_;
    const TimedFace entry = at(last);
    at(last) = kNoEntry;
    if (size_ > 0) replaceTop(entry);
  }

  /// Same as pop() and push(entry), in one pass.
  void replaceTop(TimedFace entry) {
    Line* const lines = lines_.data();
    const std::size_t count = lines_.size();
    TimedFace* hole = &lines[0][kRoot];
    for (std::size_t line = 1; line < count;) {
      const Smallest smallest = smallestOf(lines[line]);
      if (line == 1) risen_ = kArity + smallest.place;
      if (smallest.entry >= entry) break;
      *hole = smallest.entry;
      hole = &lines[line][smallest.place];
      line = kArity * line + smallest.place - (kRoot - 1);
    }
    *hole = entry;
  }

 private:
  static constexpr std::size_t kArity = 8;
  static constexpr std::size_t kRoot = kArity - 1;  ///< place of the root: children begin lines
  static constexpr TimedFace kNoEntry = std::numeric_limits<TimedFace>::max();
  struct alignas(64) Line : std::array<TimedFace, kArity> {};
  static constexpr Line kNoEntries{
      {kNoEntry, kNoEntry, kNoEntry, kNoEntry, kNoEntry, kNoEntry, kNoEntry, kNoEntry}};

  struct Smallest {
    TimedFace entry;
    std::size_t place;
  };
  static Smallest smaller(const Smallest& a, const Smallest& b) {
    const bool second = b.entry < a.entry;
    return {second ? b.entry : a.entry, second ? b.place : a.place};
  }
  /// A tree of comparisons: the processor overlaps them.
  static Smallest smallestOf(const Line& e) {
    const auto pair = [&](std::size_t i) { return smaller({e[i], i}, {e[i + 1], i + 1}); };
    return smaller(smaller(pair(0), pair(2)), smaller(pair(4), pair(6)));
  }

  TimedFace& at(std::size_t i) { return lines_[i / kArity][i % kArity]; }

  std::vector<Line> lines_ = {kNoEntries};
  std::size_t size_ = 0;
  std::size_t risen_ = kRoot;  ///< place of what risen() names
};

}  // namespace chartflood
