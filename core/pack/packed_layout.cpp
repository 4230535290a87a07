#include "core/pack/packed_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/pack/free_space.h"
#include "core/pack/gap_check.h"
#include "core/pack/grid_layout.h"
#include "core/pack/pack_search.h"
#include "core/pack/pack_shape.h"
#include "core/pack/shelf_layout.h"

namespace chartflood {

namespace {

/// Share of the largest scale that a layout of upright charts may have and still be taken.
constexpr double kUprightWorth = 0.997;

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

/// A layout with finer shapes, pressed once more, and then parted exactly.
struct Fitted {
  double scale = 0;
  std::vector<PlacedOutline> charts;
};

/// Charts stuck in bays of others are put into any free places that they fit.
/// \return whether all found one
bool replaceStuck(Fitted& fitted, std::span<const PackShape> shapes, const Settled& settled,
                  double layoutScale, const PackGaps& gaps) {
  constexpr double kCells = 1000;
  constexpr int kTurns = 16;
  const double side = layoutScale / settled.scale;
  FreeSpace space(side, gaps.between * side, gaps.border * side, side / kCells);
  const auto poseOf = [&](std::size_t i) {
    const Pose& pose = fitted.charts[i].pose;
    return Pose{(pose.x - 0.5) * side, (pose.y - 0.5) * side, pose.angle};
  };
  // Those that find no other place stay, so that theirs is not free either.
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    space.add(space.footprint(shapes[i], poseOf(i)));
  }
  std::vector<std::size_t> stuck = settled.stuck;
  std::stable_sort(stuck.begin(), stuck.end(),
                   [&](std::size_t a, std::size_t b) { return shapes[a].area > shapes[b].area; });
  bool all = true;
  for (const std::size_t i : stuck) {
    const Pose found = space.bestPose(shapes[i], fitted.charts[i].pose.angle, kTurns);
    const bool fits = space.fits(shapes[i], found);
    all = all && fits;
    if (!fits) continue;
    fitted.charts[i].pose = {found.x / side + 0.5, found.y / side + 0.5, found.angle};
    space.add(space.footprint(shapes[i], found));
  }
  return all;
}

/// Parts the charts, by putting those that stay stuck elsewhere or, at last, by much more room.
void settleSomehow(Fitted& fitted, std::span<const PackShape> shapes, double layoutScale,
                   double side, const PackGaps& gaps, const Progress& progress) {
  constexpr int kSteps = 60, kReplacings = 8;
  constexpr double kSmaller = 0.995;
  const std::vector<PlacedOutline> before = fitted.charts;
  double scale = 1.002 * layoutScale / side;
  for (int i = 0; i <= kReplacings && !progress.cancelled(); ++i) {
    const Settled settled =
        settle(fitted.charts, gaps, scale, i < kReplacings ? kSteps : 2 * kSteps, progress);
    fitted.scale = settled.apart ? settled.scale : 0;
    if (settled.apart) return;
    const bool replaced = replaceStuck(fitted, shapes, settled, layoutScale, gaps);
    scale = settled.scale * (replaced ? 1 : kSmaller);
  }
  for (const double room : {0.97, 0.9, 0.75, 0.5}) {
    fitted.charts = before;
    const Settled settled =
        settle(fitted.charts, gaps, room * layoutScale / side, 2 * kSteps, progress);
    fitted.scale = settled.apart ? settled.scale : 0;
    if (settled.apart || progress.cancelled()) return;
  }
}

/// Boxes that lie nearly upright are turned to lie so exactly, unless that costs much.
void makeUpright(Fitted& fitted, std::span<const PackShape> shapes, const PackGaps& gaps,
                 const Progress& progress) {
  constexpr double kQuarter = std::numbers::pi / 2, kNearly = 0.1;
  Fitted upright = fitted;
  bool turned = false;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    double& angle = upright.charts[i].pose.angle;
    const double off = std::remainder(angle - shapes[i].upright, kQuarter);
    if (!shapes[i].boxy || std::abs(off) > kNearly) continue;
    angle -= off;
    turned = true;
  }
  if (!turned) return;
  const Settled settled = settle(upright.charts, gaps, fitted.scale, 60, progress);
  upright.scale = settled.scale;
  if (settled.apart && settled.scale >= kUprightWorth * fitted.scale) fitted = std::move(upright);
}

Fitted fit(std::span<const ChartOutline> outlines, std::span<const PackShape> shapes,
           double layoutScale, PackLayout layout, const PackGaps& gaps, const Progress& progress) {
  // Pressed with a gap even where none is asked for, see below.
  Squeezer squeezer(shapes, {std::max(gaps.between, 0.001), gaps.border});
  // No more than the fields of fine shapes reach beyond the gap.
  constexpr double kSkin = 0.003;
  constexpr int steps = 80;
  for (const double depth : {0.5, 0.1, 0.02, 0.004}) {
    squeezer.rest();
    squeezer.run(layout, {pressureFor(depth, layout.side), steps, kSkin}, progress);
  }
  Fitted fitted;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Pose& pose = layout.poses[i];
    fitted.charts.push_back({&outlines[i],
                             shapes[i].center,
                             {pose.x / layout.side + 0.5, pose.y / layout.side + 0.5, pose.angle}});
  }
  settleSomehow(fitted, shapes, layoutScale, layout.side, gaps, progress);
  makeUpright(fitted, shapes, gaps, progress);
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

Fitted searchedLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                      Progress& progress) {
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
  const std::size_t most = outlines.size() > kManyCharts ? 1 : 2;
  std::vector<Fitted> fitted(std::min(layouts.size(), most));
  parallelFor(fitted.size(), [&](std::size_t k) {
    fitted[k] = fit(outlines, fine, sizes.scale, layouts[k], gaps, progress);
  });
  // Among many charts some may have come apart badly; the next layout then has its turn.
  constexpr double kWell = 0.96;
  if (fitted.size() < layouts.size() &&
      fitted.front().scale < kWell * sizes.scale / layouts.front().side && !progress.cancelled()) {
    fitted.push_back(fit(outlines, fine, sizes.scale, layouts[fitted.size()], gaps, progress));
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
  const Fitted best = searchedLayout(outlines, gaps, progress);
  if (progress.cancelled()) return {};
  if (kUprightWorth * best.scale <= first.front().scale) return first;
  std::vector<Placement> packed;
  for (const PlacedOutline& chart : best.charts) {
    Placement place{chart.pose.angle, best.scale, {0, 0}};
    place.offset = glm::dvec2(chart.pose.x, chart.pose.y) - place.at(chart.center);
    packed.push_back(place);
  }
  return packed;
}

}  // namespace chartflood
