#include "core/pack/grid_layout.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

namespace {

std::size_t gridColumns(std::size_t count) {
  std::size_t columns = 1;
  while (columns * columns < count) ++columns;
  return columns;
}

}  // namespace

double gridCell(std::size_t count, const PackGaps& gaps) {
  const double columns = static_cast<double>(gridColumns(count));
  return (1 - 2 * gaps.border - (columns - 1) * gaps.between) / columns;
}

std::vector<Placement> gridLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                  bool oneScale) {
  // Rounding must not push a chart over the edge of its cell.
  constexpr double kWithin = 1 - 1e-9;
  const std::size_t columns = gridColumns(outlines.size());
  const double cell = gridCell(outlines.size(), gaps);
  std::vector<EnclosingSquare> squares;
  double largest = 0;
  for (const ChartOutline& outline : outlines) {
    squares.push_back(smallestSquare(outline.hull));
    largest = std::max(largest, squares.back().side);
  }
  std::vector<Placement> placement;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double side = oneScale ? largest : squares[i].side;
    const double scale = side > 0 ? cell * kWithin / side : 1;
    const std::size_t inColumn = i % columns, inRow = i / columns;
    const auto column = static_cast<double>(inColumn), row = static_cast<double>(inRow);
    const glm::dvec2 middle(gaps.border + column * (cell + gaps.between) + cell / 2,
                            1 - (gaps.border + row * (cell + gaps.between) + cell / 2));
    placement.push_back({squares[i].angle, scale, middle - scale * squares[i].center});
  }
  return placement;
}

}  // namespace chartflood
