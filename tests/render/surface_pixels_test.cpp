#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

#include "tests/render/scene.h"

namespace chartflood {
namespace {

class SurfacePixels : public test::GlTest {};

TEST_F(SurfacePixels, TheMiddleOfAFaceHasItsChartsColour) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  const RenderSettings settings = flat(ColorMode::Charts);
  const Image image = draw(settings);
  const auto seen = seenTriangles();
  ASSERT_GT(seen.size(), 60u);
  std::set<Index> charts;
  for (const auto& [triangle, pixel] : seen) {
    const Index chart = sides.label[triangle];
    charts.insert(chart);
    test::expectColor(image.at(pixel.x, pixel.y), renderer_->chartColor(chart, settings));
  }
  EXPECT_EQ(charts.size(), 3u);  // an oblique view shows three sides
}

TEST_F(SurfacePixels, ChartsKeepTheirColoursWithNewLabels) {
  show(test::cube(4));
  const RenderSettings settings = flat(ColorMode::Charts);
  Segmentation labels = cubeSides();
  setCharts(labels);
  std::vector<glm::vec3> before;
  for (Index c = 0; c < 6; ++c) before.push_back(renderer_->chartColor(c, settings));
  labels.label[0] = 3;
  setCharts(labels);
  for (Index c = 0; c < 6; ++c) EXPECT_EQ(renderer_->chartColor(c, settings), before[c]);
}

TEST_F(SurfacePixels, FacesWithoutChartAreDry) {
  show(test::cube(2));
  Segmentation labels = cubeSides();
  labels.label.assign(labels.label.size(), kNone);
  labels.complete = false;
  setCharts(labels);
  const Image image = draw(flat(ColorMode::Charts));
  const auto seen = seenTriangles();
  ASSERT_FALSE(seen.empty());
  for (const auto& [triangle, pixel] : seen) {
    EXPECT_EQ(image.at(pixel.x, pixel.y), (Rgba8{0x6A, 0x6A, 0x6A, 255}));
  }
}

TEST_F(SurfacePixels, SeamsRunWhereLabelsDifferAndNowhereElse) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  RenderSettings settings = flat(ColorMode::Charts);
  const Image without = draw(settings);
  settings.seams = true;
  settings.seamWidth = 3;
  const Image with = draw(settings);
  const auto seen = seenTriangles();
  for (const auto& [triangle, pixel] : seen) {
    EXPECT_EQ(with.at(pixel.x, pixel.y), without.at(pixel.x, pixel.y));
  }
  int seamPixels = 0, innerPixels = 0;
  const auto image = renderer_->triangleImage(camera_, kWidth, kHeight);
  const auto at = [&](const glm::ivec2& p) {
    return image[static_cast<std::size_t>(p.y * kWidth + p.x)];
  };
  for (Index side = 0; side < mesh_->opposite().size(); ++side) {
    const Index other = mesh_->opposite()[side];
    const glm::dvec3 middle = 0.5 * (mesh_->positions()[mesh_->sideStart(side)] +
                                     mesh_->positions()[mesh_->sideEnd(side)]);
    const glm::ivec2 p = pixelOf(middle);
    if (at(p) != side / 3) continue;
    const Rgba8 color = with.at(p.x, p.y);
    if (sides.label[other / 3] != sides.label[side / 3]) {
      EXPECT_LT(color[0] + color[1] + color[2], 80) << side;
      ++seamPixels;
    } else {
      EXPECT_EQ(color, without.at(p.x, p.y)) << side;
      ++innerPixels;
    }
  }
  EXPECT_GT(seamPixels, 5);
  EXPECT_GT(innerPixels, 50);
}

TEST_F(SurfacePixels, WireframeShowsPolygonsWithoutTheirDiagonals) {
  show(test::quadCube(2));
  RenderSettings settings = flat(ColorMode::Shaded);
  const Image without = draw(settings);
  settings.edges = true;
  settings.edgeWidth = 3;
  const Image with = draw(settings);
  const auto image = renderer_->triangleImage(camera_, kWidth, kHeight);
  int edges = 0, diagonals = 0;
  for (Index side = 0; side < mesh_->opposite().size(); ++side) {
    const glm::dvec3 middle = 0.5 * (mesh_->positions()[mesh_->sideStart(side)] +
                                     mesh_->positions()[mesh_->sideEnd(side)]);
    const glm::ivec2 p = pixelOf(middle);
    if (image[static_cast<std::size_t>(p.y * kWidth + p.x)] != side / 3) continue;
    const bool inner = mesh_->faceOf(side / 3) == mesh_->faceOf(mesh_->opposite()[side] / 3);
    if (inner)
      EXPECT_EQ(with.at(p.x, p.y), without.at(p.x, p.y));
    else
      EXPECT_LT(with.at(p.x, p.y)[0] + 60, without.at(p.x, p.y)[0]);
    ++(inner ? diagonals : edges);
  }
  EXPECT_GT(edges, 8);
  EXPECT_GT(diagonals, 4);
}

TEST_F(SurfacePixels, BalanceIsWhiteAtTheMeanBlueBelowOrangeAbove) {
  show(test::cube(2));
  Segmentation sides = cubeSides();
  sides.areas.gaussArea = {1.0, 1.5, 0.5, 1.0, 1.5, 0.5};
  setCharts(sides);
  const RenderSettings settings = flat(ColorMode::Balance);
  const auto range = renderer_->scalarRange(settings);
  ASSERT_TRUE(range);
  EXPECT_EQ(range->min, -50);
  EXPECT_EQ(range->max, 50);
  const Image image = draw(settings);
  for (const auto& [triangle, pixel] : seenTriangles()) {
    const Rgba8 c = image.at(pixel.x, pixel.y);
    const double area = sides.areas.gaussArea[sides.label[triangle]];
    if (area < 1)
      EXPECT_GT(c[2], c[0] + 50);
    else if (area > 1)
      EXPECT_GT(c[0], c[2] + 50);
    else
      EXPECT_GT(std::min({c[0], c[1], c[2]}), 235);
  }
}

TEST_F(SurfacePixels, ValuesOutOfTheRangeAreGreyWhereColoursAreNotClamped) {
  show(test::cube(4));
  Segmentation sides = cubeSides();
  sides.areas.gaussArea = {1, 1, 1, 1, 1, 4};
  setCharts(sides);
  RenderSettings settings = flat(ColorMode::Balance);
  settings.range = {-50, 50};
  const auto greyCharts = [&] {
    const Image image = draw(settings);
    std::set<Index> grey;
    for (const auto& [triangle, pixel] : seenTriangles()) {
      if (image.at(pixel.x, pixel.y) == (Rgba8{106, 106, 106, 255})) {
        grey.insert(sides.label[triangle]);
      }
    }
    return grey;
  };
  EXPECT_TRUE(greyCharts().empty());
  settings.clampColors = false;
  EXPECT_EQ(greyCharts(), std::set<Index>{5});
  settings.range.reset();
  settings.range = {-33.5, 170};
  EXPECT_TRUE(greyCharts().empty());
}

TEST_F(SurfacePixels, HiddenChartsAreNotDrawnAndSelectedOnesStandOut) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  RenderSettings settings = flat(ColorMode::Charts);
  const auto seen = seenTriangles();
  const Index first = sides.label[seen.front().triangle];
  settings.selectedCharts = {first};
  const Image selected = draw(settings);
  settings.selectedCharts.clear();
  settings.hiddenCharts = {first};
  const Image hidden = draw(settings);
  for (const auto& [triangle, pixel] : seen) {
    const bool isFirst = sides.label[triangle] == first;
    const Rgba8 wanted = test::toRgba8(renderer_->chartColor(sides.label[triangle], settings));
    EXPECT_EQ(selected.at(pixel.x, pixel.y) == wanted, isFirst);
    EXPECT_EQ(hidden.at(pixel.x, pixel.y) == wanted, !isFirst);
  }
}

TEST_F(SurfacePixels, SeamsBetweenHiddenChartsAreNotDrawn) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  RenderSettings settings = flat(ColorMode::Charts);
  settings.hiddenCharts = {0, 1, 2, 3, 4, 5};
  settings.seams = true;
  settings.background = backgroundFromText("white");
  const Image none = draw(settings);
  for (const Rgba8& pixel : none.pixels()) ASSERT_EQ(pixel, (Rgba8{255, 255, 255, 255}));
  settings.hiddenCharts = {0, 1, 2, 3, 4};
  const Image one = draw(settings);
  EXPECT_GT(std::count_if(one.pixels().begin(), one.pixels().end(),
                          [](const Rgba8& p) { return p[0] < 60 && p[1] < 60; }),
            50);
}

TEST_F(SurfacePixels, SeedsAreMarkedInTheirChartsColour) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  const auto seen = seenTriangles();
  const auto [triangle, pixel] = seen[seen.size() / 2];
  const SeedMark seed{triangle, sides.label[triangle], false};
  setSeeds({seed});
  RenderSettings settings = flat(ColorMode::Shaded);
  settings.seedMarks = true;
  settings.seedRadius = 9;
  const Image image = draw(settings);
  // Outwards from the ball: a light ring, then a dark one.
  const auto red = [&](int right) { return int{image.at(pixel.x + right, pixel.y)[0]}; };
  const int lightest = std::max({red(5), red(6), red(7)});
  const int darkest = std::min({red(7), red(8), red(9)});
  EXPECT_GT(lightest, 200);
  EXPECT_LT(darkest, 60);
  const glm::vec3 color = renderer_->chartColor(seed.chart, settings);
  const Rgba8 core = image.at(pixel.x + 2, pixel.y + 2);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(core[c], 255 * color[static_cast<int>(c)], 70);
  }
}

TEST_F(SurfacePixels, SeedsOfHiddenChartsAreNotMarked) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  const auto [triangle, pixel] = seenTriangles().front();
  const SeedMark seed{triangle, sides.label[triangle], false};
  RenderSettings settings = flat(ColorMode::Charts);
  settings.seedMarks = true;
  settings.hiddenCharts = {seed.chart};
  const Image without = draw(settings);
  setSeeds({seed});
  EXPECT_EQ(draw(settings), without);
  settings.hiddenCharts.clear();
  EXPECT_NE(draw(settings), without);
}

TEST_F(SurfacePixels, LockedSeedsAreLargerAndShowAPadlock) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  const auto seen = seenTriangles();
  const auto [triangle, pixel] = seen[seen.size() / 2];
  RenderSettings settings = flat(ColorMode::Shaded);
  settings.seedMarks = true;
  settings.seedRadius = 12;
  const auto drawn = [&](bool locked) {
    const SeedMark seed{triangle, sides.label[triangle], false, locked};
    setSeeds({seed});
    return draw(settings);
  };
  const Image open = drawn(false), locked = drawn(true);
  const auto lightness = [&](const Image& image, int right, int down) {
    const Rgba8 color = image.at(pixel.x + right, pixel.y + down);
    return std::min({color[0], color[1], color[2]});
  };
  EXPECT_GT(lightness(locked, 0, 3), 230) << "the lock's body";
  EXPECT_LT(lightness(open, 0, 3), 200);
  EXPECT_NE(locked.at(pixel.x + 15, pixel.y), open.at(pixel.x + 15, pixel.y)) << "larger";
}

/// Normals of a ball, outwards (1) or inwards (-1).
CornerNormals ballNormals(const Mesh& mesh, float outwards) {
  CornerNormals normals;
  for (const auto& triangle : mesh.triangles()) {
    for (const Index v : triangle) {
      normals.normal.push_back(outwards * glm::vec3(glm::normalize(mesh.positions()[v])));
    }
  }
  return normals;
}

TEST_F(SurfacePixels, AClosedSurfaceInsideOutLooksLikeTheRightOne) {
  const auto drawBall = [&](const std::shared_ptr<const Mesh>& mesh, float outwards) {
    show(mesh);
    const CornerNormals normals = ballNormals(*mesh, outwards);
    setNormals(normals);
    RenderSettings settings = flat(ColorMode::Shaded);
    settings.lighting = true;
    return draw(settings);
  };
  const Image right = drawBall(test::ball(16), 1);
  const Image wrong = drawBall(test::ballInsideOut(16), -1);
  EXPECT_LT(compareImages(right, wrong, 2).differentPixels, 20u);
}

TEST_F(SurfacePixels, LightAtTheCornersOfDenseMeshesEqualsLightInEachPixel) {
  const auto drawBall = [&](int n) {
    show(test::ball(n));
    const CornerNormals normals = ballNormals(*mesh_, 1);
    setNormals(normals);
    RenderSettings settings = flat(ColorMode::Shaded);
    settings.lighting = true;
    return draw(settings);
  };
  const Image inPixels = drawBall(80);    // 76,800 triangles
  const Image atCorners = drawBall(100);  // 120,000 triangles
  // Outlines differ a little, for the meshes do.
  EXPECT_LT(compareImages(inPixels, atCorners, 4).differentPixels, 60u);
}

TEST_F(SurfacePixels, CheckerboardShowsBothGreys) {
  show(test::cube(1));
  std::vector<glm::vec2> uv;
  for (std::size_t t = 0; t < mesh_->triangleCount(); ++t) {
    // Corners of each square's two triangles: 0 1 2 and 0 2 3.
    const bool first = t % 2 == 0;
    uv.insert(uv.end(), {{0, 0},
                         first ? glm::vec2(1, 0) : glm::vec2(1, 1),
                         first ? glm::vec2(1, 1) : glm::vec2(0, 1)});
  }
  EXPECT_FALSE(renderer_->canShow(ColorMode::Checkerboard));
  setCornerUv(uv);
  EXPECT_TRUE(renderer_->canShow(ColorMode::Checkerboard));
  RenderSettings settings = flat(ColorMode::Checkerboard);
  settings.checkerSquares = 2;
  settings.checkerInTexture = true;
  camera_.look(StandardView::Front);
  camera_.frame(mesh_->positions(), aspect());
  const Image image = draw(settings);
  const auto grey = [&](double x, double y) {
    const double h = 0.2886751345948129;  // half a side of a cube with diagonal 1
    const glm::ivec2 p = pixelOf({x * h, y * h, h});
    return int{image.at(p.x, p.y)[0]};
  };
  EXPECT_EQ(grey(-0.5, -0.5), grey(0.5, 0.5));
  EXPECT_EQ(grey(-0.5, 0.5), grey(0.5, -0.5));
  EXPECT_GT(std::abs(grey(-0.5, -0.5) - grey(0.5, -0.5)), 100);
}

}  // namespace
}  // namespace chartflood
