#include "core/param/border_crossings.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace chartflood {

namespace {

constexpr double kDeep = 1e-5;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 edge = b - a;
  const double squared = glm::dot(edge, edge);
  const double along = squared > 0 ? std::clamp(glm::dot(p - a, edge) / squared, 0.0, 1.0) : 0;
  return glm::distance(p, a + along * edge);
}

/// Square cells over the boundary, each with the segments whose box it meets.
class SegmentGrid {
 public:
  SegmentGrid(std::span<const Index> loop, std::span<const glm::dvec2> uv) : loop_(loop), uv_(uv) {
    low_ = glm::dvec2(uv[loop[0]]);
    glm::dvec2 high = low_;
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      low_ = glm::min(low_, start(i));
      high = glm::max(high, start(i));
      length += glm::distance(start(i), end(i));
    }
    const glm::dvec2 size = high - low_;
    const double count = static_cast<double>(loop.size());
    cell_ = std::max({length / count, std::sqrt(size.x * size.y / (2 * count)),
                      std::max(size.x, size.y) / (2 * count)});
    if (!(cell_ > 0) || !std::isfinite(cell_)) cell_ = 1;
    columns_ = static_cast<std::size_t>(size.x / cell_) + 1;
    rows_ = static_cast<std::size_t>(size.y / cell_) + 1;
    fill();
  }

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const Index> cell(std::size_t i) const {
    return std::span(segments_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
  }
  const glm::dvec2& start(std::size_t i) const { return uv_[loop_[i]]; }
  const glm::dvec2& end(std::size_t i) const {
    return uv_[loop_[i + 1 == loop_.size() ? 0 : i + 1]];
  }

 private:
  template <class Visit>
  void visitCells(std::size_t i, const Visit& visit) const {
    const glm::dvec2 a = (glm::min(start(i), end(i)) - low_) / cell_;
    const glm::dvec2 b = (glm::max(start(i), end(i)) - low_) / cell_;
    const std::size_t x1 = std::min(static_cast<std::size_t>(b.x), columns_ - 1);
    const std::size_t y1 = std::min(static_cast<std::size_t>(b.y), rows_ - 1);
    for (auto y = static_cast<std::size_t>(a.y); y <= y1; ++y) {
      for (auto x = static_cast<std::size_t>(a.x); x <= x1; ++x) visit(y * columns_ + x);
    }
  }

  void fill() {
    begin_.assign(columns_ * rows_ + 1, 0);
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      visitCells(i, [&](std::size_t cell) { ++begin_[cell + 1]; });
    }
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    segments_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      visitCells(i, [&](std::size_t cell) { segments_[next[cell]++] = static_cast<Index>(i); });
    }
  }

  std::span<const Index> loop_;
  std::span<const glm::dvec2> uv_;
  glm::dvec2 low_{0};
  double cell_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::size_t> begin_;
  std::vector<Index> segments_;
};

}  // namespace

bool segmentsCross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                   const glm::dvec2& d, Contact contact) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc * abd > 0 || cda * cdb > 0) return false;
  if (contact == Contact::Any) {
    // On one line they may still be apart.
    if (abc != 0 || abd != 0) return true;
    return glm::all(glm::lessThanEqual(glm::max(glm::min(a, b), glm::min(c, d)),
                                       glm::min(glm::max(a, b), glm::max(c, d))));
  }
  const double least = kDeep * glm::distance(a, b) * glm::distance(c, d);
  return std::min({std::abs(abc), std::abs(abd), std::abs(cda), std::abs(cdb)}) > least;
}

bool findCrossings(std::span<const Index> loop, std::span<const glm::dvec2> uv, Contact contact,
                   std::vector<bool>& crossing) {
  crossing.assign(loop.size(), false);
  if (loop.size() < 4) return false;
  const SegmentGrid grid(loop, uv);
  bool any = false;
  for (std::size_t c = 0; c < grid.size(); ++c) {
    const auto cell = grid.cell(c);
    for (std::size_t i = 0; i < cell.size(); ++i) {
      for (std::size_t j = i + 1; j < cell.size(); ++j) {
        const Index a = cell[i], b = cell[j];  // ascending
        if (b - a == 1 || (a == 0 && b + 1 == loop.size())) continue;
        if (!segmentsCross(grid.start(a), grid.end(a), grid.start(b), grid.end(b), contact))
          continue;
        crossing[a] = crossing[b] = any = true;
      }
    }
  }
  return any;
}

bool findTouches(std::span<const Index> loop, std::span<const glm::dvec2> uv, double share,
                 std::span<const double> room, std::vector<bool>& touching) {
  const std::size_t n = loop.size();
  std::vector<bool> crossing;
  touching.assign(n, false);
  bool any = findCrossings(loop, uv, Contact::Any, crossing);
  for (std::size_t i = 0; i < n; ++i) {
    if (crossing[i]) touching[i] = touching[i + 1 == n ? 0 : i + 1] = true;
  }
  if (n < 4) return any;
  const SegmentGrid grid(loop, uv);
  const auto length = [&](std::size_t i) { return glm::distance(grid.start(i), grid.end(i)); };
  const auto test = [&](std::size_t vertex, std::size_t segment) {
    const std::size_t before = vertex == 0 ? n - 1 : vertex - 1;
    if (segment == vertex || segment == before || touching[vertex]) return;
    double size = std::min(length(vertex), length(before));
    if (!room.empty()) size = std::min(size, room[vertex]);
    const double least = share * size;
    if (distanceToSegment(grid.start(vertex), grid.start(segment), grid.end(segment)) < least) {
      touching[vertex] = any = true;
    }
  };
  // What is within a small share of a segment's length of another almost always shares a cell with
  // it; what does not is found when it comes nearer in a later pass.
  for (std::size_t c = 0; c < grid.size(); ++c) {
    for (const Index a : grid.cell(c)) {
      for (const Index b : grid.cell(c)) {
        test(a, b);
        test(a + 1 == n ? 0 : a + 1, b);
      }
    }
  }
  return any;
}

}  // namespace chartflood
