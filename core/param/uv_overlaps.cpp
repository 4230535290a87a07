#include "core/param/uv_overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/base/interruption.h"

namespace chartflood {

namespace {

constexpr std::size_t kMostGridCells = 1024;  // a side of the grid

struct UvBox {
  glm::dvec2 low, high;
};

UvBox boxOf(const PlaneTriangle& t) {
  return {glm::min(glm::min(t[0], t[1]), t[2]), glm::max(glm::max(t[0], t[1]), t[2])};
}

/// Least height; not above 0 for what cannot overlap.
double heightOf(const PlaneTriangle& t) {
  const glm::dvec2 a = t[1] - t[0], b = t[2] - t[0];
  const double area = std::abs(a.x * b.y - a.y * b.x);
  const double longest = std::max({glm::length(a), glm::length(b), glm::length(b - a)});
  const double height = area / longest;
  return std::isfinite(height) ? height : 0;
}

/// Whether a line along a side of `a` parts both, or they overlap by at most `least` across it.
bool parts(const PlaneTriangle& a, const PlaneTriangle& b, double least) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 side = a[(i + 1) % 3] - a[i];
    const glm::dvec2 across = glm::normalize(glm::dvec2(-side.y, side.x));
    const double height = glm::dot(a[(i + 2) % 3] - a[i], across);
    double low = glm::dot(b[0] - a[i], across), high = low;
    for (std::size_t k = 1; k < 3; ++k) {
      const double at = glm::dot(b[k] - a[i], across);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    if (std::min(high, std::max(height, 0.0)) - std::max(low, std::min(height, 0.0)) <= least) {
      return true;
    }
  }
  return false;
}

/// Cells of a box, both ends included.
class TriangleGrid {
 public:
  TriangleGrid(const UvBox& all, std::size_t triangles) : low_(all.low) {
    const double size = std::max(all.high.x - all.low.x, all.high.y - all.low.y);
    side_ = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles))), 1, kMostGridCells);
    perUnit_ = size > 0 ? static_cast<double>(side_) / size : 0;
  }
  std::size_t side() const { return side_; }
  std::size_t cell(double place, double low) const {
    const double at = std::floor((place - low) * perUnit_);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(side_ - 1)));
  }
  std::size_t column(const glm::dvec2& p) const { return cell(p.x, low_.x); }
  std::size_t row(const glm::dvec2& p) const { return cell(p.y, low_.y); }

  /// The cells that the triangle reaches into, row by row: long thin ones cross few of those in
  /// their box.
  template <typename Visit>
  void eachCell(const PlaneTriangle& t, Visit&& visit) const {
    const UvBox box = boxOf(t);
    for (std::size_t y = row(box.low); y <= row(box.high); ++y) {
      const auto [left, right] = reach(t, y);
      for (std::size_t x = cell(left, low_.x); x <= cell(right, low_.x); ++x) visit(y * side_ + x);
    }
  }

 private:
  /// How far the triangle goes to the left and right within a row of cells. Rounding must leave no
  /// cell out: the row is taken a little higher than it is.
  std::pair<double, double> reach(const PlaneTriangle& t, std::size_t y) const {
    constexpr double kSlack = 1e-6;
    const double height = perUnit_ > 0 ? 1 / perUnit_ : 0;
    const double low = low_.y + (static_cast<double>(y) - kSlack) * height;
    const double high = low_.y + (static_cast<double>(y + 1) + kSlack) * height;
    // Beyond the first and last row there are none.
    const double bottom = y == 0 ? -1e300 : low, top = y + 1 == side_ ? 1e300 : high;
    double left = 1e300, right = -1e300;
    const auto add = [&](double x) {
      left = std::min(left, x);
      right = std::max(right, x);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec2 &a = t[i], &b = t[(i + 1) % 3];
      if (a.y >= bottom && a.y <= top) add(a.x);
      for (const double line : {bottom, top}) {
        if ((a.y < line) != (b.y < line)) add(a.x + (b.x - a.x) * ((line - a.y) / (b.y - a.y)));
      }
    }
    return {left - kSlack * height, right + kSlack * height};
  }

  glm::dvec2 low_;
  double perUnit_ = 0;
  std::size_t side_ = 1;
};

}  // namespace

std::vector<bool> findOverlaps(std::span<const PlaneTriangle> triangles, double least) {
  std::vector<bool> found(triangles.size(), false);
  std::vector<Index> thick;
  UvBox all{glm::dvec2(1e300), glm::dvec2(-1e300)};
  for (Index t = 0; t < triangles.size(); ++t) {
    if (!(heightOf(triangles[t]) > least)) continue;
    thick.push_back(t);
    const UvBox box = boxOf(triangles[t]);
    all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  }
  if (thick.size() < 2) return found;
  const TriangleGrid grid(all, thick.size());
  // Triangles of each cell, cell after cell.
  std::vector<std::size_t> first(grid.side() * grid.side() + 1, 0);
  for (const Index t : thick) {
    grid.eachCell(triangles[t], [&](std::size_t cell) { ++first[cell + 1]; });
  }
  for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
  std::vector<Index> held(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const Index t : thick) {
    grid.eachCell(triangles[t], [&](std::size_t cell) { held[next[cell]++] = t; });
  }
  for (std::size_t cell = 0; cell + 1 < first.size(); ++cell) {
    throwIfInterrupted();
    for (std::size_t i = first[cell]; i < first[cell + 1]; ++i) {
      for (std::size_t k = i + 1; k < first[cell + 1]; ++k) {
        const Index a = held[i], b = held[k];
        if (found[a] && found[b]) continue;
        if (parts(triangles[a], triangles[b], least)) continue;
        if (parts(triangles[b], triangles[a], least)) continue;
        found[a] = found[b] = true;
      }
    }
  }
  return found;
}

}  // namespace chartflood
