#include "core/pack/packed_layout.h"

#include <algorithm>
#include <cmath>

#include <cstdio>
#include <cstdlib>
#include "core/base/parallel.h"
#include "core/pack/gap_check.h"
#include "core/pack/grid_layout.h"
#include "core/pack/pack_search.h"
#include "core/pack/pack_shape.h"

namespace chartflood {

namespace {

/// Layout units per unit of the charts' plane. Slivers count with a part of their length, so that
/// charts without any area still have a size.
double layoutScale(std::span<const ChartOutline> outlines) {
  double area = 0, size = 0;
  for (const ChartOutline& outline : outlines) {
    const double side = smallestSquare(outline.hull).side;
    area += std::max(outline.area, 0.01 * side * side);
    size = std::max(size, side);
  }
  return area > 0 ? 1 / std::sqrt(area) : 1;
}

std::vector<PackShape> makeShapes(std::span<const ChartOutline> outlines, double scale,
                                  const ShapeDetail& detail) {
  std::vector<PackShape> shapes(outlines.size());
  parallelFor(shapes.size(),
              [&](std::size_t i) { shapes[i] = makeShape(outlines[i], scale, detail); });
  return shapes;
}

/// Space that the charts take about, as share of the square, for sizes that need only be near.
constexpr double kUsualSide = 1.2;

/// The same layout with finer shapes, pressed once more and fitted exactly.
std::vector<Placement> fitted(std::span<const ChartOutline> outlines,
                              std::span<const PackShape> shapes, double scale, PackLayout layout,
                              const PackGaps& gaps, const Progress& progress) {
  Squeezer squeezer(shapes, gaps);
  const double pixel = layout.side / 1024;
  for (const double depth : {0.5, 0.1, 0.02, 0.004}) {
    squeezer.run(layout, {4 * depth * pixel, 80}, progress);
  if (getenv("VERB")) printf("fine %.4f depth %g\n", 1/layout.side/layout.side, squeezer.depth()/pixel);
  }
  std::vector<PlacedOutline> placed(outlines.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Pose& pose = layout.poses[i];
    placed[i] = {&outlines[i], shapes[i].center,
                 {pose.x / layout.side + 0.5, pose.y / layout.side + 0.5, pose.angle}};
  }
  const double best = settle(placed, gaps, 1.002 * scale / layout.side, progress);
  if (getenv("VERB")) printf("exact %.4f \n", best*best/scale/scale);
  std::vector<Placement> placement;
  for (const PlacedOutline& p : placed) {
    Placement place{p.pose.angle, best, {0, 0}};
    place.offset = glm::dvec2(p.pose.x, p.pose.y) - place.at(p.center);
    placement.push_back(place);
  }
  return placement;
}

}  // namespace

std::vector<Placement> packedLayout(std::span<const ChartOutline> outlines, const PackGaps& gaps,
                                    Progress& progress) {
  std::vector<Placement> grid = gridLayout(outlines, gaps, true);
  if (outlines.size() < 2) return grid;
  const double scale = layoutScale(outlines);
  const float reach = static_cast<float>(std::max(1.45 * gaps.between * kUsualSide, 0.09));
  const float unit = static_cast<float>(kUsualSide / 1024);
  const std::vector<PackShape> coarse = makeShapes(outlines, scale, {6 * unit, 8 * unit, reach});
  const PackLayout layout = searchLayout(coarse, gaps, {}, progress);
  if (progress.cancelled()) return {};
  const std::vector<PackShape> fine = makeShapes(
      outlines, scale,
      {1.5f * unit, 3 * unit, static_cast<float>(1.45 * gaps.between * kUsualSide) + 4 * unit});
  std::vector<Placement> packed = fitted(outlines, fine, scale, layout, gaps, progress);
  if (progress.cancelled()) return {};
  return packed.front().scale > grid.front().scale ? packed : grid;
}

}  // namespace chartflood
