#include "core/pack/packed_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/pack/grid_layout.h"
#include "core/pack/pack_search.h"
#include "core/pack/pack_shape.h"
#include "core/pack/parting.h"
#include "core/pack/shelf_layout.h"

namespace chartflood {

namespace {

/// Sizes that do not change with the charts' own units.
struct Sizes {
  double scale = 1;   ///< layout units per unit of the charts' plane
  double side = 1;    ///< about that of the square at the end, layout units
  double length = 0;  ///< of all outlines, layout units
};

Sizes measure(std::span<const ChartOutline> outlines) {
  double area = 0, size = 0, length = 0;
  for (const ChartOutline& outline : outlines) {
    const double side = smallestSquare(outline.hull).side;
    // Slivers count with a part of their length: charts without any area still have a size.
    area += std::max(outline.area, 0.01 * side * side);
    size = std::max(size, side);
    for (const Segment2& segment : outline.segments) {
      length += glm::distance(segment[0], segment[1]);
    }
  }
  if (area <= 0) return {};
  const double root = std::sqrt(layoutArea(outlines.size()));
  const double scale = root / std::sqrt(area);
  return {scale, std::max(1.15 * root, 0.8 * scale * size), scale * length};
}

/// Shapes with points every so many grains and at most `mostPoints` in all.
std::vector<PackShape> makeShapes(std::span<const ChartOutline> outlines, const Sizes& sizes,
                                  double spacing, double cell, double mostPoints, double reach) {
  const double unit = grainOf(sizes.side, outlines.size());
  // Many charts have fewer points, at all of their corners still.
  const ShapeDetail detail{static_cast<float>(std::max(spacing * unit, sizes.length / mostPoints)),
                           static_cast<float>(0.1 * spacing * unit),
                           static_cast<float>(cell * unit), static_cast<float>(reach)};
  std::vector<PackShape> shapes(outlines.size());
  parallelFor(shapes.size(),
              [&](std::size_t i) { shapes[i] = makeShape(outlines[i], sizes.scale, detail); });
  return shapes;
}

/// Of a unit of the charts' plane.
struct Scales {
  double layout;  ///< in layout units
  double least;   ///< in the texture, of a layout worth anything
};

/// Presses a layout once more, with finer shapes, and parts it exactly. The layout is of the first
/// shapes; the others, crumbs, are put into free places.
Fitted fit(std::span<const ChartOutline> outlines, std::span<const PackShape> shapes,
           const Scales& scales, PackLayout layout, const PackGaps& gaps,
           const Progress& progress) {
  const std::size_t pressed = layout.poses.size();
  // Pressed with a gap even where none is asked for, see below.
  Squeezer squeezer(shapes.first(pressed), {std::max(gaps.between, 0.001), gaps.border});
  // No more than the fields of fine shapes reach beyond the gap.
  constexpr double kSkin = 0.003;
  const int steps = pressed > kManyCharts ? 40 : 80;
  for (const double depth : {0.5, 0.1, 0.02, 0.004}) {
    squeezer.rest();
    squeezer.run(layout, {pressureFor(depth, layout.side), steps, kSkin}, progress);
  }
  Fitted fitted{1.002 * scales.layout / layout.side, {}};
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Pose pose = i < pressed ? layout.poses[i] : Pose{};
    fitted.charts.push_back({&outlines[i],
                             shapes[i].center,
                             {pose.x / layout.side + 0.5, pose.y / layout.side + 0.5, pose.angle}});
  }
  // What lies deeper in others than pressing explains hangs in them.
  const double pressedIn = grainOf(layout.side, pressed);
  std::vector<std::size_t> hanging;
  for (std::size_t i = 0; i < pressed; ++i) {
    if (squeezer.depths()[i] > pressedIn) hanging.push_back(i);
  }
  // Where most hang, as in a soup of needles, there are no other places: a third do at most where
  // parting ends well.
  if (2 * hanging.size() > pressed) return {};
  const Parting parting(shapes, scales.layout, scales.least, gaps, progress);
  parting.part(fitted, pressed, std::move(hanging));
  parting.makeUpright(fitted);
  return fitted;
}

/// A search among needles finds nothing: they have next to no area, however they lie; and one
/// among very many charts takes too long.
bool worthSearching(std::span<const ChartOutline> outlines) {
  constexpr std::size_t kMostCharts = 1500;
  constexpr double kLeastShare = 0.02;  // of the charts' squares
  double area = 0, squares = 0;
  for (const ChartOutline& outline : outlines) {
    const double side = smallestSquare(outline.hull).side;
    area += outline.area;
    squares += side * side;
  }
  return outlines.size() > 1 && outlines.size() <= kMostCharts && area > kLeastShare * squares;
}

/// The charts' numbers: those that are searched for the best layout, then crumbs, which are put
/// into free places at the end.
struct Order {
  std::vector<std::size_t> charts;
  std::size_t searched = 0;
};

/// Crumbs take next to no room beside the others and are far smaller than these.
Order crumbsLast(std::span<const ChartOutline> outlines, const PackGaps& gaps) {
  constexpr double kRoom = 0.03, kSmall = 0.25;
  constexpr std::size_t kFewCrumbs = 8;
  Order order;
  double area = 0;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    order.charts.push_back(i);
    area += outlines[i].area;
  }
  std::stable_sort(order.charts.begin(), order.charts.end(), [&](std::size_t a, std::size_t b) {
    return outlines[a].area > outlines[b].area;
  });
  const double gap = gaps.between * std::sqrt(1.3 * area);
  double room = 0, larger = area;
  std::size_t& count = order.searched;
  for (count = outlines.size(); count > 2; --count) {
    const ChartOutline& outline = outlines[order.charts[count - 1]];
    const double side = smallestSquare(outline.hull).side;
    larger -= outline.area;
    room += (side + gap) * (side + gap);
    const double usual = std::sqrt(larger / static_cast<double>(count - 1));
    if (room > kRoom * area || side + 2 * gap > kSmall * usual) break;
  }
  if (outlines.size() - count < kFewCrumbs) count = outlines.size();
  std::sort(order.charts.begin(), order.charts.begin() + static_cast<std::ptrdiff_t>(count));
  return order;
}

/// \param searched how many, the first ones, are searched for the best layout
/// \param leastScale that of a layout that is known
Fitted searchedLayout(std::span<const ChartOutline> outlines, std::size_t searched,
                      double leastScale, const PackGaps& gaps, Progress& progress) {
  Sizes sizes = measure(outlines.first(searched));
  const Scales scales{sizes.scale, leastScale};
  // A field does not see two fine teeth that cross: without a gap they would hook into each other.
  const PackGaps soft{std::max(gaps.between, 0.001), gaps.border};
  // The gap is widest across a diagonal; and a place is snug up to some distance.
  const double reach = std::max(1.5 * gaps.between * sizes.side, 0.09);
  const std::vector<PackShape> coarse =
      makeShapes(outlines.first(searched), sizes, 12, 10, 6000, reach);
  const std::vector<PackLayout> layouts =
      searchLayouts(coarse, soft, scales.layout / leastScale, 0.85f, progress);
  if (progress.cancelled()) return {};
  sizes.side = layouts.front().side;
  const bool many = searched > kManyCharts;
  const std::vector<PackShape> fine = makeShapes(outlines, sizes, 1.5, many ? 6 : 3, 16000,
                                                 1.5 * gaps.between * sizes.side + 0.004);
  const std::size_t most = many ? 1 : 2;
  std::vector<Fitted> fitted(std::min(layouts.size(), most));
  parallelFor(fitted.size(), [&](std::size_t k) {
    fitted[k] = fit(outlines, fine, scales, layouts[k], gaps, progress);
  });
  // Among many charts some may have come apart badly; the next layout then has its turn.
  constexpr double kWell = 0.96;
  if (fitted.size() < layouts.size() &&
      fitted.front().scale < kWell * sizes.scale / layouts.front().side && !progress.cancelled()) {
    fitted.push_back(fit(outlines, fine, scales, layouts[fitted.size()], gaps, progress));
  }
  return std::move(fitted.back().scale > fitted.front().scale ? fitted.back() : fitted.front());
}

}  // namespace

std::vector<Placement> firstLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps) {
  std::vector<Placement> grid = gridLayout(outlines, gaps, true);
  if (outlines.size() < 2) return grid;
  std::vector<Placement> shelves = shelfLayout(outlines, gaps, grid.front().scale);
  return shelves.empty() ? grid : shelves;
}

std::vector<Placement> packedLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                    Progress& progress) {
  std::vector<Placement> first = firstLayout(outlines, gaps);
  if (!worthSearching(outlines)) return first;
  const Order order = crumbsLast(outlines, gaps);
  std::vector<ChartOutline> ordered;
  ordered.reserve(outlines.size());
  for (const std::size_t i : order.charts) ordered.push_back(outlines[i]);
  const Fitted best = searchedLayout(ordered, order.searched, first.front().scale, gaps, progress);
  if (progress.cancelled()) return {};
  if (kUprightWorth * best.scale <= first.front().scale) return first;
  std::vector<Placement> packed(outlines.size());
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const PlacedOutline& chart = best.charts[i];
    Placement place{chart.pose.angle, best.scale, {0, 0}};
    place.offset = glm::dvec2(chart.pose.x, chart.pose.y) - place.at(chart.center);
    packed[order.charts[i]] = place;
  }
  return packed;
}

}  // namespace chartflood
