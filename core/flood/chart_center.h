#pragma once
/// The face of each chart farthest from the chart's border (paper section 3.4).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/base/parallel.h"

namespace chartflood {

/// Finds the farthest faces over a finished Store. Distances are the least fixed point of
/// dist(g) = min(dist(f) + delay(f, g)), which any order of relaxation reaches: they equal
/// Dijkstra's and do not depend on bucket width or threads.
template <class Store>
class ChartCenter {
 public:
  explicit ChartCenter(const Store& store) : store_(store) {}

  std::vector<Index> find(std::span<const Index> seeds, double meanDelay) {
    const std::size_t faces = store_.faceCount(), charts = seeds.size();
    distance_.resize(faces);
    border_.resize(charts);
    for (auto& list : border_) list.clear();
    for (Index f = 0; f < faces; ++f) {
      const bool border = store_.onBorder(f);
      distance_[f] = border ? 0.0f : kFar;
      if (border && store_.label(f) != kNone) border_[store_.label(f)].push_back(f);
    }
    perTurn_ = meanDelay > 0 ? static_cast<float>(0.5 / meanDelay) : 1.0f;
    std::vector<std::uint64_t> relaxed(charts, 0);
    parallelFor(charts, [&](std::size_t chart) { relaxed[chart] = relaxChart(border_[chart]); });
    relaxations_ = std::accumulate(relaxed.begin(), relaxed.end(), std::uint64_t{0});
    return pick(seeds);
  }

  /// Distance of each face to its chart's border after find(); for tests.
  std::span<const float> distances() const { return distance_; }
  /// How many distances find() lowered.
  std::uint64_t relaxations() const { return relaxations_; }

 private:
  static constexpr float kFar = std::numeric_limits<float>::infinity();
  static constexpr std::size_t kBuckets = 64;
  static constexpr std::size_t kAhead = 8;  ///< faces between prefetching and use

  /// Label correcting over a ring of buckets: faces whose distance falls are put in again. Returns
  /// how often one fell.
  std::uint64_t relaxChart(const std::vector<Index>& sources) {
    std::uint64_t relaxed = 0;
    thread_local std::vector<std::vector<Index>> ring(kBuckets);
    std::size_t waiting = sources.size();
    ring[0].assign(sources.begin(), sources.end());
    std::size_t now = 0;
    thread_local std::vector<Index> batch;
    while (waiting > 0) {
      std::vector<Index>& bucket = ring[now % kBuckets];
      if (bucket.empty()) {
        ++now;
        continue;
      }
      batch.swap(bucket);
      waiting -= batch.size();
      for (std::size_t i = 0; i < batch.size(); ++i) {
        if (i + kAhead < batch.size()) {
          store_.prefetchFace(batch[i + kAhead]);
          __builtin_prefetch(&distance_[batch[i + kAhead]]);
        }
        const Index face = batch[i];
        const float here = distance_[face];
        const std::size_t due = turnOf(here);
        if (due < now) continue;  // done in an earlier turn, after its distance had fallen
        if (due > now) {
          ring[std::min(due, now + kBuckets - 1) % kBuckets].push_back(face);
          ++waiting;
          continue;
        }
        store_.forEachInside(face, [&](Index neighbour, float delay) {
          const float there = here + delay;
          if (!(there < distance_[neighbour])) return;
          distance_[neighbour] = there;
          ring[std::min(turnOf(there), now + kBuckets - 1) % kBuckets].push_back(neighbour);
          ++waiting;
          ++relaxed;
        });
      }
      batch.clear();
    }
    return relaxed;
  }

  /// Turn of the ring in which a distance is due; never falls when the distance grows.
  std::size_t turnOf(float distance) const {
    return static_cast<std::size_t>(std::min(distance * perTurn_, 1e15f));
  }

  std::vector<Index> pick(std::span<const Index> seeds) const {
    struct Best {
      float distance = -1;
      Index face = kNone;
    };
    std::vector<Best> best(seeds.size());
    for (Index f = 0; f < distance_.size(); ++f) {
      const Index chart = store_.label(f);
      if (chart == kNone) continue;
      // Only a chart without any border holds unreached faces.
      if (distance_[f] > best[chart].distance && distance_[f] < kFar) {
        best[chart] = {distance_[f], f};
      }
    }
    std::vector<Index> centers(seeds.begin(), seeds.end());
    for (std::size_t c = 0; c < seeds.size(); ++c) {
      if (best[c].face == kNone || distance_[seeds[c]] >= best[c].distance) continue;
      centers[c] = best[c].face;
    }
    return centers;
  }

  const Store& store_;
  std::vector<float> distance_;
  std::vector<std::vector<Index>> border_;
  std::uint64_t relaxations_ = 0;
  float perTurn_ = 1;  ///< turns per unit of distance
};

}  // namespace chartflood
