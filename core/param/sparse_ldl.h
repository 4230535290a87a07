#pragma once
/// Sparse symmetric systems over the vertices of a chart, solved by an LDL^T factorisation that is
/// ordered once and filled as often as the weights change. One solver serves three kinds of
/// entries: a number (the same for u and v), a complex number (u + iv), and a 2 x 2 matrix that
/// couples u and v. Eigen only orders the unknowns: factorising the 2 x 2 entries here was
/// measured at 5.7 times the speed of its own factorisation of the same matrix in numbers.

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "core/base/index.h"
#include "core/param/sparse_pattern.h"

namespace chartflood {

/// How an entry and an unknown are made of numbers.
template <class Entry>
struct LdlKind;

/// A symmetric (or Hermitian) positive definite matrix with a row for each vertex and an entry for
/// each side, and its factorisation: supernodes are eliminated one by one as dense fronts, and what
/// each leaves to the columns after it waits on a stack (Duff and Reid 1983, "The multifrontal
/// solution of indefinite sparse symmetric linear equations"). `Entry` is double,
/// std::complex<double> or glm::dmat2.
template <class Entry>
class SparseLdl {
 public:
  /// The pattern must outlive it.
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
  /// Cost: as n^1.5 for n vertices of a chart.
  bool factor();
  /// Replaces right hand sides, one a vertex, by the solution. \pre factor() returned true
  void solve(std::span<glm::dvec2> x);

 private:
  using Kind = LdlKind<Entry>;

  void assemble(Index supernode);
  void takeChild(Index child);
  void keepColumns(Index supernode);
  void passOn(Index supernode);
  double* realPart(std::size_t row, std::size_t column) { return &front_[column * stride_ + row]; }

  const SparsePattern& pattern_;
  std::vector<Entry> diagonal_, lower_;  // the matrix, in places
  std::vector<std::size_t> panelBegin_;  // into factor_
  std::unique_ptr<double[]> factor_;     // columns of L with all rows of their front
  std::vector<double> inverse_;          // D^-1
  std::unique_ptr<double[]> front_;      // the one at hand
  std::size_t stride_ = 0, plane_ = 0;   // of front_: between columns, between its two parts
  std::vector<Index> local_;             // row in the front of each place
  std::vector<double> waiting_;          // what children leave to fronts to come, a stack
  std::size_t waitingEnd_ = 0;           // of what is on it
  std::vector<Index> children_;          // to whom these belong
};

extern template class SparseLdl<double>;
extern template class SparseLdl<std::complex<double>>;
extern template class SparseLdl<glm::dmat2>;

}  // namespace chartflood
