#pragma once
/// A flood over the dual graph from one queue: charts grow from their seeds, the face with the
/// least key next, whatever chart it goes to.

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/progress.h"
#include "core/flood/min_heap.h"
#include "core/model/flood_record.h"
#include "core/segment/growth/disk_guard.h"
#include "core/segment/growth/growth_graph.h"

namespace chartflood {

/// Where a flood starts from: a seed face and a unit normal for each chart.
struct GrowthStart {
  std::vector<Index> seeds;
  std::vector<glm::dvec3> normals;

  bool operator==(const GrowthStart&) const = default;
};

/// The key of a face is `cost(here, normal, face, length)`: `here` is the key of the face that
/// offers it, `normal` the chart's, `length` the distance between the two faces. Keys are not
/// negative.
///
/// Every face remembers the least key offered to it: a larger one could never win, so it is not
/// queued, and the queue holds about one entry a face. On equal keys the earlier offer stays.
template <class Cost>
class GrowthFlood {
 public:
  struct Options {
    /// Charts' normals follow the faces that come in, from the seed's own on, instead of resting.
    bool runningNormals = false;
    /// Charts refuse faces that would make them more than disks, while anything else is left.
    const DiskGuard* guard = nullptr;
  };

  GrowthFlood(GrowthGraph graph, Cost cost, const Options& options)
      : graph_(std::move(graph)), cost_(cost), options_(options) {}

  void start(const GrowthStart& start, std::shared_ptr<FloodRecord> record) {
    seeds_ = start.seeds;
    normals_.clear();
    sums_.clear();
    for (std::size_t c = 0; c < seeds_.size(); ++c) {
      const GrowthFace& seed = graph_.faces[seeds_[c]];
      normals_.push_back(options_.runningNormals ? seed.normal : glm::vec3(start.normals[c]));
      sums_.emplace_back(0);
    }
    for (GrowthFace& face : graph_.faces) {
      face.best = std::numeric_limits<float>::infinity();
      face.label = kNone;
    }
    heap_.clear();
    record_ = std::move(record);
    takes_ = 0;
    nextSeed_ = 0;
    strict_ = options_.guard != nullptr;
  }

  /// Takes up to `count` more faces; returns how many it took. Stops early when cancelled.
  std::size_t advance(std::size_t count, Progress* progress) {
    const std::size_t before = takes_, faces = graph_.faces.size();
    const std::size_t end = before + std::min(count, faces - before);
    while (takes_ < end) {
      const std::size_t burst = std::min(end, takes_ + kBurst);
      while (takes_ < burst) step();
      if (record_) record_->publish();
      if (progress != nullptr) {
        progress->setFraction(static_cast<float>(takes_) / static_cast<float>(faces));
        if (progress->cancelled()) break;
      }
    }
    return takes_ - before;
  }

  /// A whole flood from `start` with the same rules, this one stays as it is. False when cancelled.
  bool aside(const GrowthStart& start, std::shared_ptr<FloodRecord> record,
             Progress* progress) const {
    GrowthFlood flood = *this;
    flood.start(start, std::move(record));
    flood.advance(graph_.faces.size(), progress);
    return flood.finished();
  }

  bool finished() const { return takes_ == graph_.faces.size(); }
  std::size_t taken() const { return takes_; }
  const GrowthGraph& graph() const { return graph_; }

 private:
  static constexpr std::size_t kBurst = 2048;

  /// Takes a seed that waits, or the face with the least key. Every component has a seed, so that
  /// there is one until all are taken.
  void step() {
    if (nextSeed_ < seeds_.size()) {
      GrowthFace& seed = graph_.faces[seeds_[nextSeed_]];
      seed.best = 0;
      seed.owner = static_cast<Index>(nextSeed_);
      return take(seeds_[nextSeed_++]);
    }
    while (true) {
      if (heap_.empty()) {
        relent();
        continue;
      }
      const TimedFace top = heap_.top();
      heap_.pop();
      const Index face = faceOf(top);
      const GrowthFace& f = graph_.faces[face];
      if (f.label != kNone || f.best != timeOf(top)) continue;
      if (!strict_ || options_.guard->staysDisk(face, f.owner, graph_.faces)) return take(face);
      refuse(face);
    }
  }

  void take(Index face) {
    GrowthFace& f = graph_.faces[face];
    const Index chart = f.owner;
    f.label = chart;
    ++takes_;
    if (record_) record_->append(face, chart, f.best);
    if (options_.runningNormals) {
      sums_[chart] += glm::dvec3(f.normal) * static_cast<double>(f.area);
      const double length = glm::length(sums_[chart]);
      if (length > 0) normals_[chart] = glm::vec3(sums_[chart] / length);
    }
    offerAround(face);
  }

  void offerAround(Index face) {
    const float here = graph_.faces[face].best;
    const Index chart = graph_.faces[face].label;
    const glm::vec3 normal = normals_[chart];
    for (Index a = graph_.begin(face); a < graph_.begin(face + 1); ++a) {
      const GrowthArc& arc = graph_.arcs[a];
      if (arc.face == kNone) continue;
      GrowthFace& g = graph_.faces[arc.face];
      if (g.label != kNone) continue;
      const float key = cost_(here, normal, g, arc.length);
      if (!(key < g.best)) continue;
      g.best = key;
      g.owner = chart;
      heap_.push(timedFace(key, arc.face));
    }
  }

  /// The face's owner would be no disk with it: goes to the next best chart beside it that would,
  /// or waits until another neighbour is taken.
  void refuse(Index face) {
    GrowthFace& f = graph_.faces[face];
    const Index refused = f.owner;
    f.best = std::numeric_limits<float>::infinity();
    for (Index a = graph_.begin(face); a < graph_.begin(face + 1); ++a) {
      const GrowthArc& arc = graph_.arcs[a];
      if (arc.face == kNone) continue;
      const GrowthFace& from = graph_.faces[arc.face];
      if (from.label == kNone || from.label == refused) continue;
      const float key = cost_(from.best, normals_[from.label], f, arc.length);
      if (!(key < f.best) || !options_.guard->staysDisk(face, from.label, graph_.faces)) continue;
      f.best = key;
      f.owner = from.label;
    }
    if (f.owner != refused) heap_.push(timedFace(f.best, face));
  }

  /// Only faces are left that no chart wants: from now on every face is taken by whoever is next.
  void relent() {
    strict_ = false;
    for (Index f = 0; f < graph_.faces.size(); ++f) {
      if (graph_.faces[f].label != kNone) offerAround(f);
    }
  }

  GrowthGraph graph_;
  Cost cost_;
  Options options_;
  MinHeap heap_;
  std::vector<Index> seeds_;
  std::vector<glm::vec3> normals_;
  std::vector<glm::dvec3> sums_;  ///< of area times normal of each chart, with running normals
  std::shared_ptr<FloodRecord> record_;
  std::size_t takes_ = 0, nextSeed_ = 0;
  bool strict_ = false;
};

}  // namespace chartflood
