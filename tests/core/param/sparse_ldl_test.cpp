// Sparse factorisations of a chart's systems: core/param/sparse_ldl, supernodes, dense_front.

#include <algorithm>
#include <complex>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/param/dense_front.h"
#include "core/param/sparse_ldl.h"

namespace chartflood {
namespace {

using Complex = std::complex<double>;
using Triangles = std::vector<std::array<Index, 3>>;

double unit(Rng& rng) { return 2.0 * rng.below(1u << 20) / (1u << 20) - 1; }

/// A grid of n x n vertices in random order, and a few vertices that no triangle has.
struct Grid {
  Triangles triangles;
  std::size_t vertices;

  Grid(Index n, std::uint32_t seed) : vertices(n * n + 3) {
    std::vector<Index> name(vertices);
    for (Index v = 0; v < vertices; ++v) name[v] = v;
    Rng rng(seed);
    for (Index v = static_cast<Index>(vertices); v > 1; --v)
      std::swap(name[v - 1], name[rng.below(v)]);
    for (Index y = 0; y + 1 < n; ++y) {
      for (Index x = 0; x + 1 < n; ++x) {
        const Index a = name[y * n + x], b = name[y * n + x + 1], c = name[(y + 1) * n + x],
                    d = name[(y + 1) * n + x + 1];
        triangles.push_back({a, b, c});
        triangles.push_back({b, d, c});
      }
    }
  }
};

double random(Rng& rng, double) { return unit(rng); }
Complex random(Rng& rng, Complex) { return {unit(rng), unit(rng)}; }
glm::dmat2 random(Rng& rng, const glm::dmat2&) {
  return {unit(rng), unit(rng), unit(rng), unit(rng)};
}
double adjoint(double a) { return a; }
Complex adjoint(Complex a) { return std::conj(a); }
glm::dmat2 adjoint(const glm::dmat2& a) { return glm::transpose(a); }
glm::dvec2 product(double a, const glm::dvec2& x) { return a * x; }
glm::dvec2 product(const Complex& a, const glm::dvec2& x) {
  return {a.real() * x.x - a.imag() * x.y, a.real() * x.y + a.imag() * x.x};
}
glm::dvec2 product(const glm::dmat2& a, const glm::dvec2& x) { return a * x; }

template <class Entry>
class SparseLdlOf : public testing::Test {};
using Entries = testing::Types<double, Complex, glm::dmat2>;
TYPED_TEST_SUITE(SparseLdlOf, Entries);

/// A random matrix with heavy diagonals, and what it makes of a vector.
template <class Entry>
struct System {
  Grid grid;
  SparsePattern pattern;
  SparseLdl<Entry> ldl;
  std::vector<Entry> diagonal, side;

  System(Index n, std::uint32_t seed)
      : grid(n, seed), pattern(grid.triangles, grid.vertices), ldl(pattern) {
    Rng rng(seed);
    diagonal.assign(grid.vertices, Entry(14));
    for (std::size_t s = 0; s < 3 * grid.triangles.size(); ++s)
      side.push_back(random(rng, Entry()));
  }
  void fill() {
    ldl.clear();
    for (Index v = 0; v < grid.vertices; ++v) ldl.addDiagonal(v, diagonal[v]);
    for (Index s = 0; s < side.size(); ++s) ldl.addSide(s, side[s]);
  }
  std::vector<glm::dvec2> times(const std::vector<glm::dvec2>& x) const {
    std::vector<glm::dvec2> y(x.size());
    for (std::size_t v = 0; v < x.size(); ++v) y[v] = product(diagonal[v], x[v]);
    for (std::size_t s = 0; s < side.size(); ++s) {
      const auto& t = grid.triangles[s / 3];
      const Index a = t[s % 3], b = t[s % 3 == 2 ? 0 : s % 3 + 1];
      y[a] += product(side[s], x[b]);
      y[b] += product(adjoint(side[s]), x[a]);
    }
    return y;
  }
};

std::vector<glm::dvec2> randomPlaces(std::size_t count) {
  Rng rng(99);
  std::vector<glm::dvec2> x;
  for (std::size_t v = 0; v < count; ++v) x.emplace_back(unit(rng), unit(rng));
  return x;
}

TYPED_TEST(SparseLdlOf, SolvesWhatWasMultiplied) {
  for (const Index n : {2u, 3u, 9u, 31u, 60u}) {
    System<TypeParam> system(n, n);
    for (int again = 0; again < 2; ++again) {  // filled anew, on the same storage
      system.fill();
      ASSERT_TRUE(system.ldl.factor()) << n;
      const std::vector<glm::dvec2> wanted = randomPlaces(system.grid.vertices);
      std::vector<glm::dvec2> x = system.times(wanted);
      system.ldl.solve(x);
      double error = 0;
      for (std::size_t v = 0; v < x.size(); ++v) {
        error = std::max(error, glm::distance(x[v], wanted[v]));
      }
      EXPECT_LT(error, 1e-12) << n;
      system.side[0] += TypeParam(0.5);
    }
  }
}

TYPED_TEST(SparseLdlOf, FixedVerticesKeepTheirPlacesAndPullNobody) {
  System<TypeParam> system(12, 4);
  system.fill();
  std::vector<bool> fixed(system.grid.vertices, false);
  for (std::size_t v = 0; v < fixed.size(); v += 5) fixed[v] = true;
  system.ldl.fix(fixed);
  ASSERT_TRUE(system.ldl.factor());
  const std::vector<glm::dvec2> wanted = randomPlaces(fixed.size());
  std::vector<glm::dvec2> free = wanted;
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) free[v] = {0, 0};
  }
  std::vector<glm::dvec2> x = system.times(free);
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) x[v] = wanted[v];
  }
  system.ldl.solve(x);
  for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT(glm::distance(x[v], wanted[v]), 1e-12);
}

TYPED_TEST(SparseLdlOf, SaysWhenAMatrixIsNotPositive) {
  System<TypeParam> system(8, 2);
  system.diagonal[17] = TypeParam(-1);
  system.fill();
  EXPECT_FALSE(system.ldl.factor());
  system.diagonal[17] = TypeParam(14);
  system.fill();
  EXPECT_TRUE(system.ldl.factor());
}

TEST(Supernodes, HoldEveryColumnOnceAfterThoseThatNeedIt) {
  for (const Index n : {2u, 7u, 40u}) {
    const Grid grid(n, 3);
    const SparsePattern pattern(grid.triangles, grid.vertices);
    const Supernodes& nodes = pattern.supernodes;
    EXPECT_EQ(nodes.first.front(), 0u);
    EXPECT_EQ(nodes.first.back(), grid.vertices);
    EXPECT_LT(nodes.count(), grid.vertices);
    for (Index s = 0; s < nodes.count(); ++s) {
      EXPECT_GT(nodes.columns(s), 0u);
      const auto rows = nodes.rows(s);
      EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
      if (rows.empty()) {
        EXPECT_EQ(nodes.parent[s], kNone);
        continue;
      }
      EXPECT_GE(rows.front(), nodes.first[s + 1]);
      const Index parent = nodes.parent[s];
      EXPECT_GT(parent, s);
      for (const Index row : rows) {  // the parent's front has a place for each
        const bool own = row >= nodes.first[parent] && row < nodes.first[parent + 1];
        const auto below = nodes.rows(parent);
        EXPECT_TRUE(own || std::binary_search(below.begin(), below.end(), row));
      }
    }
  }
}

/// L D L^H of the first columns and the rest make the matrix again, at sizes that fill lanes and
/// panels and that do not.
TEST(DenseFront, FactorsMultipliedGiveTheMatrixAgain) {
  for (const bool hasImaginary : {false, true}) {
    for (const std::size_t size : {1u, 2u, 5u, 8u, 33u, 70u, 101u}) {
      for (const std::size_t columns : {std::size_t{1}, size / 2, size}) {
        if (columns == 0) continue;
        Rng rng(static_cast<std::uint32_t>(size));
        std::vector<Complex> matrix(size * size);
        for (std::size_t j = 0; j < size; ++j) {
          matrix[j * size + j] = 2.0 * static_cast<double>(size);
          for (std::size_t i = j + 1; i < size; ++i) {
            matrix[j * size + i] = {unit(rng), hasImaginary ? unit(rng) : 0};
          }
        }
        std::vector<double> re, im, inverse(columns);
        for (const Complex& entry : matrix) re.push_back(entry.real()), im.push_back(entry.imag());
        ASSERT_TRUE(eliminate({re.data(), hasImaginary ? im.data() : nullptr, size, size}, columns,
                              inverse.data()));
        const auto factor = [&](std::size_t i, std::size_t j) {
          return i == j  ? Complex(1)
                 : i < j ? Complex(0)
                         : Complex(re[j * size + i], im[j * size + i]);
        };
        for (std::size_t j = 0; j < size; ++j) {
          for (std::size_t i = j; i < size; ++i) {
            Complex sum = j < columns ? Complex(0) : Complex(re[j * size + i], im[j * size + i]);
            for (std::size_t q = 0; q < columns; ++q) {
              sum += factor(i, q) / inverse[q] * std::conj(factor(j, q));
            }
            EXPECT_LT(std::abs(sum - matrix[j * size + i]), 1e-11 * static_cast<double>(size))
                << size << ' ' << columns << ' ' << i << ' ' << j;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace chartflood
