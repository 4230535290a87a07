#include "core/param/sparse_ldl.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "core/base/check.h"

namespace chartflood {

namespace {

using Complex = std::complex<double>;

double adjoint(double a) { return a; }
Complex adjoint(const Complex& a) { return std::conj(a); }
glm::dmat2 adjoint(const glm::dmat2& a) { return glm::transpose(a); }

// Products written out: the complex product of the library checks for NaN first.
double times(double a, double b) { return a * b; }
Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
glm::dmat2 times(const glm::dmat2& a, const glm::dmat2& b) { return a * b; }

glm::dvec2 product(double a, const glm::dvec2& x) { return a * x; }
glm::dvec2 product(const Complex& a, const glm::dvec2& x) {
  return {a.real() * x.x - a.imag() * x.y, a.real() * x.y + a.imag() * x.x};
}
glm::dvec2 product(const glm::dmat2& a, const glm::dvec2& x) { return a * x; }

// A number that an entry counts for when it is made larger.
double sizeOf(double a) { return a; }
double sizeOf(const Complex& a) { return a.real(); }
double sizeOf(const glm::dmat2& a) { return a[0][0] + a[1][1]; }

/// False when a pivot is not positive definite.
bool invert(double pivot, double& inverse) {
  inverse = 1 / pivot;
  return pivot > 0 && std::isfinite(inverse);
}
bool invert(const Complex& pivot, Complex& inverse) {
  inverse = 1 / pivot.real();
  return pivot.real() > 0 && std::isfinite(inverse.real());
}
bool invert(const glm::dmat2& pivot, glm::dmat2& inverse) {
  const double a = pivot[0][0], b = 0.5 * (pivot[0][1] + pivot[1][0]), d = pivot[1][1];
  const double det = a * d - b * b;
  inverse = glm::dmat2(d, -b, -b, a) / det;
  return a > 0 && det > 0 && std::isfinite(inverse[0][0]) && std::isfinite(inverse[1][1]);
}

}  // namespace

template <class Entry>
SparseLdl<Entry>::SparseLdl(const SparsePattern& pattern)
    : pattern_(pattern), diagonal_(pattern.size()), upper_(pattern.row.size()),
      inverse_(pattern.size()), factor_(pattern.factorStart.back()),
      factorRow_(pattern.factorStart.back()), filled_(pattern.size()), work_(pattern.size()),
      mark_(pattern.size()), stack_(pattern.size()), permuted_(pattern.size()) {}

template <class Entry>
void SparseLdl<Entry>::clear() {
  std::fill(diagonal_.begin(), diagonal_.end(), Entry(0));
  std::fill(upper_.begin(), upper_.end(), Entry(0));
}

template <class Entry>
void SparseLdl<Entry>::addSide(Index side, const Entry& value) {
  upper_[pattern_.sideSlot[side]] += pattern_.sideTurned[side] ? adjoint(value) : value;
}

template <class Entry>
void SparseLdl<Entry>::fix(const std::vector<bool>& vertices) {
  const SparsePattern& p = pattern_;
  std::vector<bool> fixed(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) fixed[p.place[v]] = vertices[v];
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    if (fixed[k]) diagonal_[k] = Entry(1);
    for (Index e = p.columnStart[k]; e < p.columnStart[k + 1]; ++e) {
      if (fixed[k] || fixed[p.row[e]]) upper_[e] = Entry(0);
    }
  }
}

template <class Entry>
void SparseLdl<Entry>::damp(double share) {
  for (Entry& entry : diagonal_) entry += Entry(share * sizeOf(entry));
}

/// One row of L from those above it (Davis 2005, "Algorithm 849").
template <class Entry>
bool SparseLdl<Entry>::eliminate(Index k) {
  const SparsePattern& p = pattern_;
  std::size_t top = stack_.size();
  mark_[k] = k;
  Entry pivot = diagonal_[k];
  for (Index entry = p.columnStart[k]; entry < p.columnStart[k + 1]; ++entry) {
    Index i = p.row[entry];
    work_[i] += upper_[entry];
    std::size_t length = 0;
    for (; mark_[i] != k; i = p.parent[i]) {
      stack_[length++] = i;
      mark_[i] = k;
    }
    while (length > 0) stack_[--top] = stack_[--length];
  }
  for (; top < stack_.size(); ++top) {
    const Index i = stack_[top];
    const Entry y = work_[i];
    work_[i] = Entry(0);
    const std::size_t end = filled_[i];
    for (std::size_t e = p.factorStart[i]; e < end; ++e) {
      work_[factorRow_[e]] -= times(factor_[e], y);
    }
    const Entry l = times(adjoint(y), inverse_[i]);
    pivot -= times(l, y);
    factorRow_[end] = k;
    factor_[end] = l;
    ++filled_[i];
  }
  return invert(pivot, inverse_[k]);
}

template <class Entry>
bool SparseLdl<Entry>::factor() {
  const auto size = static_cast<Index>(pattern_.size());
  std::fill(mark_.begin(), mark_.end(), kNone);
  std::fill(work_.begin(), work_.end(), Entry(0));
  std::copy_n(pattern_.factorStart.begin(), size, filled_.begin());
  for (Index k = 0; k < size; ++k) {
    if (!eliminate(k)) return false;
  }
  return true;
}

template <class Entry>
void SparseLdl<Entry>::solve(std::span<glm::dvec2> x) {
  const SparsePattern& p = pattern_;
  CF_CHECK(x.size() == p.size());
  for (std::size_t v = 0; v < x.size(); ++v) permuted_[p.place[v]] = x[v];
  for (std::size_t j = 0; j < x.size(); ++j) {
    const glm::dvec2 y = permuted_[j];
    for (std::size_t e = p.factorStart[j]; e < p.factorStart[j + 1]; ++e) {
      permuted_[factorRow_[e]] -= product(factor_[e], y);
    }
    permuted_[j] = product(inverse_[j], y);
  }
  for (std::size_t j = x.size(); j-- > 0;) {
    glm::dvec2 y = permuted_[j];
    for (std::size_t e = p.factorStart[j]; e < p.factorStart[j + 1]; ++e) {
      y -= product(adjoint(factor_[e]), permuted_[factorRow_[e]]);
    }
    permuted_[j] = y;
  }
  for (std::size_t v = 0; v < x.size(); ++v) x[v] = permuted_[p.place[v]];
}

template class SparseLdl<double>;
template class SparseLdl<std::complex<double>>;
template class SparseLdl<glm::dmat2>;

}  // namespace chartflood
