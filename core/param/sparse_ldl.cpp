#include "core/param/sparse_ldl.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/param/dense_front.h"

namespace chartflood {

namespace {

using Complex = std::complex<double>;

Complex adjoint(const Complex& a) { return std::conj(a); }
double adjoint(double a) { return a; }
glm::dmat2 adjoint(const glm::dmat2& a) { return glm::transpose(a); }

// A number that an entry counts for when it is made larger.
double sizeOf(double a) { return a; }
double sizeOf(const Complex& a) { return a.real(); }
double sizeOf(const glm::dmat2& a) { return a[0][0] + a[1][1]; }

// x -= l y, with l given by its parts; written out as the complex product of the library checks
// for NaN first.
void subtract(glm::dvec2& x, double l, double, const glm::dvec2& y) { x -= l * y; }
void subtract(double& x, double l, double, double y) { x -= l * y; }
void subtract(Complex& x, double re, double im, const Complex& y) {
  x -= Complex(re * y.real() - im * y.imag(), re * y.imag() + im * y.real());
}

}  // namespace

template <>
struct LdlKind<double> {
  using Unknown = glm::dvec2;
  static constexpr std::size_t kRows = 1, kParts = 1;
  static Unknown get(const glm::dvec2& v, std::size_t) { return v; }
  static void put(glm::dvec2& v, std::size_t, const Unknown& x) { v = x; }
};
template <>
struct LdlKind<Complex> {
  using Unknown = Complex;
  static constexpr std::size_t kRows = 1, kParts = 2;
  static Unknown get(const glm::dvec2& v, std::size_t) { return {v.x, v.y}; }
  static void put(glm::dvec2& v, std::size_t, const Unknown& x) { v = {x.real(), x.imag()}; }
};
/// Two rows of real numbers a vertex.
template <>
struct LdlKind<glm::dmat2> {
  using Unknown = double;
  static constexpr std::size_t kRows = 2, kParts = 1;
  static Unknown get(const glm::dvec2& v, std::size_t row) { return row == 0 ? v.x : v.y; }
  static void put(glm::dvec2& v, std::size_t row, Unknown x) { (row == 0 ? v.x : v.y) = x; }
};

template <class Entry>
SparseLdl<Entry>::SparseLdl(const SparsePattern& pattern)
    : pattern_(pattern), diagonal_(pattern.size()), lower_(pattern.row.size()),
      inverse_(Kind::kRows * pattern.size()), local_(pattern.size()) {
  const Supernodes& nodes = pattern.supernodes;
  panelBegin_.assign(1, 0);
  std::size_t largest = 0;
  for (Index s = 0; s < nodes.count(); ++s) {
    const std::size_t rows = Kind::kRows * nodes.size(s);
    panelBegin_.push_back(panelBegin_.back() +
                          Kind::kParts * rows * Kind::kRows * nodes.columns(s));
    largest = std::max(largest, rows);
  }
  factor_ = std::make_unique_for_overwrite<double[]>(panelBegin_.back());
  plane_ = largest * largest;
  front_ = std::make_unique_for_overwrite<double[]>(Kind::kParts * plane_);
}

template <class Entry>
void SparseLdl<Entry>::clear() {
  std::fill(diagonal_.begin(), diagonal_.end(), Entry(0));
  std::fill(lower_.begin(), lower_.end(), Entry(0));
}

template <class Entry>
void SparseLdl<Entry>::addSide(Index side, const Entry& value) {
  lower_[pattern_.sideSlot[side]] += pattern_.sideTurned[side] ? adjoint(value) : value;
}

template <class Entry>
void SparseLdl<Entry>::fix(const std::vector<bool>& vertices) {
  const SparsePattern& p = pattern_;
  std::vector<bool> fixed(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) fixed[p.place[v]] = vertices[v];
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    if (fixed[k]) diagonal_[k] = Entry(1);
    for (Index e = p.columnStart[k]; e < p.columnStart[k + 1]; ++e) {
      if (fixed[k] || fixed[p.row[e]]) lower_[e] = Entry(0);
    }
  }
}

template <class Entry>
void SparseLdl<Entry>::damp(double share) {
  for (Entry& entry : diagonal_) entry += Entry(share * sizeOf(entry));
}

/// The front of a supernode with the entries of its own columns.
template <class Entry>
void SparseLdl<Entry>::assemble(Index s) {
  const SparsePattern& p = pattern_;
  const Supernodes& nodes = p.supernodes;
  const Index first = nodes.first[s], end = nodes.first[s + 1];
  stride_ = Kind::kRows * nodes.size(s);
  for (std::size_t part = 0; part < Kind::kParts; ++part) {
    for (std::size_t j = 0; j < stride_; ++j) {
      double* const column = &front_[part * plane_ + j * stride_];
      std::fill(column + j, column + stride_, 0.0);
    }
  }
  for (Index k = first; k < end; ++k) local_[k] = k - first;
  Index next = end - first;
  for (const Index k : nodes.rows(s)) local_[k] = next++;
  for (Index k = first; k < end; ++k) {
    const std::size_t c = Kind::kRows * (k - first);
    if constexpr (Kind::kRows == 2) {
      const glm::dmat2& d = diagonal_[k];
      *realPart(c, c) = d[0][0];
      *realPart(c + 1, c) = 0.5 * (d[0][1] + d[1][0]);
      *realPart(c + 1, c + 1) = d[1][1];
    } else {
      *realPart(c, c) = sizeOf(diagonal_[k]);
    }
    for (Index e = p.columnStart[k]; e < p.columnStart[k + 1]; ++e) {
      const std::size_t r = Kind::kRows * local_[p.row[e]];
      const Entry& entry = lower_[e];
      if constexpr (Kind::kRows == 2) {
        for (int j = 0; j < 2; ++j) {
          for (int i = 0; i < 2; ++i) {
            *realPart(r + static_cast<std::size_t>(i), c + static_cast<std::size_t>(j)) =
                entry[j][i];
          }
        }
      } else if constexpr (Kind::kParts == 2) {
        *realPart(r, c) = entry.real();
        realPart(r, c)[plane_] = entry.imag();
      } else {
        *realPart(r, c) = entry;
      }
    }
  }
}

/// Adds what the newest child on the stack leaves, and takes it off.
template <class Entry>
void SparseLdl<Entry>::takeChild(Index child) {
  const std::span<const Index> rows = pattern_.supernodes.rows(child);
  const std::size_t size = Kind::kRows * rows.size();
  const std::size_t begin = waitingEnd_ - Kind::kParts * size * size;
  for (std::size_t part = 0; part < Kind::kParts; ++part) {
    const double* from = &waiting_[begin + part * size * size];
    double* const plane = &front_[part * plane_];
    for (std::size_t c = 0; c < rows.size(); ++c) {
      for (std::size_t b = 0; b < Kind::kRows; ++b, from += size) {
        double* const column = plane + (Kind::kRows * local_[rows[c]] + b) * stride_;
        for (std::size_t r = c; r < rows.size(); ++r) {
          double* const to = column + Kind::kRows * local_[rows[r]];
          for (std::size_t i = 0; i < Kind::kRows; ++i) to[i] += from[Kind::kRows * r + i];
        }
      }
    }
  }
  waitingEnd_ = begin;
}

/// Copies the eliminated columns to the factor.
template <class Entry>
void SparseLdl<Entry>::keepColumns(Index s) {
  const std::size_t entries = Kind::kRows * pattern_.supernodes.columns(s) * stride_;
  for (std::size_t part = 0; part < Kind::kParts; ++part) {
    std::copy_n(&front_[part * plane_], entries, &factor_[panelBegin_[s] + part * entries]);
  }
}

/// Puts what a supernode leaves to others on the stack.
template <class Entry>
void SparseLdl<Entry>::passOn(Index s) {
  const std::size_t columns = Kind::kRows * pattern_.supernodes.columns(s);
  const std::size_t size = stride_ - columns;
  std::size_t to = waitingEnd_;
  waitingEnd_ += Kind::kParts * size * size;
  if (waiting_.size() < waitingEnd_) waiting_.resize(waitingEnd_);
  for (std::size_t part = 0; part < Kind::kParts; ++part) {
    for (std::size_t j = 0; j < size; ++j, to += size) {
      const double* const column = &front_[part * plane_ + (columns + j) * stride_ + columns];
      std::copy(column + j, column + size, &waiting_[to + j]);
    }
  }
  children_.push_back(s);
}

template <class Entry>
bool SparseLdl<Entry>::factor() {
  const Supernodes& nodes = pattern_.supernodes;
  waitingEnd_ = 0;
  children_.clear();
  for (Index s = 0; s < nodes.count(); ++s) {
    assemble(s);
    for (; !children_.empty() && nodes.parent[children_.back()] == s; children_.pop_back()) {
      takeChild(children_.back());
    }
    const DenseFront front{front_.get(), Kind::kParts == 2 ? front_.get() + plane_ : nullptr,
                           stride_, stride_};
    const std::size_t columns = Kind::kRows * nodes.columns(s);
    if (!eliminate(front, columns, &inverse_[Kind::kRows * nodes.first[s]])) return false;
    keepColumns(s);
    if (nodes.parent[s] != kNone) passOn(s);
  }
  return true;
}

template <class Entry>
void SparseLdl<Entry>::solve(std::span<glm::dvec2> x) {
  using Unknown = typename Kind::Unknown;
  const SparsePattern& p = pattern_;
  const Supernodes& nodes = p.supernodes;
  CF_CHECK(x.size() == p.size());
  std::vector<Unknown> all(Kind::kRows * p.size()), front;
  for (std::size_t v = 0; v < x.size(); ++v) {
    for (std::size_t i = 0; i < Kind::kRows; ++i) {
      all[Kind::kRows * p.place[v] + i] = Kind::get(x[v], i);
    }
  }
  const auto gather = [&](Index s) {
    front.clear();
    for (Index k = nodes.first[s]; k < nodes.first[s + 1]; ++k) {
      for (std::size_t i = 0; i < Kind::kRows; ++i) front.push_back(all[Kind::kRows * k + i]);
    }
    for (const Index k : nodes.rows(s)) {
      for (std::size_t i = 0; i < Kind::kRows; ++i) front.push_back(all[Kind::kRows * k + i]);
    }
  };
  for (Index s = 0; s < nodes.count(); ++s) {
    gather(s);
    const std::size_t columns = Kind::kRows * nodes.columns(s), size = front.size();
    const double* column = &factor_[panelBegin_[s]];
    const double* imaginary = Kind::kParts == 2 ? column + columns * size : column;
    for (std::size_t j = 0; j < columns; ++j, column += size, imaginary += size) {
      const Unknown y = front[j];
      for (std::size_t i = j + 1; i < size; ++i) subtract(front[i], column[i], imaginary[i], y);
    }
    std::copy_n(front.begin(), columns, &all[Kind::kRows * nodes.first[s]]);
    std::size_t from = columns;
    for (const Index k : nodes.rows(s)) {
      for (std::size_t i = 0; i < Kind::kRows; ++i) all[Kind::kRows * k + i] = front[from++];
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i] *= inverse_[i];
  for (Index s = static_cast<Index>(nodes.count()); s-- > 0;) {
    gather(s);
    const std::size_t columns = Kind::kRows * nodes.columns(s), size = front.size();
    for (std::size_t j = columns; j-- > 0;) {
      const double* const column = &factor_[panelBegin_[s] + j * size];
      const double* const imaginary = Kind::kParts == 2 ? column + columns * size : column;
      Unknown y = front[j];
      for (std::size_t i = j + 1; i < size; ++i) subtract(y, column[i], -imaginary[i], front[i]);
      front[j] = y;
    }
    std::copy_n(front.begin(), columns, &all[Kind::kRows * nodes.first[s]]);
  }
  for (std::size_t v = 0; v < x.size(); ++v) {
    for (std::size_t i = 0; i < Kind::kRows; ++i) {
      Kind::put(x[v], i, all[Kind::kRows * p.place[v] + i]);
    }
  }
}

template class SparseLdl<double>;
template class SparseLdl<std::complex<double>>;
template class SparseLdl<glm::dmat2>;

}  // namespace chartflood
