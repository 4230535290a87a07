#include <algorithm>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include "core/base/check.h"
#include "core/param/sparse_ldl.h"

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

/// Elimination tree and size of each column of the factor (Liu 1990; Davis 2005).
void analyse(SparsePattern& p) {
  const auto size = static_cast<Index>(p.size());
  std::vector<Index> mark(size, kNone);
  std::vector<std::size_t> count(size, 0);
  p.parent.assign(size, kNone);
  for (Index k = 0; k < size; ++k) {
    mark[k] = k;
    for (Index entry = p.columnStart[k]; entry < p.columnStart[k + 1]; ++entry) {
      for (Index i = p.row[entry]; mark[i] != k; i = p.parent[i]) {
        if (p.parent[i] == kNone) p.parent[i] = k;
        ++count[i];
        mark[i] = k;
      }
    }
  }
  p.factorStart.assign(size + 1, 0);
  for (Index k = 0; k < size; ++k) p.factorStart[k + 1] = p.factorStart[k] + count[k];
}

}  // namespace

SparsePattern::SparsePattern(std::span<const std::array<Index, 3>> triangles,
                             std::size_t vertexCount)
    : place(vertexCount), columnStart(vertexCount + 1, 0) {
  const std::vector<Index> order = minimumDegree(triangles, vertexCount);
  for (Index k = 0; k < vertexCount; ++k) place[order[k]] = k;
  // Sort the sides' entries into columns, then drop those that stand twice.
  sideSlot.resize(3 * triangles.size());
  sideTurned.resize(3 * triangles.size());
  std::vector<Index> low(sideSlot.size()), high(sideSlot.size()), fill(vertexCount + 1, 0);
  for (std::size_t side = 0; side < sideSlot.size(); ++side) {
    const auto& t = triangles[side / 3];
    const Index a = place[t[side % 3]], b = place[t[side % 3 == 2 ? 0 : side % 3 + 1]];
    CF_CHECK(a != b);
    sideTurned[side] = a > b;
    low[side] = std::min(a, b);
    high[side] = std::max(a, b);
    ++fill[high[side] + 1];
  }
  for (std::size_t k = 0; k < vertexCount; ++k) fill[k + 1] += fill[k];
  std::vector<Index> sorted(sideSlot.size()), next(fill.begin(), fill.end() - 1);
  for (std::size_t side = 0; side < sideSlot.size(); ++side) {
    sorted[next[high[side]]++] = low[side];
  }
  for (std::size_t k = 0; k < vertexCount; ++k) {
    const auto begin = sorted.begin() + fill[k], end = sorted.begin() + fill[k + 1];
    std::sort(begin, end);
    row.insert(row.end(), begin, std::unique(begin, end));
    columnStart[k + 1] = static_cast<Index>(row.size());
  }
  for (std::size_t side = 0; side < sideSlot.size(); ++side) {
    const auto begin = row.begin() + columnStart[high[side]];
    const auto end = row.begin() + columnStart[high[side] + 1];
    sideSlot[side] = static_cast<Index>(std::lower_bound(begin, end, low[side]) - row.begin());
  }
  analyse(*this);
}

}  // namespace chartflood
