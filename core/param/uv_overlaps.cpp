#include "core/param/uv_overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/index.h"

namespace chartflood {

namespace {

constexpr std::size_t kMostCells = 1024;  // a side of the grid

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
        static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles))), 1, kMostCells);
    perUnit_ = size > 0 ? static_cast<double>(side_) / size : 0;
  }
  std::size_t side() const { return side_; }
  std::size_t cell(double place, double low) const {
    const double at = std::floor((place - low) * perUnit_);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(side_ - 1)));
  }
  std::size_t column(const glm::dvec2& p) const { return cell(p.x, low_.x); }
  std::size_t row(const glm::dvec2& p) const { return cell(p.y, low_.y); }

  template <typename Visit>
  void eachCell(const UvBox& box, Visit&& visit) const {
    for (std::size_t y = row(box.low); y <= row(box.high); ++y) {
      for (std::size_t x = column(box.low); x <= column(box.high); ++x) visit(y * side_ + x);
    }
  }

 private:
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
    grid.eachCell(boxOf(triangles[t]), [&](std::size_t cell) { ++first[cell + 1]; });
  }
  for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
  std::vector<Index> held(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const Index t : thick) {
    grid.eachCell(boxOf(triangles[t]), [&](std::size_t cell) { held[next[cell]++] = t; });
  }
  for (std::size_t cell = 0; cell + 1 < first.size(); ++cell) {
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
