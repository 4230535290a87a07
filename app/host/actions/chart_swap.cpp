#include "app/host/actions/chart_swap.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/host/script/action.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "render/scene/chart_palette.h"

namespace chartflood {

namespace {

/// Charts that share an edge with this one.
std::vector<Index> neighboursOf(std::span<const ChartPair> pairs, Index chart) {
  std::vector<Index> found;
  for (const auto& [a, b] : pairs) {
    if (a == chart) found.push_back(b);
    if (b == chart) found.push_back(a);
  }
  return found;
}

/// Whether a chart that gets this colour differs from its neighbours, `except` of them aside.
bool differs(std::span<const Index> colors, const std::vector<Index>& neighbours, Index color,
             Index except) {
  return std::none_of(neighbours.begin(), neighbours.end(), [&](Index other) {
    return other != except && other < colors.size() && colors[other] == color;
  });
}

std::vector<ChartPair> chartPairs(const Results& results) {
  if (!results.mesh || !results.segmentation) return {};
  if (results.segmentation->label.size() != results.mesh->faceCount()) return {};
  return neighbourCharts(*results.mesh, results.segmentation->label);
}

bool canSwap(std::span<const Index> colors, std::span<const ChartPair> pairs, Index chart,
             Index other) {
  return differs(colors, neighboursOf(pairs, chart), colors[other], other) &&
         differs(colors, neighboursOf(pairs, other), colors[chart], chart);
}

}  // namespace

std::vector<Index> colorPartners(const AppState& state, Index chart) {
  const std::vector<Index>& colors = state.view.chartColors;
  std::vector<Index> partners;
  if (chart >= colors.size()) return partners;
  const std::vector<ChartPair> pairs = chartPairs(state.results());
  for (Index other = 0; other < colors.size(); ++other) {
    if (colors[other] != colors[chart] && canSwap(colors, pairs, chart, other)) {
      partners.push_back(other);
    }
  }
  return partners;
}

void swapColors(AppState& state, Index chart, Index other) {
  std::vector<Index>& colors = state.view.chartColors;
  if (colors.empty()) throw Refusal("The charts have no colours yet.");
  for (const Index each : {chart, other}) {
    if (each >= colors.size()) throw Refusal("There is no chart " + std::to_string(each) + ".");
  }
  if (colors[chart] == colors[other]) throw Refusal("Both charts have the same colour.");
  if (!canSwap(colors, chartPairs(state.results()), chart, other)) {
    throw Refusal("One of them would get the colour of a neighbour.");
  }
  std::swap(colors[chart], colors[other]);
  ++state.view.recolored;
}

}  // namespace chartflood
