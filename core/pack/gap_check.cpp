#include "core/pack/gap_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/cross.h"

namespace chartflood {

namespace {

using Point = glm::dvec2;

/// How far charts that overlap are pushed at once, texture units.
constexpr double kOverlapPush = 0.002;

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

/// Pairs of segments are looked for this much farther apart than the gap, texture units: they stay
/// known until two charts have come closer by as much.
constexpr double kSlack = 0.002;

/// All outlines in the texture, and the pairs of their segments that are near each other.
class PlacedSegments {
 public:
  PlacedSegments(std::span<const PlacedOutline> charts, const PackGaps& gaps)
      : charts_(charts), gap_(gaps.between), border_(gaps.border), radius_(charts.size(), 0),
        boxes_(charts.size()) {
    begin_.push_back(0);
    for (std::size_t k = 0; k < charts.size(); ++k) {
      for (const Segment2& segment : charts[k].outline->segments) {
        const Point d = segment[0] - charts[k].center;
        radius_[k] = std::max(radius_[k], std::hypot(d.x, d.y));
        chartOf_.push_back(k);
      }
      begin_.push_back(chartOf_.size());
    }
    segments_.resize(chartOf_.size());
  }

  /// Places the outlines where the charts are now and finds what is missing between them.
  /// \param apart charts that overlap part as wholes, not border by border
  void measure(double scale, bool apart) {
    apart_ = apart;
    place(scale);
    if (!pairsHold(scale)) findPairs(scale);
    contacts_.clear();
    for (const auto& [i, j] : pairs_) measurePair(i, j);
    for (std::size_t k = 0; k < charts_.size(); ++k) {
      if (boxes_[k].withinBorder(border_)) continue;
      for (std::size_t i = begin_[k]; i < begin_[k + 1]; ++i) measureBorder(i);
    }
    if (contacts_.empty()) measureInside();
  }

  /// A place where two charts, or a chart and the border, are too close.
  struct Contact {
    std::size_t first, second;  ///< charts; `second` == number of charts: the border
    double missing;
    Point push;  ///< of the first chart, with the length that is missing
  };
  std::span<const Contact> contacts() const { return contacts_; }

  /// Of each contact the smaller chart, every chart once.
  std::vector<std::size_t> stuck() const {
    std::vector<std::size_t> charts;
    for (const auto& [first, second, missing, push] : contacts_) {
      const bool other =
          second < charts_.size() && charts_[second].outline->area < charts_[first].outline->area;
      charts.push_back(other ? second : first);
    }
    std::sort(charts.begin(), charts.end());
    charts.erase(std::unique(charts.begin(), charts.end()), charts.end());
    return charts;
  }

  /// How far each chart should move. A pair of charts parts by the largest push each way, so that
  /// one that sticks between two arms of the other comes to rest in the middle.
  /// \return the most that is missing anywhere
  double pushes(std::vector<Point>& move) const {
    // A little more than is missing, so that steps come to an end.
    constexpr double kSpare = 2e-5;
    std::fill(move.begin(), move.end(), Point(0));
    double most = 0;
    for (std::size_t k = 0; k < contacts_.size();) {
      const std::size_t first = contacts_[k].first, second = contacts_[k].second;
      Point low(0), high(0);
      for (; k < contacts_.size() && contacts_[k].first == first && contacts_[k].second == second;
           ++k) {
        const Contact& contact = contacts_[k];
        const Point wished = contact.push * (1 + kSpare / contact.missing);
        low = {std::min(low.x, wished.x), std::min(low.y, wished.y)};
        high = {std::max(high.x, wished.x), std::max(high.y, wished.y)};
        most = std::max(most, contact.missing);
      }
      const bool border = second == charts_.size();
      move[first] += (low + high) * (border ? 1.0 : 0.5);
      if (!border) move[second] -= (low + high) * 0.5;
    }
    return most;
  }

 private:
  struct Box {
    Point low, high;
    bool withinBorder(double border) const {
      return low.x >= border && low.y >= border && high.x <= 1 - border && high.y <= 1 - border;
    }
    bool holds(const Point& p) const {
      return p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y;
    }
  };

  void place(double scale) {
    for (std::size_t k = 0; k < charts_.size(); ++k) {
      const PlacedOutline& chart = charts_[k];
      const double c = scale * std::cos(chart.pose.angle), s = scale * std::sin(chart.pose.angle);
      const Point middle(chart.pose.x, chart.pose.y);
      const auto at = [&](const Point& p) {
        const Point q = p - chart.center;
        return middle + Point(c * q.x - s * q.y, s * q.x + c * q.y);
      };
      Point low(INFINITY), high(-INFINITY);
      for (std::size_t i = begin_[k]; i < begin_[k + 1]; ++i) {
        const Segment2& segment = chart.outline->segments[i - begin_[k]];
        segments_[i] = {at(segment[0]), at(segment[1])};
        low = glm::min(low, segments_[i][0]), high = glm::max(high, segments_[i][0]);
      }
      boxes_[k] = {low, high};
    }
  }
  bool pairsHold(double scale) const {
    if (pairedAt_.empty()) return false;
    for (std::size_t k = 0; k < charts_.size(); ++k) {
      const Pose &now = charts_[k].pose, &then = pairedAt_[k];
      const double moved = std::max(std::abs(now.x - then.x), std::abs(now.y - then.y)) +
                           radius_[k] * std::abs(scale - pairedScale_);
      if (moved > kSlack / 2) return false;
    }
    return true;
  }
  void findPairs(double scale) {
    makeGrid();
    pairs_.clear();
    const double reach = gap_ + kSlack;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      forCells(segments_[i], reach, [&](std::size_t cell) {
        for (std::size_t k = cellBegin_[cell]; k < cellBegin_[cell + 1]; ++k) {
          if (chartOf_[inCell_[k]] > chartOf_[i] && near(i, inCell_[k], reach)) {
            pairs_.emplace_back(i, inCell_[k]);
          }
        }
      });
    }
    std::sort(pairs_.begin(), pairs_.end(), [&](const auto& a, const auto& b) {
      const auto key = [&](const auto& p) {
        return std::array{chartOf_[p.first], chartOf_[p.second], p.first, p.second};
      };
      return key(a) < key(b);
    });
    // A long segment and another share several cells.
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    pairedAt_.clear();
    for (const PlacedOutline& chart : charts_) pairedAt_.push_back(chart.pose);
    pairedScale_ = scale;
  }
  void makeGrid() {
    // As many cells as segments.
    const double wanted = std::sqrt(static_cast<double>(segments_.size()));
    cells_ = static_cast<int>(std::clamp(wanted, 1.0, 1 / (gap_ + kSlack)));
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
  /// Whether the boxes of two segments are less than `reach` apart along both axes.
  bool near(std::size_t i, std::size_t j, double reach) const {
    const Segment2 &s = segments_[i], &t = segments_[j];
    return std::min(t[0].x, t[1].x) - std::max(s[0].x, s[1].x) < reach &&
           std::min(s[0].x, s[1].x) - std::max(t[0].x, t[1].x) < reach &&
           std::min(t[0].y, t[1].y) - std::max(s[0].y, s[1].y) < reach &&
           std::min(s[0].y, s[1].y) - std::max(t[0].y, t[1].y) < reach;
  }
  void measureBorder(std::size_t i) {
    const Point& p = segments_[i][0];
    Point push(0);
    for (int axis = 0; axis < 2; ++axis) {
      push[axis] = std::max(border_ - p[axis], 0.0) - std::max(p[axis] - (1 - border_), 0.0);
    }
    if (push.x != 0)
      contacts_.push_back({chartOf_[i], charts_.size(), std::abs(push.x), {push.x, 0}});
    if (push.y != 0)
      contacts_.push_back({chartOf_[i], charts_.size(), std::abs(push.y), {0, push.y}});
  }
  void measurePair(std::size_t i, std::size_t j) {
    const Segment2 &s = segments_[i], &t = segments_[j];
    if (!near(i, j, gap_)) return;
    if (crossing(s, t)) return addCrossing(i, j);
    Point way = wayToSegment(s[0], t);
    const auto offer = [&way](const Point& other) {
      if (largerAxis(other) < largerAxis(way)) way = other;
    };
    offer(wayToSegment(s[1], t));
    offer(-wayToSegment(t[0], s));
    offer(-wayToSegment(t[1], s));
    const double length = largerAxis(way);
    if (length >= gap_) return;
    const int axis = std::abs(way.x) >= std::abs(way.y) ? 0 : 1;
    Point push(0);
    push[axis] = way[axis] < 0 ? gap_ - length : length - gap_;
    contacts_.push_back({chartOf_[i], chartOf_[j], gap_ - length, push});
  }
  /// Borders that cross part across the border that is less deep in the other chart.
  void addCrossing(std::size_t i, std::size_t j) {
    if (apart_) return addOverlap(chartOf_[i], chartOf_[j]);
    const Point first = wayOut(segments_[i], segments_[j]);
    const Point second = wayOut(segments_[j], segments_[i]);
    const double a = std::hypot(first.x, first.y), b = std::hypot(second.x, second.y);
    contacts_.push_back({chartOf_[i], chartOf_[j], std::min(a, b), a <= b ? first : -second});
  }
  /// How the chart of `s`, which crosses `t`, must move to leave `t` and keep the gap.
  Point wayOut(const Segment2& s, const Segment2& t) const {
    const Point along = t[1] - t[0];
    const Point out = Point(along.y, -along.x) / std::hypot(along.x, along.y);
    const double deep = std::max(glm::dot(t[0] - s[0], out), glm::dot(t[0] - s[1], out));
    return (std::max(deep, 0.0) + gap_ * (std::abs(out.x) + std::abs(out.y))) * out;
  }
  /// Charts that overlap part along the line of their centres.
  void addOverlap(std::size_t a, std::size_t b) {
    const Point d(charts_[a].pose.x - charts_[b].pose.x, charts_[a].pose.y - charts_[b].pose.y);
    const double length = std::max(std::hypot(d.x, d.y), 1e-9);
    const double missing = gap_ + kOverlapPush;
    contacts_.push_back({a, b, missing, d * (missing / length)});
  }
  /// A chart inside another touches it nowhere: look at one point of each.
  void measureInside() {
    for (std::size_t a = 0; a < charts_.size(); ++a) {
      if (begin_[a] == begin_[a + 1]) continue;
      const Point& p = segments_[begin_[a]][0];
      for (std::size_t b = 0; b < charts_.size(); ++b) {
        if (a != b && boxes_[b].holds(p) && winding(p, b) != 0)
          addOverlap(std::min(a, b), std::max(a, b));
      }
    }
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
  std::vector<double> radius_;  ///< of each chart about its centre, units of its plane
  std::vector<Box> boxes_;      ///< of each chart where it is now
  std::vector<Segment2> segments_;
  std::vector<std::size_t> chartOf_, begin_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< of segments, by their charts
  std::vector<Pose> pairedAt_;  ///< where the charts were when the pairs were found
  double pairedScale_ = 0;
  bool apart_ = false;
  int cells_ = 1;
  std::vector<std::size_t> cellBegin_, inCell_;
  std::vector<Contact> contacts_;
};

}  // namespace

Settled settle(std::span<PlacedOutline> charts, const PackGaps& gaps, double scale, int steps,
               const Progress& progress) {
  constexpr int kUntilApart = 40;
  constexpr double kLargestMove = 0.004;
  std::vector<Point> move(charts.size());
  PlacedSegments placed(charts, gaps);
  for (int i = 0; i < steps && !progress.cancelled(); ++i) {
    placed.measure(scale, i >= kUntilApart);
    if (placed.contacts().empty()) return {true, scale, {}};
    const double most = placed.pushes(move);
    for (std::size_t k = 0; k < charts.size(); ++k) {
      const double length = std::hypot(move[k].x, move[k].y);
      if (length > kLargestMove) move[k] *= kLargestMove / length;
      charts[k].pose.x += move[k].x, charts[k].pose.y += move[k].y;
    }
    // Slowly at first: most of what is missing can be found by moving.
    scale *= 1 - std::min(0.02, most) * (0.1 + 0.015 * i) - 1e-8;
  }
  return {false, scale, placed.stuck()};
}

}  // namespace chartflood
