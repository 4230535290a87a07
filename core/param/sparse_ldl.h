#pragma once
/// Sparse symmetric systems over the vertices of a chart, solved by an LDL^T factorisation that is
/// ordered once and filled as often as the weights change. One solver serves three kinds of
/// entries: a number (the same for u and v), a complex number (u + iv), and a 2 x 2 matrix that
/// couples u and v.

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "core/base/index.h"

namespace chartflood {

/// Where entries of the matrix and of its factor stand. Depends on the triangles alone.
struct SparsePattern {
  /// Orders the vertices by approximate minimum degree (Amestoy, Davis, Duff 1996).
  /// \param triangles vertices of each, below `vertexCount`
  SparsePattern(std::span<const std::array<Index, 3>> triangles, std::size_t vertexCount);

  std::size_t size() const { return place.size(); }

  std::vector<Index> place;  ///< of each vertex in the order of elimination
  /// Rows of the strictly upper triangle, column after column, in places.
  std::vector<Index> columnStart, row;
  std::vector<Index> sideSlot;           ///< entry of each side in `row`
  std::vector<bool> sideTurned;          ///< the side starts at the later place
  std::vector<Index> parent;             ///< elimination tree, kNone at roots
  std::vector<std::size_t> factorStart;  ///< first entry of each column of the factor
};

/// A symmetric (or Hermitian) positive definite matrix with a row for each vertex and an entry for
/// each side, and its factorisation. `Entry` is double, std::complex<double> or glm::dmat2.
template <class Entry>
class SparseLdl {
 public:
  explicit SparseLdl(const SparsePattern& pattern);

  /// Sets all entries to zero.
  void clear();
  void addDiagonal(Index vertex, const Entry& value) { diagonal_[pattern_.place[vertex]] += value; }
  /// Adds to the entry in the row of the side's start and the column of its end, and the adjoint to
  /// its mirror.
  void addSide(Index side, const Entry& value);
  /// Makes the equations of the marked vertices x = right hand side, and takes them out of all
  /// others.
  void fix(const std::vector<bool>& vertices);
  /// Adds `share` of its size to each diagonal entry.
  void damp(double share);
  /// False, and nothing to solve with, when the matrix is not positive definite.
  /// Cost: about 1 us a triangle for numbers, 3 for matrices, at 10,000 triangles.
  bool factor();
  /// Replaces right hand sides, one a vertex, by the solution. \pre factor() returned true
  void solve(std::span<glm::dvec2> x);

 private:
  bool eliminate(Index k);

  const SparsePattern& pattern_;
  std::vector<Entry> diagonal_, upper_;  // the matrix, in places
  std::vector<Entry> inverse_, factor_;  // D^-1 and L
  std::vector<Index> factorRow_;         // rows of L
  std::vector<std::size_t> filled_;      // end of each column of L so far
  std::vector<Entry> work_;              // one column on its way
  std::vector<Index> mark_, stack_;
  std::vector<glm::dvec2> permuted_;
};

extern template class SparseLdl<double>;
extern template class SparseLdl<std::complex<double>>;
extern template class SparseLdl<glm::dmat2>;

}  // namespace chartflood
