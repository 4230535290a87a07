#pragma once
/// The face of each chart farthest from the chart's border (paper section 3.4).

#include <algorithm>
#include <array>
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
/// Dijkstra's and do not depend on bucket width or threads. Ways from chart to chart need no
/// asking: the faces there are on the border themselves, and nothing is nearer than that.
template <class Store>
class ChartCenter {
 public:
  explicit ChartCenter(const Store& store) : store_(store) {}

  std::vector<Index> find(std::span<const Index> seeds, double meanDelay) {
    const std::size_t charts = seeds.size();
    findBorders(charts);
    perTurn_ = meanDelay > 0 ? static_cast<float>(0.5 / meanDelay) : 1.0f;
    std::vector<std::uint64_t> relaxed(charts, 0);
    std::vector<Index> centers(seeds.begin(), seeds.end());
    parallelFor(charts, [&](std::size_t chart) {
      const Farthest farthest = relaxChart(border_[chart], relaxed[chart]);
      if (farthest.face != kNone && distance_[seeds[chart]] < farthest.distance) {
        centers[chart] = farthest.face;
      }
    });
    relaxations_ = std::accumulate(relaxed.begin(), relaxed.end(), std::uint64_t{0});
    return centers;
  }

  /// Distance of each face to its chart's border after find(); for tests.
  std::span<const float> distances() const { return distance_; }
  /// How many distances find() lowered.
  std::uint64_t relaxations() const { return relaxations_; }

 private:
  static constexpr float kFar = std::numeric_limits<float>::infinity();
  static constexpr std::size_t kBuckets = 64;
  static constexpr std::size_t kAhead = 8;  ///< faces between prefetching and use

  static constexpr std::size_t kBlock = 1 << 14;  ///< faces

  struct Farthest {
    float distance = -1;
    Index face = kNone;
  };

  struct Turns {
    std::array<std::vector<Index>, kBuckets> ring;
    std::vector<Index> batch;  ///< of a bucket, at work
    std::vector<Index> done;   ///< in the turn at hand, or the last one that had any
  };

  /// The faces at distance 0, by chart.
  void findBorders(std::size_t charts) {
    const std::size_t faces = store_.faceCount();
    distance_.resize(faces);
    found_.resize((faces + kBlock - 1) / kBlock);
    parallelBlocks(faces, kBlock, [&](std::size_t begin, std::size_t end) {
      std::vector<Index>& found = found_[begin / kBlock];
      found.clear();
      for (Index f = static_cast<Index>(begin); f < end; ++f) {
        const bool border = store_.onBorder(f);
        distance_[f] = border ? 0.0f : kFar;
        if (border) found.push_back(f);
      }
    });
    border_.resize(charts);
    for (auto& list : border_) list.clear();
    for (const auto& found : found_) {
      for (const Index f : found) {
        if (store_.label(f) != kNone) border_[store_.label(f)].push_back(f);
      }
    }
  }

  /// Label correcting over a ring of buckets: faces whose distance falls are put in again. Tells
  /// how often one fell. Returns the lowest of the farthest faces: they are due in the last turn.
  Farthest relaxChart(const std::vector<Index>& sources, std::uint64_t& relaxed) {
    thread_local Turns turns;
    auto& ring = turns.ring;
    std::vector<Index>&batch = turns.batch, &done = turns.done;
    std::size_t turnOfDone = 0;
    done.clear();
    std::size_t waiting = sources.size();
    ring[0].assign(sources.begin(), sources.end());
    std::size_t now = 0, fallen = 0;
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
          store_.prefetchWays(batch[i + kAhead]);
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
        if (turnOfDone < now) done.clear();
        turnOfDone = now;
        done.push_back(face);
        store_.forEachWay(face, [&](Index neighbour, float delay) {
          const float there = here + delay;
          if (!(there < distance_[neighbour])) return;
          distance_[neighbour] = there;
          ring[std::min(turnOf(there), now + kBuckets - 1) % kBuckets].push_back(neighbour);
          ++waiting;
          ++fallen;
        });
      }
      batch.clear();
    }
    relaxed = fallen;
    Farthest farthest;
    for (const Index face : done) {
      const float distance = distance_[face];
      const bool farther = distance > farthest.distance;
      if (farther || (distance == farthest.distance && face < farthest.face)) {
        farthest = {distance, face};
      }
    }
    return farthest;
  }

  /// Turn of the ring in which a distance is due; never falls when the distance grows.
  std::size_t turnOf(float distance) const {
    return static_cast<std::size_t>(std::min(distance * perTurn_, 1e15f));
  }

  const Store& store_;
  std::vector<float> distance_;
  std::vector<std::vector<Index>> found_;   ///< faces at distance 0 of each block
  std::vector<std::vector<Index>> border_;  ///< and of each chart
  std::uint64_t relaxations_ = 0;
  float perTurn_ = 1;  ///< turns per unit of distance
};

}  // namespace chartflood
