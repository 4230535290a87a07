// Free places beside shapes that lie already: found where there are some, and without a look at all
// others.

#include "core/pack/free_space.h"

#include <gtest/gtest.h>

namespace chartflood {
namespace {

constexpr double kSide = 1, kGap = 0.01, kCell = 0.01;

PackShape squareOf(double width) {
  ChartOutline outline;
  const double h = width / 2;
  outline.hull = {{-h, -h}, {h, -h}, {h, h}, {-h, h}};
  for (std::size_t i = 0; i < 4; ++i) {
    outline.segments.push_back({outline.hull[i], outline.hull[(i + 1) % 4]});
  }
  outline.area = width * width;
  return makeShape(outline, 1, {0.01f, 0.001f, 0.005f, 0.09f});
}

/// Four squares that leave a cross of the given width, and a free corner where one is left out.
FreeSpace fourSquares(double cross, bool corner, FreeSpace::Overlap overlap) {
  FreeSpace space(kSide, kGap, kGap, kCell, overlap);
  const double width = (kSide - cross) / 2 - 2 * kGap, at = (kSide + cross) / 4;
  const PackShape square = squareOf(width);
  for (const double x : {-at, at}) {
    for (const double y : {-at, at}) {
      if (corner && x > 0 && y > 0) continue;
      space.add(space.footprint(square, {x, y, 0}));
    }
  }
  return space;
}

TEST(FreeSpace, FindsThePlaceThatIsFree) {
  FreeSpace space = fourSquares(0.05, true, FreeSpace::Overlap::Barred);
  const PackShape square = squareOf(0.3);
  const Pose pose = space.bestPose(square, 0, 8);
  EXPECT_TRUE(space.fits(square, pose));
  EXPECT_GT(pose.x, 0);
  EXPECT_GT(pose.y, 0);
}

TEST(FreeSpace, BarredOverlapLeavesSmallShapesRoom) {
  // Snug is not worth a point in another shape: what fits somewhere is put where it fits.
  FreeSpace space = fourSquares(0.05, false, FreeSpace::Overlap::Barred);
  const PackShape crumb = squareOf(0.015);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = space.bestPose(crumb, 0.1 * i, 4);
    ASSERT_TRUE(space.fits(crumb, pose)) << i;
    space.add(space.footprint(crumb, pose));
  }
}

TEST(FreeSpace, LeavesOutBlocksThatAreTaken) {
  const PackShape square = squareOf(0.2);
  FreeSpace empty(kSide, kGap, kGap, kCell);
  empty.bestPose(square, 0, 8);
  FreeSpace full = fourSquares(0.05, true, FreeSpace::Overlap::Dear);
  full.bestPose(square, 0, 8);
  EXPECT_GT(full.looks(), 0u);
  // A quarter of the square is free.
  EXPECT_LT(3 * full.looks(), empty.looks());
}

}  // namespace
}  // namespace chartflood
