#include "core/flood/flood.h"

#include <cstdint>

#include "core/base/check.h"
#include "core/flood/arc_store.h"
#include "core/flood/band_store.h"
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
template <template <class> class Store>
std::unique_ptr<Flood> makeNarrow(const FloodGraph& graph, std::size_t charts, double meanDelay) {
  if (charts <= Store<std::uint8_t>::kMaxCharts) {
    return std::make_unique<FloodEngine<Store<std::uint8_t>>>(graph, meanDelay);
  }
  if (charts <= Store<std::uint16_t>::kMaxCharts) {
    return std::make_unique<FloodEngine<Store<std::uint16_t>>>(graph, meanDelay);
  }
  return std::make_unique<FloodEngine<Store<std::uint32_t>>>(graph, meanDelay);
}

}  // namespace

std::unique_ptr<Flood> makeFlood(const FloodGraph& graph, std::size_t chartCount, OfferRule rule) {
  const double mean = meanDelay(graph);
  if (rule == OfferRule::ShortestTimes) {
    CF_CHECK(!graph.packed());
    return std::make_unique<FloodEngine<NodeStore>>(graph, mean);
  }
  if (graph.packed()) return makeNarrow<TriangleStore>(graph, chartCount, mean);
  if (graph.firstHub != kNone) return makeNarrow<BandStore>(graph, chartCount, mean);
  return std::make_unique<FloodEngine<ArcStore>>(graph, mean);
}

}  // namespace chartflood
