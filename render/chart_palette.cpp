#include "render/chart_palette.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr std::uint32_t kMuted[] = {0xCC6677, 0x332288, 0xDDCC77, 0x117733, 0x88CCEE,
                                    0x882255, 0x44AA99, 0x999933, 0xAA4499, 0xDDDDDD};
constexpr std::uint32_t kOkabeIto[] = {0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442,
                                       0x0072B2, 0xD55E00, 0xCC79A7, 0xDDDDDD};

constexpr ChartPalette kPalettes[] = {
    {"muted", "Muted", "P. Tol, Colour Schemes, SRON technical note, 2021", kMuted, 1},
    {"okabe-ito", "Okabe-Ito", "M. Okabe and K. Ito, Color Universal Design, 2008", kOkabeIto, 1},
};

void sortUnique(std::vector<ChartPair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// The least used colour that no neighbour has; the reserve, then any colour, when all are taken.
Index chooseColor(const std::vector<bool>& taken, const std::vector<std::size_t>& uses,
                  std::size_t usual) {
  Index best = kNone;
  for (std::size_t c = 0; c < usual; ++c) {
    if (!taken[c] && (best == kNone || uses[c] < uses[best])) best = static_cast<Index>(c);
  }
  for (std::size_t c = usual; best == kNone && c < taken.size(); ++c) {
    if (!taken[c]) best = static_cast<Index>(c);
  }
  if (best != kNone) return best;
  return static_cast<Index>(std::min_element(uses.begin(), uses.end()) - uses.begin());
}

}  // namespace

std::span<const ChartPalette> chartPaletteTable() { return kPalettes; }

const ChartPalette* findChartPalette(std::string_view id) {
  const auto found = std::find_if(std::begin(kPalettes), std::end(kPalettes),
                                  [&](const ChartPalette& p) { return p.id == id; });
  return found == std::end(kPalettes) ? nullptr : &*found;
}

std::vector<ChartPair> neighbourCharts(const Mesh& mesh, std::span<const Index> label) {
  std::vector<ChartPair> pairs;
  const std::span<const Index> opposite = mesh.opposite();
  for (Index side = 0; side < opposite.size(); ++side) {
    if (opposite[side] == kNone || opposite[side] < side) continue;
    const Index a = label[mesh.faceOf(side / 3)], b = label[mesh.faceOf(opposite[side] / 3)];
    if (a == b || a == kNone || b == kNone) continue;
    const ChartPair pair = std::minmax(a, b);
    // Sides of one seam mostly follow one another, so this keeps the list short.
    if (pairs.empty() || pairs.back() != pair) pairs.push_back(pair);
  }
  sortUnique(pairs);
  return pairs;
}

std::vector<ChartPair> nearbyPairs(std::span<const glm::dvec3> points) {
  constexpr std::size_t kNeighbours = 6;  // mean degree of a triangulation
  constexpr std::size_t kMost = 4096;     // beyond that the quadratic search is not worth it
  std::vector<ChartPair> pairs;
  if (points.size() > kMost) return pairs;
  std::vector<std::pair<double, Index>> near;
  for (Index i = 0; i < points.size(); ++i) {
    near.clear();
    for (Index j = 0; j < points.size(); ++j) {
      const glm::dvec3 d = points[j] - points[i];
      if (j != i) near.emplace_back(glm::dot(d, d), j);
    }
    const std::size_t count = std::min(kNeighbours, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    for (std::size_t k = 0; k < count; ++k) pairs.push_back(std::minmax(i, near[k].second));
  }
  sortUnique(pairs);
  return pairs;
}

std::vector<Index> colorCharts(std::size_t chartCount, std::span<const ChartPair> neighbours,
                               std::span<const Index> previous, const ChartPalette& palette) {
  std::vector<std::vector<Index>> adjacent(chartCount);
  for (const auto& [a, b] : neighbours) {
    adjacent[a].push_back(b);
    adjacent[b].push_back(a);
  }
  std::vector<Index> color(chartCount, kNone);
  std::vector<std::size_t> uses(palette.colors.size(), 0);
  // First those that may keep their colour, so that new charts give way to old ones.
  for (Index chart = 0; chart < chartCount && chart < previous.size(); ++chart) {
    const Index old = previous[chart];
    if (old >= palette.colors.size()) continue;
    const bool clash = std::any_of(adjacent[chart].begin(), adjacent[chart].end(),
                                   [&](Index other) { return color[other] == old; });
    if (clash) continue;
    color[chart] = old;
    ++uses[old];
  }
  for (Index chart = 0; chart < chartCount; ++chart) {
    if (color[chart] != kNone) continue;
    std::vector<bool> taken(palette.colors.size(), false);
    for (const Index other : adjacent[chart]) {
      if (color[other] != kNone) taken[color[other]] = true;
    }
    color[chart] = chooseColor(taken, uses, palette.colors.size() - palette.reserve);
    ++uses[color[chart]];
  }
  return color;
}

}  // namespace chartflood
