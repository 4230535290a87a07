#include "core/pack/packed_layout.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/pack/gap_check.h"
#include "core/pack/grid_layout.h"
#include "core/pack/pack_search.h"
#include "core/pack/pack_shape.h"
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
  const double scale = 1 / std::sqrt(area);
  return {scale, std::max(1.15, 0.8 * scale * size), scale * length};
}

/// Shapes with points every so many 1024ths of the square, and at most `mostPoints` in all.
std::vector<PackShape> makeShapes(std::span<const ChartOutline> outlines, const Sizes& sizes,
                                  double spacing, double cell, double mostPoints, double reach) {
  const double unit = sizes.side / 1024;
  const ShapeDetail detail{static_cast<float>(std::max(spacing * unit, sizes.length / mostPoints)),
                           static_cast<float>(cell * unit), static_cast<float>(reach)};
  std::vector<PackShape> shapes(outlines.size());
  parallelFor(shapes.size(),
              [&](std::size_t i) { shapes[i] = makeShape(outlines[i], sizes.scale, detail); });
  return shapes;
}

/// A layout with finer shapes, pressed once more, and then parted exactly.
struct Fitted {
  double scale = 0;
  std::vector<PlacedOutline> charts;
};

Fitted fit(std::span<const ChartOutline> outlines, std::span<const PackShape> shapes,
           double layoutScale, PackLayout layout, const PackGaps& gaps, const Progress& progress) {
  // Pressed with a gap even where none is asked for, see below.
  Squeezer squeezer(shapes, {std::max(gaps.between, 0.001), gaps.border});
  // No more than the fields of fine shapes reach beyond the gap.
  constexpr double kSkin = 0.003;
  for (const double depth : {0.5, 0.1, 0.02, 0.004}) {
    squeezer.rest();
    squeezer.run(layout, {4 * depth / 1024 * layout.side, 80, kSkin}, progress);
  }
  Fitted fitted;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Pose& pose = layout.poses[i];
    fitted.charts.push_back({&outlines[i],
                             shapes[i].center,
                             {pose.x / layout.side + 0.5, pose.y / layout.side + 0.5, pose.angle}});
  }
  // Charts that are hooked into each other may need much more room.
  const std::vector<PlacedOutline> before = fitted.charts;
  for (const double room : {1.002, 0.97, 0.9, 0.75, 0.5}) {
    fitted.scale = settle(fitted.charts, gaps, room * layoutScale / layout.side, progress);
    if (fitted.scale > 0 || progress.cancelled()) break;
    fitted.charts = before;
  }
  return fitted;
}

/// A search among so many charts takes too long, and one among needles finds nothing: they have
/// next to no area, however they lie.
bool worthSearching(std::span<const ChartOutline> outlines) {
  constexpr std::size_t kMostCharts = 250;
  constexpr double kLeastShare = 0.02;  // of the charts' squares
  double area = 0, squares = 0;
  for (const ChartOutline& outline : outlines) {
    const double side = smallestSquare(outline.hull).side;
    area += outline.area;
    squares += side * side;
  }
  return outlines.size() <= kMostCharts && area > kLeastShare * squares;
}

}  // namespace

std::vector<Placement> packedLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                    Progress& progress) {
  std::vector<Placement> grid = gridLayout(outlines, gaps, true);
  if (outlines.size() < 2) return grid;
  if (!worthSearching(outlines)) {
    std::vector<Placement> shelves = shelfLayout(outlines, gaps, grid.front().scale);
    return shelves.empty() ? grid : shelves;
  }
  Sizes sizes = measure(outlines);
  // A field does not see two fine teeth that cross: without a gap they would hook into each other.
  const PackGaps soft{std::max(gaps.between, 0.001), gaps.border};
  // The gap is widest across a diagonal; and a place is snug up to some distance.
  const double reach = std::max(1.5 * gaps.between * sizes.side, 0.09);
  const std::vector<PackShape> coarse = makeShapes(outlines, sizes, 12, 10, 6000, reach);
  const std::vector<PackLayout> layouts = searchLayouts(coarse, soft, 0.85f, progress);
  if (progress.cancelled()) return {};
  sizes.side = layouts.front().side;
  const std::vector<PackShape> fine =
      makeShapes(outlines, sizes, 1.5, 3, 16000, 1.5 * gaps.between * sizes.side + 0.004);
  std::vector<Fitted> fitted(std::min<std::size_t>(layouts.size(), 2));
  parallelFor(fitted.size(), [&](std::size_t k) {
    fitted[k] = fit(outlines, fine, sizes.scale, layouts[k], gaps, progress);
  });
  if (progress.cancelled()) return {};
  const Fitted& best = fitted.back().scale > fitted.front().scale ? fitted.back() : fitted.front();
  if (best.scale <= grid.front().scale) return grid;
  std::vector<Placement> packed;
  for (const PlacedOutline& chart : best.charts) {
    Placement place{chart.pose.angle, best.scale, {0, 0}};
    place.offset = glm::dvec2(chart.pose.x, chart.pose.y) - place.at(chart.center);
    packed.push_back(place);
  }
  return packed;
}

}  // namespace chartflood
