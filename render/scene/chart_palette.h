#pragma once
/// Colours of charts: neighbours differ, and a chart keeps its colour while the charts move.

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/model/mesh.h"
#include "render/scene/color_map.h"

namespace chartflood {

/// Colours for charts; the last `reserve` ones are only used where the others are not enough.
struct ChartPalette {
  const char* id;
  const char* label;
  const char* source;
  std::span<const std::uint32_t> colors;  ///< 0xRRGGBB
  std::size_t reserve;
};
/// "muted" (Paul Tol) first, then "okabe-ito".
std::span<const ChartPalette> chartPaletteTable();
const ChartPalette* findChartPalette(std::string_view id);

/// A pair of charts that share an edge, smaller one first.
using ChartPair = std::pair<Index, Index>;

/// Neighbouring charts of a labelling (one label a face, kNone while free), ascending, each once.
std::vector<ChartPair> neighbourCharts(const Mesh& mesh, std::span<const Index> label);

/// For each point the few closest others: a guess at the neighbours before charts have grown.
std::vector<ChartPair> nearbyPairs(std::span<const glm::dvec3> points);

/// Number of the palette's colour for each chart, such that neighbours differ wherever greedy
/// colouring finds a way. Charts keep their entry of `previous` (kNone or missing: none) unless it
/// clashes with a neighbour of smaller number; the others take the least used free colour. Where
/// none is free a few neighbours are repainted before a reserved colour is taken.
std::vector<Index> colorCharts(std::size_t chartCount, std::span<const ChartPair> neighbours,
                               std::span<const Index> previous, const ChartPalette& palette);

/// Colours with which new charts are a movement of the old ones: a chart takes the number of the
/// old chart that it shares most faces with; an old chart gives its number to one chart, larger
/// shares first. kNone where no old chart is left or a new neighbour has the number already: for
/// colorCharts(), as its `previous`. One label a face, kNone while free. Cost: linear in the faces,
/// plus the sorting of the pairs of charts that overlap.
std::vector<Index> inheritedColors(const Mesh& mesh, std::span<const Index> oldLabel,
                                   std::span<const Index> oldColor, std::span<const Index> newLabel,
                                   std::size_t newCount);

}  // namespace chartflood
