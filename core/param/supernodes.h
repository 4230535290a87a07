#pragma once
/// Finds the supernodes of a factor from the pattern of its matrix.

#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/param/sparse_pattern.h"

namespace chartflood {

/// The elimination tree of a symmetric matrix: the parent of each column, kNone at roots, and how
/// many entries its column of the factor has below the diagonal (Liu 1990; Davis 2005).
struct EliminationTree {
  std::vector<Index> parent, count;
};

/// \param columnStart into `row`, one entry more than columns
/// \param row of the strictly upper triangle, column after column
EliminationTree eliminationTree(std::span<const Index> columnStart, std::span<const Index> row);

/// Columns so that each follows its descendants in the tree, which stay in their order.
/// \return the column at each new place
std::vector<Index> postorder(const EliminationTree& tree);

/// Supernodes of a matrix whose tree is in postorder. Small ones are joined to the one after them
/// where that adds few zeros.
/// \param columnStart into `row`, one entry more than columns
/// \param row of the strictly lower triangle, column after column
Supernodes findSupernodes(const EliminationTree& tree, std::span<const Index> columnStart,
                          std::span<const Index> row);

}  // namespace chartflood
