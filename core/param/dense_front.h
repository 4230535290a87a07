#pragma once
/// The dense part of a sparse factorisation: some columns of a symmetric matrix are eliminated, and
/// what they leave to the others is taken off them.

#include <cstddef>

namespace chartflood {

/// Lower triangle of a Hermitian matrix, column after column; real and imaginary parts stand apart.
struct DenseFront {
  double* real;
  double* imaginary;   ///< null: a symmetric matrix of real numbers
  std::size_t size;    ///< rows and columns
  std::size_t stride;  ///< from one column to the next
};

/// Replaces the first `columns` columns by those of L below the diagonal (unit diagonal, not
/// stored), writes D^-1 to `inverse`, and subtracts L D L^H from the other columns. The order of
/// operations on each entry is the same on every processor.
/// \return false when a pivot is not positive or its inverse not finite
bool eliminate(const DenseFront& front, std::size_t columns, double* inverse);

}  // namespace chartflood
