#include "core/segment/growth/mcgim_price.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/flood/min_heap.h"

namespace chartflood {

namespace {

/// What the mean path cost over the square root of the area counts against seam length over that.
constexpr double kPathWeight = 3000;
/// Of a face in a chart that is not beside its own: more than all seams.
constexpr double kForbidden = 1e5;
constexpr float kNoPath = std::numeric_limits<float>::infinity();

class McgimPrice final : public ChartPrice {
 public:
  McgimPrice(const GrowthGraph& graph, const GrowthStart& start, float lambda)
      : graph_(graph), seeds_(start.seeds), normals_(start.normals.begin(), start.normals.end()),
        lambda_(lambda), reached_(graph.faces.size(), kNoPath) {
    double area = 0;
    for (const GrowthFace& face : graph.faces) area += static_cast<double>(face.area);
    factor_ = kPathWeight / std::sqrt(std::max(area, 1e-300)) /
              static_cast<double>(std::max<std::size_t>(1, graph.faces.size()));
  }

  void fit(std::span<const Index> label) override {
    home_.assign(label.begin(), label.end());
    listNeighbours();
    fitNormals();
    findCosts();
  }

  double of(Index face, Index chart) const override {
    const Index slot = slotOf(home_[face], chart);
    const float cost = slot == kNone ? kNoPath : cost_[begin_[face] + slot];
    return cost == kNoPath ? kForbidden : factor_ * static_cast<double>(cost);
  }

 private:
  /// Of each chart itself and those beside it, ascending.
  void listNeighbours() {
    beside_.assign(seeds_.size(), {});
    for (Index c = 0; c < beside_.size(); ++c) beside_[c].push_back(c);
    for (Index f = 0; f < home_.size(); ++f) {
      for (Index a = graph_.begin(f); a < graph_.begin(f + 1); ++a) {
        const Index next = graph_.arcs[a].face;
        if (next == kNone || home_[next] == home_[f]) continue;
        std::vector<Index>& list = beside_[home_[f]];
        if (list.back() != home_[next]) list.push_back(home_[next]);
      }
    }
    for (std::vector<Index>& list : beside_) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    begin_.resize(home_.size());
    std::size_t sum = 0;
    for (Index f = 0; f < home_.size(); ++f) {
      begin_[f] = sum;
      sum += beside_[home_[f]].size();
    }
    cost_.assign(sum, kNoPath);
  }

  Index slotOf(Index home, Index chart) const {
    const std::vector<Index>& list = beside_[home];
    const auto found = std::lower_bound(list.begin(), list.end(), chart);
    return found != list.end() && *found == chart ? static_cast<Index>(found - list.begin())
                                                  : kNone;
  }

  /// The mean normal of each chart, where paths inside it are no longer with it in sum.
  void fitNormals() {
    std::vector<glm::dvec3> sums(seeds_.size(), glm::dvec3(0));
    for (Index f = 0; f < home_.size(); ++f) {
      const GrowthFace& face = graph_.faces[f];
      sums[home_[f]] += static_cast<double>(face.area) * glm::dvec3(face.normal);
    }
    for (Index c = 0; c < seeds_.size(); ++c) {
      const double length = glm::length(sums[c]);
      if (!(length > 0)) continue;
      const glm::vec3 mean(sums[c] / length);
      const auto inside = [&](Index face) { return home_[face] == c; };
      if (costWith(c, mean, inside) < costWith(c, normals_[c], inside)) normals_[c] = mean;
    }
  }

  template <class Inside>
  double costWith(Index chart, const glm::vec3& normal, const Inside& inside) {
    double sum = 0;
    grow(chart, normal, inside, [&](Index, float cost) { sum += static_cast<double>(cost); });
    return sum;
  }

  void findCosts() {
    for (Index c = 0; c < seeds_.size(); ++c) {
      const auto inside = [&](Index face) { return slotOf(home_[face], c) != kNone; };
      grow(c, normals_[c], inside,
           [&](Index face, float cost) { cost_[begin_[face] + slotOf(home_[face], c)] = cost; });
    }
  }

  /// Shortest paths from a chart's seed; tells each face that is reached with its cost.
  template <class Inside, class Tell>
  void grow(Index chart, const glm::vec3& normal, const Inside& inside, const Tell& tell) {
    heap_.clear();
    touched_.assign(1, seeds_[chart]);
    reached_[seeds_[chart]] = 0;
    heap_.push(timedFace(0, seeds_[chart]));
    while (!heap_.empty()) {
      const TimedFace top = heap_.top();
      heap_.pop();
      const Index face = faceOf(top);
      if (timeOf(top) != reached_[face]) continue;
      tell(face, timeOf(top));
      for (Index a = graph_.begin(face); a < graph_.begin(face + 1); ++a) {
        const GrowthArc& arc = graph_.arcs[a];
        if (arc.face == kNone || !inside(arc.face)) continue;
        const glm::vec3& there = graph_.faces[arc.face].normal;
        const float cost = timeOf(top) + mcgimStep(lambda_, normal, there, arc.length);
        if (!(cost < reached_[arc.face])) continue;
        if (reached_[arc.face] == kNoPath) touched_.push_back(arc.face);
        reached_[arc.face] = cost;
        heap_.push(timedFace(cost, arc.face));
      }
    }
    for (const Index face : touched_) reached_[face] = kNoPath;
  }

  const GrowthGraph& graph_;
  std::vector<Index> seeds_;
  std::vector<glm::vec3> normals_;
  float lambda_;
  double factor_ = 0;
  std::vector<Index> home_;                 ///< chart of each face at the last fit
  std::vector<std::vector<Index>> beside_;  ///< charts that know costs of a chart's faces
  std::vector<std::size_t> begin_;          ///< of each face in `cost_`
  std::vector<float> cost_;                 ///< in each of the charts beside its own
  MinHeap heap_;
  std::vector<float> reached_;
  std::vector<Index> touched_;
};

}  // namespace

std::unique_ptr<ChartPrice> makeMcgimPrice(const GrowthGraph& graph, const GrowthStart& start,
                                           float lambda) {
  return std::make_unique<McgimPrice>(graph, start, lambda);
}

}  // namespace chartflood
