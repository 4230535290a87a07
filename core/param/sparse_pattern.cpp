#include "core/param/sparse_pattern.h"

#include <algorithm>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include "core/base/check.h"
#include "core/param/supernodes.h"

namespace chartflood {

namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Vertices in the order of elimination.
std::vector<Index> minimumDegree(std::span<const std::array<Index, 3>> triangles,
                                 std::size_t vertexCount) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * triangles.size() + vertexCount);
  // A row without a diagonal entry would count as dense.
  for (std::size_t v = 0; v < vertexCount; ++v) {
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), 1.0);
  }
  for (const auto& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<int>(t[i]), b = static_cast<int>(t[i == 2 ? 0 : i + 1]);
      entries.emplace_back(std::min(a, b), std::max(a, b), 1.0);
    }
  }
  const auto size = static_cast<Eigen::Index>(vertexCount);
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(matrix, order);
  std::vector<Index> vertices(vertexCount);
  for (std::size_t k = 0; k < vertexCount; ++k) {
    vertices[k] = static_cast<Index>(order.indices()[static_cast<Eigen::Index>(k)]);
  }
  return vertices;
}

/// The two ends of each side, in places.
struct Sides {
  std::vector<Index> low, high;
};

Sides sidesOf(std::span<const std::array<Index, 3>> triangles, std::span<const Index> place) {
  Sides sides;
  sides.low.resize(3 * triangles.size());
  sides.high.resize(3 * triangles.size());
  for (std::size_t side = 0; side < sides.low.size(); ++side) {
    const auto& t = triangles[side / 3];
    const Index a = place[t[side % 3]], b = place[t[side % 3 == 2 ? 0 : side % 3 + 1]];
    CF_CHECK(a != b);
    sides.low[side] = std::min(a, b);
    sides.high[side] = std::max(a, b);
  }
  return sides;
}

/// Entries of a matrix, each once: rows ascending, column after column.
struct Columns {
  std::vector<Index> start, row;
};

Columns columnsOf(std::span<const Index> column, std::span<const Index> row, std::size_t size) {
  std::vector<Index> begin(size + 2, 0), sorted(row.size());
  for (const Index k : column) ++begin[k + 2];
  for (std::size_t k = 2; k < begin.size(); ++k) begin[k] += begin[k - 1];
  for (std::size_t e = 0; e < row.size(); ++e) sorted[begin[column[e] + 1]++] = row[e];
  Columns columns{{0}, {}};
  for (std::size_t k = 0; k < size; ++k) {
    const auto first = sorted.begin() + begin[k], last = sorted.begin() + begin[k + 1];
    std::sort(first, last);
    columns.row.insert(columns.row.end(), first, std::unique(first, last));
    columns.start.push_back(static_cast<Index>(columns.row.size()));
  }
  return columns;
}

/// Renames columns so that each follows its descendants.
EliminationTree inPostorder(const EliminationTree& tree, std::span<Index> place) {
  const std::vector<Index> order = postorder(tree);
  std::vector<Index> renamed(order.size());
  for (Index k = 0; k < order.size(); ++k) renamed[order[k]] = k;
  EliminationTree ordered{std::vector<Index>(order.size()), std::vector<Index>(order.size())};
  for (Index k = 0; k < order.size(); ++k) {
    const Index parent = tree.parent[order[k]];
    ordered.parent[k] = parent == kNone ? kNone : renamed[parent];
    ordered.count[k] = tree.count[order[k]];
  }
  for (Index& p : place) p = renamed[p];
  return ordered;
}

}  // namespace

SparsePattern::SparsePattern(std::span<const std::array<Index, 3>> triangles,
                             std::size_t vertexCount)
    : place(vertexCount) {
  const std::vector<Index> order = minimumDegree(triangles, vertexCount);
  for (Index k = 0; k < vertexCount; ++k) place[order[k]] = k;
  Sides sides = sidesOf(triangles, place);
  const Columns upper = columnsOf(sides.high, sides.low, vertexCount);
  const EliminationTree tree = inPostorder(eliminationTree(upper.start, upper.row), place);
  sides = sidesOf(triangles, place);
  Columns lower = columnsOf(sides.low, sides.high, vertexCount);
  columnStart = std::move(lower.start);
  row = std::move(lower.row);
  sideSlot.resize(sides.low.size());
  sideTurned.resize(sides.low.size());
  for (std::size_t side = 0; side < sideSlot.size(); ++side) {
    const auto begin = row.begin() + columnStart[sides.low[side]];
    const auto end = row.begin() + columnStart[sides.low[side] + 1];
    sideSlot[side] =
        static_cast<Index>(std::lower_bound(begin, end, sides.high[side]) - row.begin());
    sideTurned[side] = place[triangles[side / 3][side % 3]] == sides.low[side];
  }
  supernodes = findSupernodes(tree, columnStart, row);
}

}  // namespace chartflood
