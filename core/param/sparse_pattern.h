#pragma once
/// Where the entries of a chart's systems and of their factors stand: the order of elimination and
/// what follows from it.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// Runs of columns of a factor that have the same rows below them, and are eliminated together as
/// one dense front. Each comes after those whose rows it holds (postorder).
struct Supernodes {
  std::vector<Index> first;           ///< place of the first column; at the end, their number
  std::vector<Index> parent;          ///< that the first row below belongs to, kNone at roots
  std::vector<std::size_t> rowBegin;  ///< into row, one entry more than supernodes
  std::vector<Index> row;             ///< places below the own columns, ascending

  std::size_t count() const { return parent.size(); }
  std::size_t columns(Index s) const { return first[s + 1] - first[s]; }
  std::span<const Index> rows(Index s) const {
    return std::span(row).subspan(rowBegin[s], rowBegin[s + 1] - rowBegin[s]);
  }
  /// Side of the front: own columns and rows below.
  std::size_t size(Index s) const { return columns(s) + rows(s).size(); }
};

/// Depends on the triangles alone.
struct SparsePattern {
  /// Orders the vertices by approximate minimum degree (Amestoy, Davis, Duff 1996).
  /// \param triangles vertices of each, below `vertexCount`
  SparsePattern(std::span<const std::array<Index, 3>> triangles, std::size_t vertexCount);

  std::size_t size() const { return place.size(); }

  std::vector<Index> place;  ///< of each vertex in the order of elimination
  /// Rows of the strictly lower triangle, column after column, in places.
  std::vector<Index> columnStart, row;
  std::vector<Index> sideSlot;   ///< entry of each side in `row`
  std::vector<bool> sideTurned;  ///< the side starts at the earlier place
  Supernodes supernodes;
};

}  // namespace chartflood
