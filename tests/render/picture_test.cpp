#include "core/base/error.h"
#include "tests/render/scene.h"

namespace chartflood {
namespace {

class Pictures : public test::GlTest {
 protected:
  RenderSettings busy() const {
    RenderSettings settings;
    settings.colorMode = ColorMode::Balance;
    settings.numbers = true;
    settings.edges = true;
    return settings;
  }
  void showCharts() {
    show(test::ball(12));
    Segmentation sides = cubeSides();
    sides.areas.gaussArea = {1, 2, 3, 4, 5, 6};
    setCharts(sides);
    std::vector<SeedMark> seeds;
    for (Index c = 0; c < 6; ++c) seeds.push_back({c * 288 + 140, c, c == 2});
    setSeeds(seeds);
  }
};

TEST_F(Pictures, EqualCallsGiveEqualPictures) {
  showCharts();
  const PictureSize size{200, 150, 2, 4};
  const Image first = renderImage(*renderer_, camera_, busy(), size);
  EXPECT_EQ(renderImage(*renderer_, camera_, busy(), size), first);
}

TEST_F(Pictures, PartsJoinWithoutAMark) {
  showCharts();
  RenderSettings settings = busy();
  settings.background = backgroundFromText("white");
  PictureSize size{300, 220, 1, 1};
  const Image whole = renderImage(*renderer_, camera_, settings, size);
  size.largestPart = 128;
  const Image parts = renderImage(*renderer_, camera_, settings, size);
  // Rounding at the edges of triangles and lines may differ by a step; nothing else may.
  const ImageDifference difference = compareImages(whole, parts, 40);
  EXPECT_LT(difference.differentPixels, 60u);
  EXPECT_LT(difference.mean, 0.05);
}

TEST_F(Pictures, SupersamplingKeepsWidthsAndLetters) {
  showCharts();
  RenderSettings settings = busy();
  settings.edges = false;
  const Image once = renderImage(*renderer_, camera_, settings, {300, 220, 1, 4});
  const Image twice = renderImage(*renderer_, camera_, settings, {300, 220, 2, 4});
  EXPECT_EQ(twice.width(), 300);
  EXPECT_LT(compareImages(once, twice).mean, 2.5);
}

TEST_F(Pictures, TransparentGroundHasNoAlphaAndNoDarkRim) {
  show(test::ball(12));
  RenderSettings settings = flat(ColorMode::Shaded);
  settings.background = backgroundFromText("transparent");
  const Image image = renderImage(*renderer_, camera_, settings, {kWidth, kHeight, 2, 4});
  EXPECT_EQ(image.at(0, 0), (Rgba8{0, 0, 0, 0}));
  const Rgba8 inside = image.at(kWidth / 2, kHeight / 2);
  EXPECT_EQ(inside[3], 255);
  int rim = 0;
  for (const Rgba8& p : image.pixels()) {
    if (p[3] == 0 || p[3] == 255) continue;
    ++rim;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(int{p[c]}, int{inside[c]}, 6);
  }
  EXPECT_GT(rim, 50);
}

TEST_F(Pictures, TheScalarBarRunsFromLowToHighColour) {
  showCharts();
  RenderSettings settings = flat(ColorMode::Balance);
  const Image without = draw(settings);
  settings.scalarBar = true;
  const Image with = draw(settings);
  EXPECT_GT(compareImages(with, without).differentPixels, 800u);
  // Somewhere in the right fifth one column shows the map from orange down to blue.
  int bars = 0;
  for (int x = kWidth * 4 / 5; x < kWidth; ++x) {
    int orange = -1, blue = -1;
    for (int y = 0; y < kHeight; ++y) {
      const Rgba8 p = with.at(x, y);
      if (orange < 0 && p[0] > p[2] + 80) orange = y;
      if (p[2] > p[0] + 80) blue = y;
    }
    if (orange >= 0 && blue > orange + 40) ++bars;
  }
  EXPECT_GE(bars, 10);
  EXPECT_GT(renderer_->scalarBarShare(settings, kWidth), 0);
  settings.colorMode = ColorMode::Charts;
  EXPECT_EQ(renderer_->scalarBarShare(settings, kWidth), 0);
}

TEST_F(Pictures, ModesWithoutDataShowThePlainSurface) {
  show(test::cube(2));
  const Image plain = draw(flat(ColorMode::Shaded));
  for (const ColorModeInfo& info : colorModeTable()) {
    if (info.needs == ModeNeed::Nothing) continue;
    EXPECT_FALSE(renderer_->canShow(info.mode)) << info.id;
    EXPECT_FALSE(renderer_->scalarRange(flat(info.mode))) << info.id;
    EXPECT_EQ(draw(flat(info.mode)), plain) << info.id;
  }
}

TEST_F(Pictures, WithoutAMeshOnlyTheGroundIsDrawn) {
  RenderSettings settings;
  settings.background = backgroundFromText("#336699");
  const Image image = renderImage(*renderer_, camera_, settings, {20, 10, 1, 1});
  for (const Rgba8& p : image.pixels()) EXPECT_EQ(p, (Rgba8{0x33, 0x66, 0x99, 255}));
}

TEST_F(Pictures, ImpossibleWishesAreRefused) {
  show(test::cube(1));
  EXPECT_THROW(renderImage(*renderer_, camera_, {}, {100, 100, 3, 1}), UsageError);
  EXPECT_THROW(renderImage(*renderer_, camera_, {}, {0, 100, 1, 1}), UsageError);
  EXPECT_THROW(renderImage(*renderer_, camera_, {}, {100, 20000, 1, 1}), UsageError);
  RenderSettings settings;
  settings.colorMap = "jet";
  EXPECT_THROW(renderImage(*renderer_, camera_, settings, {10, 10, 1, 1}), UsageError);
  const std::vector<float> few(5, 1.5f);
  setUnwrap({{}, few, few, few});
  EXPECT_FALSE(renderer_->canShow(ColorMode::Stretch)) << "values of another mesh";
}

}  // namespace
}  // namespace chartflood
