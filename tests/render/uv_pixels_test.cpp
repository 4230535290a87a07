// Pictures of the texture: what stands where, what is under a pixel.

#include <limits>
#include <set>

#include "tests/render/two_charts.h"

namespace chartflood {
namespace {

class UvPixels : public test::TwoCharts {
 protected:
  static constexpr int kSize = 300;

  Image drawUv(const RenderSettings& settings, const UvStyle& style = {.frame = false}) {
    return renderUvImage(*renderer_, uvCamera_, settings, style, {kSize, kSize, 1, 1});
  }
  glm::dvec2 uvMiddle(Index triangle) const {
    return glm::dvec2(uvAt(chartOf(triangle), onPlate(middle(triangle))));
  }
  glm::ivec2 uvPixel(const glm::dvec2& uv) const {
    return glm::ivec2(glm::floor(uvCamera_.toPixel(uv, glm::dvec2(kSize))));
  }
  Pick pickAt(const glm::ivec2& p) { return renderer_->pickUv(uvCamera_, kSize, kSize, p.x, p.y); }

  UvCamera uvCamera_ = UvCamera::exact();
};

TEST_F(UvPixels, TheMiddleOfAFaceHasItsChartsColour) {
  const RenderSettings settings = flat(ColorMode::Charts);
  const Image image = drawUv(settings);
  for (Index t = 0; t < mesh_->triangleCount(); ++t) {
    const glm::ivec2 p = uvPixel(uvMiddle(t));
    test::expectColor(image.at(p.x, p.y), renderer_->chartColor(chartOf(t), settings));
  }
  EXPECT_EQ(image.at(5, 5), (Rgba8{0, 0, 0, 255}));
}

TEST_F(UvPixels, EveryModeHasTheModelsColours) {
  std::vector<float> values;
  for (std::size_t t = 0; t < mesh_->triangleCount(); ++t) {
    values.push_back(1 + 0.01f * static_cast<float>(t % 90));
  }
  segmentation_.areas.gaussArea = {1, 3};
  setCharts(segmentation_);
  setUnwrap({{}, values, values, values});
  for (const ColorMode mode : {ColorMode::Shaded, ColorMode::Balance, ColorMode::Stretch,
                               ColorMode::AreaDistortion, ColorMode::AngleDistortion}) {
    const Image model = draw(flat(mode)), texture = drawUv(flat(mode));
    for (Index t = 0; t < mesh_->triangleCount(); t += 5) {
      const glm::ivec2 p = pixelOf(middle(t)), q = uvPixel(uvMiddle(t));
      EXPECT_EQ(model.at(p.x, p.y), texture.at(q.x, q.y)) << colorModeInfo(mode).id << t;
    }
  }
}

TEST_F(UvPixels, SquaresOfTheCheckerboardAreTheModelsOwn) {
  RenderSettings settings = flat(ColorMode::Checkerboard);
  settings.checkerSquares = 14;
  const Image model = draw(settings), texture = drawUv(settings);
  int compared = 0;
  for (Index t = 0; t < mesh_->triangleCount(); ++t) {
    const glm::ivec2 p = pixelOf(middle(t)), q = uvPixel(uvMiddle(t));
    const int a = model.at(p.x, p.y)[1], b = texture.at(q.x, q.y)[1];
    compared += std::abs(a - b) < 40 ? 1 : 0;
  }
  // But for the pixels at the edges of squares.
  EXPECT_GT(compared, static_cast<int>(0.8 * static_cast<double>(mesh_->triangleCount())));
}

TEST_F(UvPixels, EachFaceIsFoundWhereItIsDrawn) {
  for (Index t = 0; t < mesh_->triangleCount(); t += 3) {
    const Pick pick = pickAt(uvPixel(uvMiddle(t)));
    ASSERT_TRUE(pick.hit());
    EXPECT_EQ(pick.triangle, t);
    EXPECT_EQ(pick.face, t);
    EXPECT_EQ(pick.chart, chartOf(t));
    EXPECT_LT(glm::distance(pick.point, middle(t)), 0.02);
  }
  EXPECT_FALSE(pickAt({3, 3}).hit());
  EXPECT_FALSE(pickAt({-1, 3}).hit());
  EXPECT_FALSE(pickAt({kSize, 3}).hit());
}

TEST_F(UvPixels, ZoomAndShiftCarryThePictureAndThePick) {
  const Index triangle = 2 * (3 * kColumns + 3);
  const glm::dvec2 middleBefore = uvCamera_.toPixel(uvMiddle(triangle), glm::dvec2(kSize));
  const glm::ivec2 before = uvPixel(uvMiddle(triangle));
  uvCamera_.zoom(3, middleBefore, glm::dvec2(kSize));
  EXPECT_EQ(uvPixel(uvMiddle(triangle)), before);
  EXPECT_EQ(pickAt(before).triangle, triangle);
  uvCamera_.pan(glm::dvec2(before), glm::dvec2(before) + glm::dvec2(40, -25), glm::dvec2(kSize));
  EXPECT_EQ(pickAt(before + glm::ivec2(40, -25)).triangle, triangle);
}

TEST_F(UvPixels, HiddenChartsAreLeftOutAndNotFound) {
  RenderSettings settings = flat(ColorMode::Charts);
  settings.hiddenCharts = {0};
  const Image image = drawUv(settings);
  for (Index t = 0; t < mesh_->triangleCount(); t += 7) {
    const glm::ivec2 p = uvPixel(uvMiddle(t));
    EXPECT_EQ(image.at(p.x, p.y) == (Rgba8{0, 0, 0, 255}), chartOf(t) == 0);
    EXPECT_EQ(pickAt(p).hit(), chartOf(t) != 0);
  }
}

TEST_F(UvPixels, CutsGoWithTheirChart) {
  setCuts(cut());
  RenderSettings settings = flat(ColorMode::Charts);
  const auto dashes = [&](const std::vector<Index>& hidden) {
    settings.hiddenCharts = hidden;
    int count = 0;
    for (const Image& image : {drawUv(settings), draw(settings)}) {
      for (const Rgba8& p : image.pixels()) count += p[0] > 220 && p[1] > 150 && p[2] < 110 ? 1 : 0;
    }
    return count;
  };
  const int all = dashes({});
  EXPECT_GT(all, 20);
  EXPECT_EQ(dashes({1}), all);
  EXPECT_EQ(dashes({0}), 0);
}

TEST_F(UvPixels, FacesWithoutTexturePlaceAreAbsent) {
  std::vector<glm::vec2> uv = cornerUv();
  const Index bare = 2 * (3 * kColumns + 5);
  for (std::size_t c = 0; c < 6; ++c) {
    uv[std::size_t{3} * bare + c] = glm::vec2(std::numeric_limits<float>::quiet_NaN());
  }
  setCornerUv(uv);
  const Image image = drawUv(flat(ColorMode::Charts));
  const glm::ivec2 p = uvPixel(uvMiddle(bare));
  EXPECT_EQ(image.at(p.x, p.y), (Rgba8{0, 0, 0, 255}));
  EXPECT_FALSE(pickAt(p).hit());
}

TEST_F(UvPixels, OutlinesAreWhiteOnDarkAndCutsDashed) {
  RenderSettings settings = flat(ColorMode::Charts);
  settings.seams = true;
  setCuts(cut());
  const Image image = drawUv(settings, {.frame = false, .outlineWidth = 3});
  // The left border of chart 0 and the cut in its middle.
  int white = 0, cutColored = 0;
  for (double y = 1.2; y < 5.8; y += 0.1) {
    const glm::ivec2 border = uvPixel(glm::dvec2(uvAt(0, {0, y})));
    const Rgba8 color = image.at(border.x, border.y);
    white += std::min({color[0], color[1], color[2]}) > 220 ? 1 : 0;
    const glm::ivec2 inner = uvPixel(glm::dvec2(uvAt(0, {4, y})));
    const Rgba8 dash = image.at(inner.x, inner.y);
    cutColored += dash[0] > 220 && dash[1] > 150 && dash[2] < 110 ? 1 : 0;
  }
  EXPECT_GT(white, 40);
  EXPECT_GT(cutColored, 12);
  settings.seams = settings.cuts = false;
  EXPECT_EQ(drawUv(settings), drawUv(settings, {.frame = false, .outlineWidth = 3}));
}

TEST_F(UvPixels, GroundMayBeTransparentAndChartsEmpty) {
  RenderSettings settings = flat(ColorMode::Charts);
  settings.background.transparent = true;
  const glm::ivec2 p = uvPixel(uvMiddle(2 * (3 * kColumns + 3)));
  const Image filled = drawUv(settings);
  EXPECT_EQ(filled.at(5, 5), (Rgba8{0, 0, 0, 0}));
  EXPECT_EQ(filled.at(p.x, p.y)[3], 255);
  settings.seams = true;
  const Image outlines = drawUv(settings, {.fill = false, .frame = false});
  EXPECT_EQ(outlines.at(p.x, p.y), (Rgba8{0, 0, 0, 0}));
  const glm::ivec2 border = uvPixel(glm::dvec2(uvAt(0, {0, 4})));
  EXPECT_EQ(outlines.at(border.x, border.y)[3], 255);
}

TEST_F(UvPixels, TheFaceUnderThePointerIsBrighterAndItsChartALittle) {
  RenderSettings settings = flat(ColorMode::Charts);
  const Image before = drawUv(settings);
  const Index face = 2 * (3 * kColumns + 3);
  settings.hoverFace = face;
  const Image hovered = drawUv(settings), model = draw(settings);
  const auto gain = [&](Index t) {
    const glm::ivec2 p = uvPixel(uvMiddle(t));
    return hovered.at(p.x, p.y)[1] - before.at(p.x, p.y)[1];
  };
  const Index sameChart = 2 * (5 * kColumns + 2), otherChart = 2 * (5 * kColumns + 12);
  EXPECT_GT(gain(face), gain(sameChart) + 20);
  EXPECT_GT(gain(sameChart), 8);
  EXPECT_EQ(gain(otherChart), 0);
  const glm::ivec2 p = pixelOf(middle(face)), q = uvPixel(uvMiddle(face));
  EXPECT_EQ(model.at(p.x, p.y), hovered.at(q.x, q.y));
}

TEST_F(UvPixels, NumbersStandInsideTheirCharts) {
  RenderSettings settings = flat(ColorMode::Charts);
  const Image without = drawUv(settings);
  settings.numbers = true;
  const Image with = drawUv(settings);
  const auto owner = renderer_->triangleImage(uvCamera_, kSize, kSize);
  std::set<Index> numbered;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (with.at(x, y) == without.at(x, y)) continue;
      const Index triangle = owner[static_cast<std::size_t>(y * kSize + x)];
      ASSERT_NE(triangle, kNone) << x << " " << y;
      numbered.insert(chartOf(triangle));
    }
  }
  EXPECT_EQ(numbered, (std::set<Index>{0, 1}));
}

TEST_F(UvPixels, PartsMakeTheSamePictureAsTheWhole) {
  RenderSettings settings = flat(ColorMode::Charts);
  settings.seams = settings.numbers = true;
  PictureSize size{kSize, kSize, 2, 1};
  const Image whole = renderUvImage(*renderer_, uvCamera_, settings, {}, size);
  size.largestPart = 128;
  const Image parts = renderUvImage(*renderer_, uvCamera_, settings, {}, size);
  EXPECT_LT(compareImages(whole, parts, 3).differentPixels, 30u);
}

TEST_F(UvPixels, BothStandSideBySide) {
  const RenderSettings settings = flat(ColorMode::Charts);
  const PictureSize size{500, 200, 1, 1};
  const BothWidths widths = widthsOfBoth(size);
  EXPECT_EQ(widths.scene, 300);
  EXPECT_EQ(widths.uv, 200);
  const Image both = renderBothImage(*renderer_, camera_, uvCamera_, settings, {}, size);
  const Image model = renderImage(*renderer_, camera_, settings, {300, 200, 1, 1});
  const Image texture = renderUvImage(*renderer_, uvCamera_, settings, {}, {200, 200, 1, 1});
  for (int y = 0; y < 200; y += 3) {
    for (int x = 0; x < 500; x += 3) {
      EXPECT_EQ(both.at(x, y), x < 300 ? model.at(x, y) : texture.at(x - 300, y));
    }
  }
}

TEST_F(UvPixels, WithoutTextureOnlyTheGroundIsDrawn) {
  setCornerUv({});
  EXPECT_FALSE(renderer_->hasUv());
  const Image image = drawUv(flat(ColorMode::Charts));
  for (const Rgba8& pixel : image.pixels()) EXPECT_EQ(pixel, (Rgba8{0, 0, 0, 255}));
  EXPECT_FALSE(pickAt({150, 150}).hit());
}

TEST_F(UvPixels, APictureDrawnInPiecesIsTheSame) {
  RenderSettings settings = flat(ColorMode::Charts);
  settings.seams = settings.numbers = true;
  const gl::Framebuffer target(kSize, kSize, 1), other(kSize, kSize, 1);
  const PicturePart whole = PicturePart::whole(kSize, kSize);
  renderer_->drawUv(target, uvCamera_, settings, {});
  const Image wanted = readFramebuffer(target);
  renderer_->beginDrawingUv(other, uvCamera_, settings, {}, whole);
  EXPECT_TRUE(renderer_->drawing(other));
  EXPECT_FALSE(renderer_->drawing(target));
  while (!renderer_->continueDrawing(1e-4)) pickAt({100, 100});
  EXPECT_EQ(readFramebuffer(other), wanted);
}

}  // namespace
}  // namespace chartflood
