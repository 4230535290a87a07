#pragma once
/// The append-only log of a flood: which face was taken by which chart, and when.

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// One incorporation of a face into a chart.
struct Incorporation {
  Index face = kNone;
  Index chart = kNone;
  float time = 0;  ///< local time of the chart (paper equation 9), only comparable within a chart
};

/// One writer appends, any number of readers read what was published. Nothing that a reader has
/// seen ever changes; the storage is allocated once.
class FloodRecord {
 public:
  /// Room for `capacity` incorporations: the number of faces.
  explicit FloodRecord(std::size_t capacity)
      : log_(new Incorporation[capacity]), capacity_(capacity) {}

  /// Writer only. Visible to readers after the next publish().
  void append(Index face, Index chart, float time) { log_[written_++] = {face, chart, time}; }
  /// Writer only: makes everything appended so far visible.
  void publish() { published_.store(written_, std::memory_order_release); }
  /// Writer only, while nobody reads: forgets everything.
  void rewind() {
    written_ = 0;
    publish();
  }

  /// Number of incorporations that may be read.
  std::size_t size() const { return published_.load(std::memory_order_acquire); }
  std::size_t capacity() const { return capacity_; }
  /// Entry i < size().
  const Incorporation& operator[](std::size_t i) const { return log_[i]; }

 private:
  std::unique_ptr<Incorporation[]> log_;
  std::size_t capacity_ = 0;
  std::size_t written_ = 0;
  std::atomic<std::size_t> published_{0};
};

}  // namespace chartflood
