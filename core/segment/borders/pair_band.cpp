#include "core/segment/borders/pair_band.h"

#include <algorithm>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr double kNoDistance = std::numeric_limits<double>::infinity();

}  // namespace

bool findBand(SeamState& state, Index a, Index b, BandHeap& heap, std::vector<Index>& band) {
  const SeamLevel& level = *state.level;
  heap.clear();
  for (const Index chart : {a, b}) {
    const Index other = chart == a ? b : a;
    for (const Index i : state.charts[chart].nodes) {
      state.distance[i] = kNoDistance;
      for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
        if (labelOf(state, level.arcHead[arc]) != other) continue;
        state.distance[i] = 0;
        heap.emplace_back(0.0, i);
        break;
      }
    }
  }
  if (heap.empty()) return false;
  const auto later = std::greater<std::pair<double, Index>>();
  std::make_heap(heap.begin(), heap.end(), later);
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), later);
    const auto [distance, i] = heap.back();
    heap.pop_back();
    if (distance > state.distance[i] || level.fixed[i]) continue;
    for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
      const Index j = level.arcHead[arc];
      if (labelOf(state, j) != state.label[i] || level.fixed[j]) continue;
      const double to = distance + glm::length(level.center[i] - level.center[j]);
      if (to > state.band || to >= state.distance[j]) continue;
      state.distance[j] = to;
      heap.emplace_back(to, j);
      std::push_heap(heap.begin(), heap.end(), later);
    }
  }
  band.clear();
  for (const Index chart : {a, b}) {
    for (const Index i : state.charts[chart].nodes) {
      if (state.distance[i] == kNoDistance || level.fixed[i]) continue;
      state.local[i] = static_cast<Index>(band.size());
      band.push_back(i);
    }
  }
  return !band.empty();
}

}  // namespace chartflood
