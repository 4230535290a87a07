// Charts in one texture: seen by a raster of its pixels, not by the packer's own geometry.

#include "core/pack/layout_atlas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/core/pack/laid_charts.h"

namespace chartflood {
namespace {

using test::LaidCharts;

constexpr LayoutOptions::Kind kSquare = LayoutOptions::Kind::Square;
constexpr LayoutOptions::Kind kPacked = LayoutOptions::Kind::Packed;

LaidCharts blobs(int count, std::uint32_t seed) {
  LaidCharts laid;
  Rng rng(seed);
  for (int i = 0; i < count; ++i) laid.addBlob(0.05 + 0.001 * rng.below(100), rng);
  return laid;
}

/// Every promise that holds for all layouts.
void expectSound(const LaidCharts& laid, const Atlas& atlas) {
  ASSERT_EQ(atlas.placement.size(), laid.charts.charts.size());
  ASSERT_EQ(atlas.uv.size(), laid.charts.charts.size());
  for (std::size_t k = 0; k < atlas.uv.size(); ++k) {
    const auto& flat = laid.unwrap.charts[k].uv;
    ASSERT_EQ(atlas.uv[k].size(), flat.size());
    EXPECT_EQ(atlas.placement[k].placed(), !flat.empty());
    for (std::size_t v = 0; v < flat.size(); ++v) {
      const glm::dvec2 p = atlas.uv[k][v];
      EXPECT_TRUE(p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1) << k << ": " << p.x << ", " << p.y;
      EXPECT_EQ(p, atlas.placement[k].at(flat[v]));
    }
    for (const auto& [a, b, c] : laid.charts.charts[k].surface.triangles) {
      if (flat.empty()) break;
      const auto turn = [&](const std::vector<glm::dvec2>& uv) {
        return (uv[b].x - uv[a].x) * (uv[c].y - uv[a].y) -
               (uv[b].y - uv[a].y) * (uv[c].x - uv[a].x);
      };
      EXPECT_GE(turn(atlas.uv[k]) * turn(flat), 0) << "chart " << k << " is mirrored";
    }
  }
  EXPECT_NEAR(atlas.efficiency, test::coveredArea(laid, atlas), 1e-12);
}

void expectApart(const LaidCharts& laid, const Atlas& atlas) {
  const test::RasterCheck check =
      test::checkRaster(laid, atlas, atlas.textureSize, atlas.margin + 1);
  EXPECT_EQ(check.sharedPixels, 0);
  EXPECT_GE(check.emptyBetween, atlas.margin);
  EXPECT_GE(check.emptyBorder, (atlas.margin + 1) / 2);
}

void expectOneScale(const Atlas& atlas) {
  double scale = 0;
  for (const Placement& p : atlas.placement) {
    if (!p.placed()) continue;
    if (scale == 0) scale = p.scale;
    EXPECT_EQ(p.scale, scale);
  }
}

TEST(PackedLayout, BlobsOfAllSizesKeepTheirMargins) {
  const LaidCharts laid = blobs(20, 7);
  for (const int margin : {1, 4, 9}) {
    const auto atlas = laid.layout({kPacked, 512, margin});
    EXPECT_EQ(atlas->textureSize, 512);
    EXPECT_EQ(atlas->margin, margin);
    expectSound(laid, *atlas);
    expectApart(laid, *atlas);
    expectOneScale(*atlas);
    EXPECT_GT(atlas->efficiency, margin == 9 ? 0.63 : margin == 4 ? 0.71 : 0.76);
  }
}

TEST(PackedLayout, NoMarginMeansNoOverlap) {
  const LaidCharts laid = blobs(12, 3);
  const auto atlas = laid.layout({kPacked, 1024, 0});
  expectSound(laid, *atlas);
  // Charts may share the pixels of their borders, and no others.
  const test::RasterCheck fine = test::checkRaster(laid, *atlas, 4096, 1);
  EXPECT_LT(static_cast<double>(fine.sharedPixels) / (4096 * 4096), 1e-4);
}

TEST(PackedLayout, EqualSquaresTile) {
  LaidCharts laid;
  for (int i = 0; i < 4; ++i) laid.addRectangle(1, 1);
  const auto atlas = laid.layout({kPacked, 1024, 0});
  expectSound(laid, *atlas);
  EXPECT_GT(atlas->efficiency, 0.95);
  expectApart(laid, *laid.layout({kPacked, 256, 4}));
}

TEST(PackedLayout, OneChartFillsItsSmallestSquare) {
  LaidCharts laid;
  // A unit square, turned by 30 degrees.
  const double c = std::cos(0.5235987755982988), s = 0.5;
  laid.addFan({{0, 0}, {c, s}, {c - s, s + c}, {-s, c}});
  const auto atlas = laid.layout({kPacked, 100, 3});
  expectSound(laid, *atlas);
  EXPECT_NEAR(atlas->efficiency, 0.96 * 0.96, 1e-4) << "two pixels stay free on each side";
}

TEST(PackedLayout, TwoTrianglesLieBackToBack) {
  LaidCharts laid;
  for (int i = 0; i < 2; ++i) laid.addFan({{0, 0}, {1, 0}, {0, 1}});
  const auto atlas = laid.layout({kPacked, 1024, 2});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  EXPECT_GT(atlas->efficiency, 0.9);
}

TEST(PackedLayout, SmallChartsUseHoles) {
  LaidCharts laid;
  laid.addRing(0.8, 1, 60);
  for (int i = 0; i < 3; ++i) laid.addRectangle(0.5, 0.5);
  const auto atlas = laid.layout({kPacked, 512, 4});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  // The ring alone in its square; the others leave it its full size.
  LaidCharts alone;
  alone.addRing(0.8, 1, 60);
  const auto ring = alone.layout({kPacked, 512, 4});
  EXPECT_GT(atlas->placement[0].scale, 0.97 * ring->placement[0].scale);
}

TEST(PackedLayout, CrumbsLeaveTheOthersTheirSize) {
  LaidCharts laid = blobs(20, 3);
  const auto alone = laid.layout({kPacked, 1024, 2});
  for (int i = 0; i < 150; ++i) laid.addRectangle(0.002 + 0.00001 * i, 0.003);
  const auto atlas = laid.layout({kPacked, 1024, 2});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  expectOneScale(*atlas);
  EXPECT_GT(atlas->placement[0].scale, 0.97 * alone->placement[0].scale);
}

TEST(PackedLayout, ThinChartsDoNotStayAcrossEachOther) {
  LaidCharts laid;
  for (int i = 0; i < 12; ++i) laid.addCross(0.08);
  const auto atlas = laid.layout({kPacked, 512, 2});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  // Cells of a grid, where a search that finds nothing ends, cover 0.19.
  EXPECT_GT(atlas->efficiency, 0.26);
}

TEST(PackedLayout, OneLargeAndManyTiny) {
  LaidCharts laid;
  Rng rng(5);
  laid.addBlob(1, rng);
  for (int i = 0; i < 60; ++i) laid.addBlob(0.03, rng);
  const auto atlas = laid.layout({kPacked, 512, 2});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  expectOneScale(*atlas);
}

TEST(PackedLayout, NeedlesAndPointsArePlaced) {
  LaidCharts laid;
  for (int i = 0; i < 6; ++i) laid.addRectangle(1, 0.004);
  laid.addFan({{0, 0}, {1, 0}, {0.5, 0}});  // without area
  laid.addFan({{2, 2}, {2, 2}, {2, 2}});    // a point
  const auto atlas = laid.layout({kPacked, 256, 2});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  for (const Placement& p : atlas->placement) EXPECT_TRUE(std::isfinite(p.scale));
}

TEST(PackedLayout, FlippedTrianglesCountAsCovered) {
  // The middle vertex of a fan lies outside the square: its triangles overlap and one is flipped.
  LaidCharts laid;
  for (int i = 0; i < 5; ++i) {
    laid.add({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.3, 0.5}},
             {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  }
  const auto atlas = laid.layout({kPacked, 512, 3});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
}

TEST(PackedLayout, TwoHundredCharts) {
  const LaidCharts laid = blobs(200, 11);
  const auto atlas = laid.layout({kPacked, 1024, 2});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  expectOneScale(*atlas);
  EXPECT_GT(atlas->efficiency, 0.7);
}

TEST(PackedLayout, ThreeHundredCharts) {
  const LaidCharts laid = blobs(300, 12);
  const auto atlas = laid.layout({kPacked, 2048, 4});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  expectOneScale(*atlas);
  EXPECT_GT(atlas->efficiency, 0.65);  // shelves cover 0.5
}

/// The smallest find places among the large ones, and no hole is left for them.
TEST(PackedLayout, AThousandChartsOfManySizes) {
  Rng rng(1);
  LaidCharts laid;
  for (int i = 0; i < 1000; ++i) laid.addBlob(std::exp(2.5 * rng.below(1000) / 1000.0), rng);
  const auto atlas = laid.layout({kPacked, 2048, 4});
  expectSound(laid, *atlas);
  expectOneScale(*atlas);
  EXPECT_GT(atlas->efficiency, 0.64);  // 0.56 among coarse cells alone, as on shelves
}

TEST(PackedLayout, SeveralHundredTriangles) {
  LaidCharts laid;
  Rng rng(17);
  const auto some = [&rng](double low, double high) {
    return low + (high - low) * rng.below(1000) / 1000;
  };
  for (int i = 0; i < 400; ++i) {
    laid.addFan({{0, 0}, {some(0.5, 1.5), 0}, {some(-0.5, 1), some(0.3, 1.2)}});
  }
  const auto atlas = laid.layout({kPacked, 2048, 4});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  expectOneScale(*atlas);
  EXPECT_GT(atlas->efficiency, 0.55);  // shelves cover 0.42
}

/// How far a side of a rectangle is from lying along an axis, radians.
double offUpright(const std::vector<glm::dvec2>& uv) {
  constexpr double kQuarter = 1.57079632679489662;
  const glm::dvec2 side = uv[1] - uv[0];
  return std::abs(std::remainder(std::atan2(side.y, side.x), kQuarter));
}

TEST(PackedLayout, SidesOfABoxLieUpright) {
  LaidCharts laid;
  for (int i = 0; i < 6; ++i) {
    const double c = std::cos(0.3 + i), s = std::sin(0.3 + i);
    laid.addFan({{0, 0}, {c, s}, {c - s, s + c}, {-s, c}});
  }
  const auto atlas = laid.layout({kPacked, 1024, 4});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  for (const auto& uv : atlas->uv) EXPECT_LT(offUpright(uv), 1e-9);
  EXPECT_GT(atlas->efficiency, 0.64);  // two thirds, less the margins
}

TEST(PackedLayout, AStripAsLongAsTheDiagonal) {
  LaidCharts laid;
  laid.addRectangle(4, 0.1);
  Rng rng(2);
  for (int i = 0; i < 19; ++i) {
    laid.addRectangle(0.1 + 0.0005 * rng.below(1000), 0.1 + 0.0003 * rng.below(1000));
  }
  const auto atlas = laid.layout({kPacked, 1024, 4});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  expectOneScale(*atlas);
  EXPECT_GT(atlas->placement[0].scale * 4, 1.3);
}

TEST(PackedLayout, OneLongStripLiesAlongTheDiagonal) {
  LaidCharts laid;
  laid.addRectangle(10000, 1);
  const auto atlas = laid.layout({kPacked, 1024, 4});
  expectSound(laid, *atlas);
  EXPECT_GT(atlas->placement[0].scale * 10000, 1.4);
}

TEST(PackedLayout, ManyBoxesStandOnShelves) {
  LaidCharts laid;
  Rng rng(3);
  for (int i = 0; i < 400; ++i) {
    laid.addRectangle(0.02 + 0.001 * rng.below(30), 0.01 + 0.001 * rng.below(10));
  }
  for (const int margin : {0, 3}) {
    const auto atlas = laid.layout({kPacked, 1024, margin});
    expectSound(laid, *atlas);
    expectOneScale(*atlas);
    if (margin > 0) expectApart(laid, *atlas);
    EXPECT_GT(atlas->efficiency, margin == 0 ? 0.85 : 0.6);
  }
}

TEST(PackedLayout, TinyTextures) {
  const LaidCharts laid = blobs(9, 2);
  for (const int size : {1, 16}) {
    const auto atlas = laid.layout({kPacked, size, 0});
    expectSound(laid, *atlas);
  }
  const auto atlas = laid.layout({kPacked, 24, 2});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
}

TEST(PackedLayout, LargeMarginsLowerTheScale) {
  const LaidCharts laid = blobs(9, 2);
  const auto small = laid.layout({kPacked, 256, 8});
  const auto large = laid.layout({kPacked, 256, 60});
  expectSound(laid, *large);
  expectApart(laid, *large);
  EXPECT_LT(large->placement[0].scale, small->placement[0].scale);
}

TEST(AnyLayout, MarginsThatLeaveNoRoomGiveWay) {
  const LaidCharts laid = blobs(9, 2);
  for (const LayoutOptions::Kind kind : {kSquare, kPacked}) {
    const auto atlas = laid.layout({kind, 256, 128});
    expectSound(laid, *atlas);
    expectApart(laid, *atlas);
    EXPECT_GT(atlas->margin, 30);
    EXPECT_LT(atlas->margin, 128);
    const int size = textureSizeFor(9, 128);
    EXPECT_EQ(laid.layout({kind, size, 128})->margin, 128);
    EXPECT_LT(laid.layout({kind, size / 2, 128})->margin, 128);
    EXPECT_THROW(laid.layout({kind, 256, -1}), Error);
    EXPECT_THROW(laid.layout({kind, 0, 0}), Error);
  }
}

TEST(AnyLayout, VeryManyChartsKeepTheMarginThatHasRoom) {
  LaidCharts laid;
  for (int i = 0; i < 3000; ++i) laid.addFan({{0, 0}, {1 + 0.001 * i, 0}, {0.3, 1}});
  const auto atlas = laid.layout({kPacked, 256, 8});
  expectSound(laid, *atlas);
  expectOneScale(*atlas);
  expectApart(laid, *atlas);
  EXPECT_GT(atlas->margin, 0);
  EXPECT_LT(atlas->margin, 8);
}

TEST(AnyLayout, ChartsWithoutUvAreLeftOut) {
  LaidCharts laid;
  laid.addUnlaid();
  laid.addRectangle(2, 1);
  laid.addUnlaid();
  for (const LayoutOptions::Kind kind : {kSquare, kPacked}) {
    const auto atlas = laid.layout({kind, 512, 4});
    expectSound(laid, *atlas);
    EXPECT_TRUE(atlas->uv[0].empty());
    EXPECT_EQ(atlas->uv[1].size(), 4u);
    EXPECT_NEAR(atlas->efficiency, 0.5 * std::pow(508 / 512.0, 2), 1e-3) << "as if it were alone";
  }
  LaidCharts none;
  none.addUnlaid();
  EXPECT_EQ(none.layout({})->efficiency, 0);
  EXPECT_EQ(LaidCharts().layout({})->efficiency, 0);
}

bool sameBytes(const Atlas& a, const Atlas& b) {
  if (a.uv.size() != b.uv.size()) return false;
  for (std::size_t k = 0; k < a.uv.size(); ++k) {
    if (a.uv[k].size() != b.uv[k].size() ||
        std::memcmp(a.uv[k].data(), b.uv[k].data(), a.uv[k].size() * sizeof(glm::dvec2)) != 0) {
      return false;
    }
  }
  return true;
}

TEST(AnyLayout, SameBytesForAnyNumberOfThreads) {
  const LaidCharts laid = blobs(8, 21);
  setThreadCount(1);
  const auto one = laid.layout({kPacked, 512, 4});
  setThreadCount(2);
  const auto two = laid.layout({kPacked, 512, 4});
  const auto again = laid.layout({kPacked, 512, 4});
  setThreadCount(0);
  EXPECT_TRUE(sameBytes(*one, *two));
  EXPECT_TRUE(sameBytes(*two, *again));
}

TEST(AnyLayout, CancelledMeansNull) {
  const LaidCharts laid = blobs(20, 4);
  for (const LayoutOptions::Kind kind : {kSquare, kPacked}) {
    Progress progress;
    progress.cancel();
    EXPECT_EQ(layoutAtlas(laid.charts, laid.unwrap, {kind, 512, 4}, progress), nullptr);
  }
  // From another thread, in the middle of the work.
  Progress progress;
  std::thread watcher([&progress] {
    while (progress.fraction() < 0.2f) std::this_thread::yield();
    progress.cancel();
  });
  EXPECT_EQ(layoutAtlas(laid.charts, laid.unwrap, {kPacked, 512, 4}, progress), nullptr);
  watcher.join();
  EXPECT_LT(progress.fraction(), 1);
}

TEST(AnyLayout, ProgressEndsAtOne) {
  Progress progress;
  const LaidCharts laid = blobs(4, 4);
  ASSERT_NE(layoutAtlas(laid.charts, laid.unwrap, {kPacked, 128, 2}, progress), nullptr);
  EXPECT_EQ(progress.fraction(), 1);
  EXPECT_STRNE(progress.phase(), "");
}

TEST(SquareLayout, EachChartFillsACellOfItsOwn) {
  LaidCharts laid = blobs(4, 9);
  laid.addRectangle(1, 1);
  laid.addRectangle(7, 7);
  laid.addRectangle(2, 1);
  const auto atlas = laid.layout({kSquare, 300, 5});
  expectSound(laid, *atlas);
  expectApart(laid, *atlas);
  // Seven charts: three columns. Two gaps of six pixels and three to each side leave 282.
  for (std::size_t k = 0; k < 7; ++k) {
    glm::dvec2 low(2), high(-1);
    for (const glm::dvec2& p : atlas->uv[k]) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double column = static_cast<double>(k % 3), row = static_cast<double>(k / 3);
    EXPECT_NEAR(std::max(high.x - low.x, high.y - low.y), 94 / 300.0, 1e-4);
    EXPECT_NEAR((low.x + high.x) / 2, (3 + 47 + 100 * column) / 300, 1e-4);
    EXPECT_NEAR((low.y + high.y) / 2, 1 - (3 + 47 + 100 * row) / 300, 1e-4);
  }
}

TEST(SquareLayout, CirclesAreAsWideAsTheirCells) {
  LaidCharts laid;
  test::Polygon circle;
  for (int i = 0; i < 360; ++i) {
    circle.emplace_back(std::cos(i * 3.14159265358979 / 180), std::sin(i * 3.14159265358979 / 180));
  }
  for (int i = 0; i < 4; ++i) laid.addFan(circle);
  const auto atlas = laid.layout({kSquare, 1024, 0});
  EXPECT_NEAR(atlas->efficiency, 3.14159265358979 / 4, 1e-3);
}

}  // namespace
}  // namespace chartflood
