#include "core/flood/flood.h"

#include <cstdint>

#include "core/base/check.h"
#include "core/flood/arc_store.h"
#include "core/flood/flood_engine.h"
#include "core/flood/node_store.h"
#include "core/flood/triangle_store.h"

namespace chartflood {

namespace {

double meanDelay(const FloodGraph& graph) {
  double sum = 0;
  std::size_t count = 0;
  for (const FloodFace& face : graph.faces) {
    for (int k = 0; k < 3; ++k) {
      if (face.neighbour[k] == kNone) continue;
      sum += static_cast<double>(face.delay[k]);
      ++count;
    }
  }
  for (const FloodArc& arc : graph.arcs) sum += static_cast<double>(arc.delay);
  count += graph.arcs.size();
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

/// With labels as narrow as the number of charts allows.
template <bool kHubs>
std::unique_ptr<Flood> makeNarrow(const FloodGraph& graph, std::size_t charts, double meanDelay) {
  const auto make = [&]<class Label>(Label) {
    return std::make_unique<FloodEngine<TriangleStore<Label, kHubs>>>(graph, meanDelay);
  };
  if (charts <= TriangleStore<std::uint8_t, kHubs>::kMaxCharts) return make(std::uint8_t{});
  if (charts <= TriangleStore<std::uint16_t, kHubs>::kMaxCharts) return make(std::uint16_t{});
  return make(std::uint32_t{});
}

}  // namespace

std::unique_ptr<Flood> makeFlood(const FloodGraph& graph, std::size_t chartCount, OfferRule rule) {
  const double mean = meanDelay(graph);
  if (rule == OfferRule::ShortestTimes) {
    CF_CHECK(!graph.packed());
    return std::make_unique<FloodEngine<NodeStore>>(graph, mean);
  }
  if (!graph.hubs.empty()) return makeNarrow<true>(graph, chartCount, mean);
  if (graph.packed()) return makeNarrow<false>(graph, chartCount, mean);
  return std::make_unique<FloodEngine<ArcStore>>(graph, mean);
}

}  // namespace chartflood
