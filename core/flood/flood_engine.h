#pragma once
/// The flood itself, over either store. Included by flood.cpp only.

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/flood/chart_center.h"
#include "core/flood/flood.h"
#include "core/flood/min_heap.h"
#include "core/flood/primary_queue.h"

namespace chartflood {

template <class Store>
class FloodEngine final : public Flood {
 public:
  FloodEngine(const FloodGraph& graph, double meanDelay)
      : store_(graph), center_(store_), meanDelay_(meanDelay) {}

  void start(std::span<const Index> seeds, std::span<const double> offsets, bool lookahead,
             std::shared_ptr<FloodRecord> record) override {
    CF_CHECK(seeds.size() == offsets.size() && !seeds.empty());
    store_.reset();
    charts_.resize(seeds.size());
    queue_.reset(seeds.size());
    for (std::size_t c = 0; c < seeds.size(); ++c) {
      charts_[c].heap.clear();
      charts_[c].balance = offsets[c];
      charts_[c].nextGain = 0;
    }
    seeds_.assign(seeds.begin(), seeds.end());
    lookahead_ = lookahead;
    record_ = std::move(record);
    counts_ = {};
    nextSeed_ = 0;
    done_ = false;
  }

  std::size_t advance(std::size_t count, Progress* progress) override {
    std::size_t took = 0;
    while (took < count && !done_) {
      const std::size_t burst = std::min(count - took, kBurst);
      took += takeSome(burst);
      if (record_) record_->publish();
      if (progress != nullptr) {
        progress->setFraction(static_cast<float>(counts_.takes) /
                              static_cast<float>(store_.faceCount()));
        if (progress->cancelled()) break;
      }
    }
    return took;
  }

  bool finished() const override { return done_; }
  std::size_t taken() const override { return counts_.takes; }
  const FloodCounts& counts() const override { return counts_; }

  void copyLabels(std::vector<Index>& labels) const override {
    labels.resize(store_.faceCount());
    for (Index f = 0; f < labels.size(); ++f) labels[f] = store_.label(f);
  }

  std::vector<Index> farthestFromBorder(std::span<const Index> seeds) override {
    std::vector<Index> centers = center_.find(seeds, meanDelay_);
    counts_.relaxations = center_.relaxations();
    return centers;
  }

 private:
  /// Takes between two looks at the clock, the readers and the cancel flag.
  static constexpr std::size_t kBurst = 2048;

  struct alignas(64) Chart {
    MinHeap heap;         ///< faces at its border by local time (the secondary heap)
    double balance = 0;   ///< gains so far plus offset
    double nextGain = 0;  ///< gain of the heap's top, for the key and for its taking
  };

  /// Takes up to `count` faces; returns how many.
  std::size_t takeSome(std::size_t count) {
    std::size_t took = 0;
    for (; took < count && nextSeed_ < seeds_.size(); ++took) takeSeed();
    for (; took < count && !done_; ++took) grow();
    return took;
  }

  void takeSeed() {
    const Index chart = nextSeed_++;
    CF_CHECK(store_.isFree(seeds_[chart]));
    charts_[chart].balance += store_.gain(seeds_[chart], chart);
    take(seeds_[chart], chart, 0.0f, false);
    if (nextSeed_ < seeds_.size()) return;
    for (Index c = 0; c < charts_.size(); ++c) rank(c);
    done_ = !findNext();
  }

  /// Takes the next face.
  void grow() {
    const Index chart = next_;
    Chart& growing = charts_[chart];
    const TimedFace top = growing.heap.top();
    ++counts_.pops;
    growing.balance += growing.nextGain;
    const PrimaryQueue::Ranked other = queue_.firstBut(chart);
    take(faceOf(top), chart, timeOf(top), true);
    const PrimaryQueue::Ranked own = rank(chart);
    // Nearly always another chart goes on, which is known already: as a branch that is foreseen,
    // this lets its taking begin while the heap of this one is still being put in order.
    if (!own.before(other)) [[likely]] {
      next_ = other.chart;
      if (other.canGrow() && topIsFree(next_)) [[likely]]
        return;
    }
    done_ = !findNext();
  }

  bool topIsFree(Index chart) const { return store_.isFree(faceOf(charts_[chart].heap.top())); }

  /// Labels the face and offers its neighbours. With `fromHeap` the face is the heap's top, whose
  /// place the first offer takes.
  void take(Index face, Index chart, float time, bool fromHeap) {
    ++counts_.takes;
    if (record_) record_->append(face, chart, time);
    MinHeap& heap = charts_[chart].heap;
    store_.take(face, chart, time, [&](Index neighbour, float arrival) {
      const TimedFace offer = timedFace(arrival, neighbour);
      if (fromHeap) {
        heap.replaceTop(offer);
        fromHeap = false;
      } else {
        heap.push(offer);
      }
      // What was just written to is at hand already.
      store_.prefetchWays(neighbour);
      ++counts_.pushes;
    });
    if (fromHeap) heap.pop();
  }

  /// Drops faces that others took from the top of the chart's heap and sets its key, which it
  /// returns.
  PrimaryQueue::Ranked rank(Index chart) {
    Chart& c = charts_[chart];
    while (!c.heap.empty() && !topIsFree(chart)) {
      c.heap.pop();
      ++counts_.pops;
    }
    if (c.heap.empty()) return queue_.setKey(chart, PrimaryQueue::kFinished);
    const Index face = faceOf(c.heap.top());
    c.nextGain = store_.gain(face, chart);
    const PrimaryQueue::Ranked ranked =
        queue_.setKey(chart, lookahead_ ? c.balance + c.nextGain : c.balance);
    // It will be this chart's turn again after about one take of every other chart: time enough
    // for the memory to bring what that take touches.
    store_.prefetchNeighbours(face);
    store_.prefetchFace(faceOf(c.heap.risen()));
    return ranked;
  }

  /// Finds the chart that grows next. Its next face is free: a chart whose next face was taken by
  /// another meanwhile is ranked anew first.
  bool findNext() {
    while (true) {
      next_ = queue_.top();
      if (queue_.finished()) return false;
      if (topIsFree(next_)) return true;
      rank(next_);
    }
  }

  Store store_;
  ChartCenter<Store> center_;
  double meanDelay_;
  std::vector<Chart> charts_;
  PrimaryQueue queue_;
  std::vector<Index> seeds_;
  std::shared_ptr<FloodRecord> record_;
  FloodCounts counts_;
  Index nextSeed_ = 0, next_ = 0;
  bool lookahead_ = true, done_ = true;
};

}  // namespace chartflood
