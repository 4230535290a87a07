#pragma once
/// A flood over the dual graph: charts grow from their seeds, the face with the least key next,
/// whatever chart it goes to; or the chart with the least error next, so that all charts come to
/// the same.

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/base/progress.h"
#include "core/flood/min_heap.h"
#include "core/flood/primary_queue.h"
#include "core/model/flood_record.h"
#include "core/segment/growth/disk_guard.h"
#include "core/segment/growth/growth_graph.h"
#include "core/segment/parts/segmenter.h"

namespace chartflood {

/// Where a flood starts from: a seed face and a unit normal for each chart.
struct GrowthStart {
  std::vector<Index> seeds;
  std::vector<glm::dvec3> normals;
  /// What each chart's error begins with, in the error's unit; empty: one queue for all charts.
  std::vector<double> offsets = {};

  bool operator==(const GrowthStart&) const = default;
};

/// The key of a face is `cost(here, normal, face, length)`: `here` is the key of the face that
/// offers it, `normal` the chart's, `length` the distance between the two faces. Keys are not
/// negative.
///
/// Every face remembers the least key offered to it: a larger one could never win, so it is not
/// queued, and the queue holds about one entry a face. On equal keys the earlier offer stays.
///
/// Even growth (a start with offsets) is t-flooding with the method's error in place of Gauss area
/// (the future work of the paper's section 5): each chart has a queue of its own by key, and the
/// one whose error so far, offset and next face add up to least takes that face.
template <class Cost>
class GrowthFlood {
 public:
  struct Options {
    /// Charts' normals follow the faces that come in, from the seed's own on, instead of resting.
    bool runningNormals = false;
    /// Charts refuse faces that would make them more than disks, while anything else is left.
    /// Even growth does not ask it.
    const DiskGuard* guard = nullptr;
    EvenGrowth even = EvenGrowth::Off;  ///< what even growth adds up
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
    even_ = !start.offsets.empty();
    CF_CHECK(!even_ || start.offsets.size() == seeds_.size());
    charts_.resize(even_ ? seeds_.size() : 0);
    for (std::size_t c = 0; c < charts_.size(); ++c) {
      charts_[c].heap.clear();
      charts_[c].error = start.offsets[c];
    }
    if (even_) queue_.reset(seeds_.size());
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
      take(seeds_[nextSeed_++]);
      if (even_ && nextSeed_ == seeds_.size()) {
        for (Index c = 0; c < seeds_.size(); ++c) rank(c);
      }
      return;
    }
    if (even_) return stepEven();
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

  /// The chart with the least error takes its next face. Every component has a seed, so that one
  /// can grow until all faces are taken.
  void stepEven() {
    while (true) {
      CF_CHECK(!queue_.finished());
      const Index chart = queue_.top();
      const TimedFace top = charts_[chart].heap.top();
      GrowthFace& f = graph_.faces[faceOf(top)];
      if (f.label == kNone) {
        charts_[chart].heap.pop();
        f.best = timeOf(top);
        f.owner = chart;
        take(faceOf(top));
      }
      rank(chart);
      if (graph_.faces[faceOf(top)].label == chart) return;
    }
  }

  /// Drops faces that others took from the top of the chart's queue and says when its turn is.
  void rank(Index chart) {
    EvenChart& c = charts_[chart];
    while (!c.heap.empty() && graph_.faces[faceOf(c.heap.top())].label != kNone) c.heap.pop();
    if (c.heap.empty()) {
      queue_.setKey(chart, PrimaryQueue::kFinished);
      return;
    }
    const TimedFace top = c.heap.top();
    queue_.setKey(chart, c.error + errorOf(graph_.faces[faceOf(top)], timeOf(top)));
  }

  /// Of a face with that key. Flat ground costs a little as well, else one chart would take it all.
  double errorOf(const GrowthFace& face, float key) const {
    const auto area = static_cast<double>(face.area);
    return options_.even == EvenGrowth::Area ? area : static_cast<double>(key) + kFlat * area;
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
    if (even_) charts_[chart].error += errorOf(f, f.best);
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
      // In even growth a face waits for every chart beside it; `best` is the newest chart's key.
      const bool news = key < g.best || (even_ && g.owner != chart);
      if (!news) continue;
      g.best = key;
      g.owner = chart;
      (even_ ? charts_[chart].heap : heap_).push(timedFace(key, arc.face));
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

  static constexpr double kFlat = 1e-6;

  /// Of even growth.
  struct EvenChart {
    MinHeap heap;      ///< faces beside it by key
    double error = 0;  ///< so far, and its offset
  };

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
  bool even_ = false;
  std::vector<EvenChart> charts_;
  PrimaryQueue queue_;  ///< of charts, in even growth
};

}  // namespace chartflood
