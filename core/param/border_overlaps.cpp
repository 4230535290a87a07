#include "core/param/border_overlaps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "core/base/index.h"
#include "core/base/interruption.h"
#include "core/param/border_crossings.h"

namespace chartflood {

namespace {

PlaneBox boxOf(std::span<const glm::dvec2> points) {
  PlaneBox box;
  for (const glm::dvec2& p : points) box.add(p);
  return box;
}

struct Segment {
  glm::dvec2 from, to;
  std::size_t border = 0;  ///< 0 or 1
  PlaneBox box;
};

const glm::dvec2& after(const FlatBorder& border, std::size_t i) {
  return border[i + 1 == border.size() ? 0 : i + 1];
}

/// Segments of a border that lie in a box.
void addSegments(const FlatBorder& border, std::size_t number, const PlaneBox& common,
                 std::vector<Segment>& out) {
  for (std::size_t i = 0; i < border.size(); ++i) {
    Segment segment{border[i], after(border, i), number, {}};
    segment.box.add(segment.from);
    segment.box.add(segment.to);
    if (segment.box.meets(common)) out.push_back(segment);
  }
}

/// A sweep upwards: each segment is held against those of the other border that are not yet passed.
bool bordersCross(const FlatBorder& a, const FlatBorder& b, const PlaneBox& common) {
  std::vector<Segment> segments;
  addSegments(a, 0, common, segments);
  addSegments(b, 1, common, segments);
  std::sort(segments.begin(), segments.end(),
            [](const Segment& s, const Segment& t) { return s.box.low.y < t.box.low.y; });
  std::array<std::vector<std::size_t>, 2> reached;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Segment& segment = segments[s];
    std::vector<std::size_t>& others = reached[1 - segment.border];
    std::erase_if(others,
                  [&](std::size_t o) { return segments[o].box.high.y < segment.box.low.y; });
    const bool crosses = std::any_of(others.begin(), others.end(), [&](std::size_t o) {
      const Segment& other = segments[o];
      return segment.box.meets(other.box) &&
             segmentsCross(segment.from, segment.to, other.from, other.to, Contact::Deep);
    });
    if (crosses) return true;
    reached[segment.border].push_back(s);
  }
  return false;
}

/// Even-odd rule.
bool holds(const FlatBorder& border, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const glm::dvec2 &a = border[i], &b = after(border, i);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside;
}

bool crossesItself(const FlatBorder& border) {
  std::vector<Index> loop(border.size());
  std::iota(loop.begin(), loop.end(), Index{0});
  std::vector<bool> crossing;
  return findCrossings(loop, border, Contact::Deep, crossing);
}

}  // namespace

std::vector<bool> findMeetingCharts(std::span<const FlatBorder> borders) {
  std::vector<bool> met(borders.size(), false);
  std::vector<PlaneBox> box;
  std::vector<std::size_t> order;
  for (std::size_t c = 0; c < borders.size(); ++c) {
    throwIfInterrupted();
    box.push_back(boxOf(borders[c]));
    if (borders[c].empty()) continue;
    order.push_back(c);
    if (crossesItself(borders[c])) met[c] = true;
  }
  // Boxes from left to right, each against those that reach into its columns.
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return box[a].low.x < box[b].low.x; });
  std::vector<std::size_t> reached;
  for (const std::size_t c : order) {
    throwIfInterrupted();
    std::erase_if(reached, [&](std::size_t o) { return box[o].high.x < box[c].low.x; });
    for (const std::size_t o : reached) {
      if ((met[c] && met[o]) || !box[c].meets(box[o])) continue;
      const PlaneBox common{glm::max(box[c].low, box[o].low), glm::min(box[c].high, box[o].high)};
      if (bordersCross(borders[c], borders[o], common) || holds(borders[o], borders[c].front()) ||
          holds(borders[c], borders[o].front())) {
        met[c] = met[o] = true;
      }
    }
    reached.push_back(c);
  }
  return met;
}

}  // namespace chartflood
