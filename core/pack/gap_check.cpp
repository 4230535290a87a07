#include "core/pack/gap_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace chartflood {

namespace {

using Point = glm::dvec2;

/// Shrinking where it is not known how much helps.
constexpr double kTry = 0.01;

double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
double largerAxis(const Point& d) { return std::max(std::abs(d.x), std::abs(d.y)); }

/// The way from a point to the nearest point of a segment in the norm of the larger axis.
Point wayToSegment(const Point& p, const Segment2& s) {
  const Point a = s[0] - p, d = s[1] - s[0];
  Point best = a;
  const auto offer = [&](double t) {
    const Point way = a + std::clamp(t, 0.0, 1.0) * d;
    if (largerAxis(way) < largerAxis(best)) best = way;
  };
  offer(1);
  // The larger axis changes where both are equal.
  if (d.x != d.y) offer((a.y - a.x) / (d.x - d.y));
  if (d.x != -d.y) offer(-(a.x + a.y) / (d.x + d.y));
  return best;
}

bool crossing(const Segment2& s, const Segment2& t) {
  const double a = cross(s[1] - s[0], t[0] - s[0]), b = cross(s[1] - s[0], t[1] - s[0]);
  const double c = cross(t[1] - t[0], s[0] - t[0]), d = cross(t[1] - t[0], s[1] - t[0]);
  return ((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && d < 0) || (c < 0 && d > 0));
}

/// All outlines in the texture at one scale, and a grid over their segments.
class PlacedSegments {
 public:
  PlacedSegments(std::span<const PlacedOutline> charts, const PackGaps& gaps, double scale)
      : charts_(charts), gap_(gaps.between), border_(gaps.border) {
    begin_.push_back(0);
    for (std::size_t k = 0; k < charts.size(); ++k) {
      const PlacedOutline& chart = charts[k];
      const double c = scale * std::cos(chart.pose.angle), s = scale * std::sin(chart.pose.angle);
      const auto place = [&](const Point& p) {
        const Point q = p - chart.center;
        return Point(chart.pose.x + c * q.x - s * q.y, chart.pose.y + s * q.x + c * q.y);
      };
      for (const Segment2& segment : chart.outline->segments) {
        segments_.push_back({place(segment[0]), place(segment[1])});
        chartOf_.push_back(k);
      }
      begin_.push_back(segments_.size());
    }
    makeGrid();
  }

  /// Share by which the charts must shrink, as far as their closest points tell; 0: all is well.
  double neededShrink() {
    double shrink = 0;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      shrink = std::max(shrink, borderShrink(i));
      forCells(segments_[i], gap_, [&](std::size_t cell) {
        for (std::size_t k = cellBegin_[cell]; k < cellBegin_[cell + 1]; ++k) {
          if (chartOf_[inCell_[k]] > chartOf_[i]) {
            shrink = std::max(shrink, pairShrink(i, inCell_[k]));
          }
        }
      });
    }
    return shrink > 0 || !anyInside() ? shrink : kTry;
  }

 private:
  void makeGrid() {
    const double wanted = std::max(gap_, 1.0 / 256);
    cells_ = std::max(1, static_cast<int>(1 / wanted));
    const std::size_t count = static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_);
    cellBegin_.assign(count + 1, 0);
    for (const Segment2& segment : segments_) {
      forCells(segment, 0, [&](std::size_t cell) { ++cellBegin_[cell + 1]; });
    }
    for (std::size_t c = 0; c < count; ++c) cellBegin_[c + 1] += cellBegin_[c];
    inCell_.resize(cellBegin_.back());
    std::vector<std::size_t> next(cellBegin_.begin(), cellBegin_.end() - 1);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      forCells(segments_[i], 0, [&](std::size_t cell) { inCell_[next[cell]++] = i; });
    }
  }
  int cellOf(double v) const {
    return std::clamp(static_cast<int>(std::floor(v * cells_)), 0, cells_ - 1);
  }
  /// Calls `visit` for the cells within `around` of the segment, row by row.
  template <class Visit>
  void forCells(const Segment2& segment, double around, const Visit& visit) const {
    const bool up = segment[0].y <= segment[1].y;
    const Point& low = up ? segment[0] : segment[1];
    const Point& high = up ? segment[1] : segment[0];
    const int j0 = cellOf(low.y - around), j1 = cellOf(high.y + around);
    for (int j = j0; j <= j1; ++j) {
      // Part of the segment within reach of the row, from end to end.
      const double bottom = (j == 0 ? -INFINITY : static_cast<double>(j) / cells_) - around;
      const double top = (j == cells_ - 1 ? INFINITY : (j + 1.0) / cells_) + around;
      double x0 = low.x, x1 = high.x;
      if (high.y > low.y) {
        const double t0 = std::clamp((bottom - low.y) / (high.y - low.y), 0.0, 1.0);
        const double t1 = std::clamp((top - low.y) / (high.y - low.y), 0.0, 1.0);
        x0 = low.x + t0 * (high.x - low.x), x1 = low.x + t1 * (high.x - low.x);
      }
      constexpr double kRounding = 1e-9;
      const int i0 = cellOf(std::min(x0, x1) - around - kRounding);
      const int i1 = cellOf(std::max(x0, x1) + around + kRounding);
      for (int i = i0; i <= i1; ++i) {
        visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(cells_) +
              static_cast<std::size_t>(i));
      }
    }
  }
  double borderShrink(std::size_t i) const {
    const Pose& pose = charts_[chartOf_[i]].pose;
    const Point& p = segments_[i][0];
    double shrink = 0;
    for (const auto& [at, center] : {std::pair(p.x, pose.x), std::pair(p.y, pose.y)}) {
      const double outside = std::max(border_ - at, at - (1 - border_));
      if (outside <= 0) continue;
      const double arm = std::abs(at - center);
      shrink = std::max(shrink, arm > outside ? outside / arm : 0.5);
    }
    return shrink;
  }
  double pairShrink(std::size_t i, std::size_t j) const {
    const Segment2 &s = segments_[i], &t = segments_[j];
    if (std::min(t[0].x, t[1].x) - std::max(s[0].x, s[1].x) >= gap_ ||
        std::min(s[0].x, s[1].x) - std::max(t[0].x, t[1].x) >= gap_ ||
        std::min(t[0].y, t[1].y) - std::max(s[0].y, s[1].y) >= gap_ ||
        std::min(s[0].y, s[1].y) - std::max(t[0].y, t[1].y) >= gap_) {
      return 0;
    }
    if (crossing(s, t)) return kTry;
    double shrink = 0;
    for (int end = 0; end < 2; ++end) {
      shrink = std::max(shrink, wayShrink(i, s[end], j, wayToSegment(s[end], t)));
      shrink = std::max(shrink, wayShrink(j, t[end], i, wayToSegment(t[end], s)));
    }
    return shrink;
  }
  /// Shrinking that makes the way from point `p` of segment i to segment j long enough along one
  /// of the axes.
  double wayShrink(std::size_t i, const Point& p, std::size_t j, const Point& way) const {
    if (largerAxis(way) >= gap_) return 0;
    // Where the charts interlock, shrinking does not part them at this place: try a little.
    double shrink = kTry;
    const Pose &a = charts_[chartOf_[i]].pose, &b = charts_[chartOf_[j]].pose;
    const Point arm = (p - Point(a.x, a.y)) - (p + way - Point(b.x, b.y));
    for (const auto& [length, gain] : {std::pair(way.x, arm.x), std::pair(way.y, arm.y)}) {
      const double missing = gap_ - std::abs(length);
      const double gained = length < 0 ? -gain : gain;
      if (gained * kTry > missing) shrink = std::min(shrink, missing / gained);
    }
    return shrink;
  }
  /// A chart inside another touches it nowhere: look at one point of each.
  bool anyInside() const {
    for (std::size_t a = 0; a < charts_.size(); ++a) {
      if (begin_[a] == begin_[a + 1]) continue;
      const Point& p = segments_[begin_[a]][0];
      for (std::size_t b = 0; b < charts_.size(); ++b) {
        if (a != b && winding(p, b) != 0) return true;
      }
    }
    return false;
  }
  int winding(const Point& p, std::size_t chart) const {
    int turns = 0;
    for (std::size_t i = begin_[chart]; i < begin_[chart + 1]; ++i) {
      const auto& [a, b] = segments_[i];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const double side = cross(b - a, p - a);
      if (a.y <= p.y && side > 0) ++turns;
      if (a.y > p.y && side < 0) --turns;
    }
    return turns;
  }

  std::span<const PlacedOutline> charts_;
  double gap_, border_;
  std::vector<Segment2> segments_;
  std::vector<std::size_t> chartOf_, begin_;
  int cells_ = 1;
  std::vector<std::size_t> cellBegin_, inCell_;
};

}  // namespace

double largestScale(std::span<const PlacedOutline> charts, const PackGaps& gaps, double largest) {
  constexpr int kTries = 60;
  double scale = largest;
 
  for (int i = 0; i < kTries; ++i) {
    const double shrink = PlacedSegments(charts, gaps, scale).neededShrink();
    if (getenv("VERB")) printf("try %d scale %g shrink %g\n", i, scale, shrink);
    if (shrink == 0) return scale;
    scale *= 1 - 1.0001 * shrink - 1e-9;
  }
  return 0;
}

}  // namespace chartflood
