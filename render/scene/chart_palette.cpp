#include "render/scene/chart_palette.h"

#include <algorithm>
#include <iterator>
#include <utility>

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

/// Greedy colouring of a graph with a few repairs.
class Coloring {
 public:
  Coloring(std::size_t chartCount, std::span<const ChartPair> neighbours, std::size_t colors,
           std::size_t usual)
      : color(chartCount, kNone), adjacent_(chartCount), uses_(colors, 0), usual_(usual) {
    for (const auto& [a, b] : neighbours) {
      adjacent_[a].push_back(b);
      adjacent_[b].push_back(a);
    }
  }

  bool clashes(Index chart, Index wanted) const {
    return std::any_of(adjacent_[chart].begin(), adjacent_[chart].end(),
                       [&](Index other) { return color[other] == wanted; });
  }
  void paint(Index chart, Index wanted) {
    if (color[chart] != kNone) --uses_[color[chart]];
    color[chart] = wanted;
    ++uses_[wanted];
  }
  void paintFree(Index chart) {
    Index wanted = leastUsedFree(chart);
    if (wanted == kNone) wanted = clearOne(chart);
    if (wanted == kNone) wanted = reserve(chart);
    paint(chart, wanted);
  }

  std::vector<Index> color;  ///< of each chart, kNone before it is painted

 private:
  /// The least used usual colour that no neighbour has, other than the chart's own; kNone if none.
  Index leastUsedFree(Index chart) const {
    Index best = kNone;
    for (Index c = 0; c < usual_; ++c) {
      if (c == color[chart] || clashes(chart, c)) continue;
      if (best == kNone || uses_[c] < uses_[best]) best = c;
    }
    return best;
  }
  /// Frees a colour around a chart by repainting the neighbours that have it, the fewest possible;
  /// kNone when every colour has a neighbour that cannot change.
  Index clearOne(Index chart) {
    std::vector<Index> fewest;
    Index best = kNone;
    for (Index c = 0; c < usual_; ++c) {
      std::vector<Index> having;
      std::copy_if(adjacent_[chart].begin(), adjacent_[chart].end(), std::back_inserter(having),
                   [&](Index other) { return color[other] == c; });
      const bool movable = std::all_of(having.begin(), having.end(),
                                       [&](Index other) { return leastUsedFree(other) != kNone; });
      if (movable && (best == kNone || having.size() < fewest.size())) {
        best = c;
        fewest = having;
      }
    }
    // One after the other: neighbours of one another may not move to the same colour.
    for (const Index other : fewest) {
      const Index wanted = leastUsedFree(other);
      if (wanted == kNone) return kNone;
      paint(other, wanted);
    }
    return best;
  }
  /// A reserved colour, or where these clash too the least used of all.
  Index reserve(Index chart) const {
    for (auto c = static_cast<Index>(usual_); c < uses_.size(); ++c) {
      if (!clashes(chart, c)) return c;
    }
    return static_cast<Index>(std::min_element(uses_.begin(), uses_.end()) - uses_.begin());
  }

  std::vector<std::vector<Index>> adjacent_;
  std::vector<std::size_t> uses_;
  std::size_t usual_;
};

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
  const std::size_t usual = palette.colors.size() - palette.reserve;
  Coloring coloring(chartCount, neighbours, palette.colors.size(), usual);
  // First those that may keep their colour, so that new charts give way to old ones.
  for (Index chart = 0; chart < chartCount && chart < previous.size(); ++chart) {
    const Index old = previous[chart];
    if (old < usual && !coloring.clashes(chart, old)) coloring.paint(chart, old);
  }
  for (Index chart = 0; chart < chartCount; ++chart) {
    if (coloring.color[chart] == kNone) coloring.paintFree(chart);
  }
  return coloring.color;
}

namespace {

/// An old and a new chart, and how many faces they share.
struct Overlap {
  Index before, after;
  std::size_t faces;
};

/// All pairs of charts that share faces, larger shares first.
std::vector<Overlap> overlaps(std::span<const Index> before, std::size_t beforeCount,
                              std::span<const Index> after, std::size_t afterCount) {
  // Faces in the order of their new charts, so that one row of counters is enough.
  std::vector<std::size_t> begin(afterCount + 1, 0);
  for (const Index chart : after) begin[chart < afterCount ? chart : afterCount]++;
  std::size_t sum = 0;
  for (std::size_t& each : begin) sum += std::exchange(each, sum);
  std::vector<Index> faces(after.size());
  std::vector<std::size_t> next(begin);
  for (Index f = 0; f < after.size(); ++f) {
    faces[next[after[f] < afterCount ? after[f] : afterCount]++] = f;
  }
  std::vector<Overlap> pairs;
  std::vector<std::size_t> shared(beforeCount, 0);
  std::vector<Index> met;
  for (Index chart = 0; chart < afterCount; ++chart) {
    for (std::size_t i = begin[chart]; i < begin[chart + 1]; ++i) {
      const Index old = before[faces[i]];
      if (old < beforeCount && shared[old]++ == 0) met.push_back(old);
    }
    for (const Index old : met) pairs.push_back({old, chart, std::exchange(shared[old], 0)});
    met.clear();
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Overlap& a, const Overlap& b) { return a.faces > b.faces; });
  return pairs;
}

}  // namespace

std::vector<Index> inheritedColors(const Mesh& mesh, std::span<const Index> oldLabel,
                                   std::span<const Index> oldColor, std::span<const Index> newLabel,
                                   std::size_t newCount) {
  std::vector<std::vector<Index>> adjacent(newCount);
  for (const auto& [a, b] : neighbourCharts(mesh, newLabel)) {
    adjacent[a].push_back(b);
    adjacent[b].push_back(a);
  }
  std::vector<Index> color(newCount, kNone);
  std::vector<bool> given(oldColor.size(), false), matched(newCount, false);
  for (const Overlap& pair : overlaps(oldLabel, oldColor.size(), newLabel, newCount)) {
    if (given[pair.before] || matched[pair.after]) continue;
    given[pair.before] = matched[pair.after] = true;
    const Index wanted = oldColor[pair.before];
    const auto& around = adjacent[pair.after];
    const bool clashes = std::any_of(around.begin(), around.end(),
                                     [&](Index other) { return color[other] == wanted; });
    if (!clashes) color[pair.after] = wanted;
  }
  return color;
}

}  // namespace chartflood
