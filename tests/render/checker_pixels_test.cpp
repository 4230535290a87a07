// The checkerboard and the colours of an unwrap on the model.

#include <limits>
#include <memory>

#include "tests/render/two_charts.h"

namespace chartflood {
namespace {

class Checker : public test::TwoCharts {
 protected:
  static RenderSettings board(float squares) {
    RenderSettings settings = flat(ColorMode::Checkerboard);
    settings.checkerSquares = squares;
    settings.checkerTint = 0;
    return settings;
  }
  /// How often light and dark change along a horizontal line of the plate.
  int changes(const Image& image, double fromX, double toX, double y) const {
    const glm::ivec2 from = pixelOf(inSpace(fromX, y)), to = pixelOf(inSpace(toX, y));
    int count = 0;
    for (int x = from.x + 1; x <= to.x; ++x) {
      const bool light = image.at(x, from.y)[0] > 163, before = image.at(x - 1, from.y)[0] > 163;
      count += light != before ? 1 : 0;
    }
    return count;
  }
  /// The middle of square (column, row) of chart 0's board, in pixels.
  glm::ivec2 middleOfSquare(float squares, int column, int row) const {
    const double diagonal = std::hypot(kColumns, kRows), side = diagonal / double{squares};
    // Chart 0 begins at texture place 0.05, which is one square of the plate.
    return pixelOf(inSpace((column + 0.5) * side - 1, (row + 0.5) * side - 1));
  }
};

TEST_F(Checker, SquaresHaveTheAskedSizeAlongTheDiagonal) {
  const double diagonal = std::hypot(kColumns, kRows);
  for (const float squares : {12.0f, 24.0f, 40.0f}) {
    const Image image = draw(board(squares));
    const double expected = 6 / diagonal * double{squares};  // over six squares of the plate
    EXPECT_NEAR(changes(image, 1, 7, 4.3), expected, 1.01) << squares;
  }
}

TEST_F(Checker, SquaresAreOfOneSizeInChartsOfDifferentScale) {
  for (const double y : {2.3, 4.7, 6.1}) {
    const Image image = draw(board(40));
    EXPECT_NEAR(changes(image, 1, 7, y), changes(image, 9, 15, y), 1.01) << y;
  }
}

TEST_F(Checker, SquaresByTheTextureFollowItsScale) {
  RenderSettings settings = board(40);
  settings.checkerInTexture = true;
  const Image image = draw(settings);
  EXPECT_NEAR(changes(image, 1, 7, 4.3), 40 * 6 / 20.0, 1.01);
  EXPECT_NEAR(changes(image, 9, 15, 4.3), 40 * 6 / 40.0, 1.01);
}

TEST_F(Checker, SquaresBelowAPixelFadeToTheMean) {
  const Image image = draw(board(3000));
  const int mean = static_cast<int>(std::lround(255 * (0.36 + 0.92) / 2));
  for (double x = 0.5; x < kColumns; x += 0.37) {
    const glm::ivec2 p = pixelOf(inSpace(x, 3.3));
    EXPECT_NEAR(int{image.at(p.x, p.y)[0]}, mean, 2) << x;
  }
}

TEST_F(Checker, SmallSquaresSeenAslantLookLikeTheAverageOfManySamples) {
  camera_.orthographic = false;
  camera_.orbit(0.5, 1.15);
  camera_.frame(mesh_->positions(), aspect());
  const RenderSettings settings = board(40);
  const Image once = draw(settings);
  const Image often = renderImage(*renderer_, camera_, settings, {kWidth, kHeight, 4, 1});
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < once.pixels().size(); ++i) {
    if (often.pixels()[i][1] < 80) continue;  // the ground, and the plate's border
    const double difference = static_cast<double>(once.pixels()[i][1]) - often.pixels()[i][1];
    sum += difference * difference;
    ++count;
  }
  ASSERT_GT(count, 5000);
  EXPECT_LT(std::sqrt(sum / count), 18.0);  // of 143 between the greys; single samples give 50
}

/// While the camera moves, squares that are hardly larger than a pixel must not flicker.
TEST_F(Checker, TinySquaresStayCalmInMotion) {
  camera_.orthographic = false;
  camera_.orbit(0.5, 1.15);
  camera_.frame(mesh_->positions(), aspect());
  for (int step = 0; step < 6; ++step) {
    camera_.orbit(0.003, 0);
    const Image image = draw(board(130));
    const auto owner = renderer_->triangleImage(camera_, kWidth, kHeight);
    int darkest = 255, brightest = 0;
    for (std::size_t i = 0; i < owner.size(); ++i) {
      if (owner[i] == kNone) continue;
      darkest = std::min<int>(darkest, image.pixels()[i][1]);
      brightest = std::max<int>(brightest, image.pixels()[i][1]);
    }
    EXPECT_LT(brightest - darkest, 40) << step;  // of 143
  }
}

TEST_F(Checker, NumbersTellSquaresOfOneColourApart) {
  RenderSettings settings = board(16);
  const auto differing = [&](const Image& image) {
    const glm::ivec2 a = middleOfSquare(16, 2, 2), b = middleOfSquare(16, 4, 2);
    int count = 0;
    for (int y = -6; y <= 6; ++y) {
      for (int x = -6; x <= 6; ++x) {
        const int first = image.at(a.x + x, a.y + y)[0], second = image.at(b.x + x, b.y + y)[0];
        count += std::abs(first - second) > 60 ? 1 : 0;
      }
    }
    return count;
  };
  const int plain = differing(draw(settings));
  settings.checkerKind = CheckerKind::Numbers;
  EXPECT_LT(plain, 4);
  EXPECT_GT(differing(draw(settings)), plain + 8);
}

TEST_F(Checker, CirclesAreRoundOnTheSurface) {
  RenderSettings settings = board(9);
  settings.checkerKind = CheckerKind::Circles;
  const Image image = draw(settings);
  const glm::ivec2 middle = middleOfSquare(9, 2, 2);
  const auto reach = [&](int dx, int dy) {
    int i = 0;
    while (image.at(middle.x + i * dx, middle.y + i * dy)[0] < 163) ++i;
    return i;
  };
  EXPECT_GT(reach(1, 0), 4);
  EXPECT_NEAR(reach(1, 0), reach(0, 1), 1.01);
  EXPECT_NEAR(reach(-1, 0), reach(0, -1), 1.01);
}

TEST_F(Checker, LeansTowardsTheChartsColours) {
  RenderSettings settings = board(3000);
  settings.checkerTint = 1;
  const Image image = draw(settings);
  const glm::ivec2 left = pixelOf(inSpace(3, 4)), right = pixelOf(inSpace(12, 4));
  EXPECT_NE(image.at(left.x, left.y), image.at(right.x, right.y));
}

TEST_F(Checker, FacesWithoutTexturePlaceAreDry) {
  std::vector<glm::vec2> uv = cornerUv();
  const Index bare = 2 * (3 * kColumns + 5);
  for (std::size_t c = 0; c < 3; ++c) {
    uv[std::size_t{3} * bare + c] = glm::vec2(std::numeric_limits<float>::quiet_NaN());
  }
  setCornerUv(uv);
  const Image image = draw(board(40));
  const glm::ivec2 p = pixelOf(middle(bare));
  EXPECT_EQ(image.at(p.x, p.y), (Rgba8{0x6A, 0x6A, 0x6A, 255}));
}

TEST_F(Checker, IsForgottenWithItsTexture) {
  EXPECT_TRUE(renderer_->canShow(ColorMode::Checkerboard));
  setCornerUv({});
  EXPECT_FALSE(renderer_->canShow(ColorMode::Checkerboard));
  RenderSettings plain = flat(ColorMode::Shaded);
  EXPECT_EQ(draw(board(40)), draw(plain));
}

class UnwrapColours : public test::TwoCharts {};

TEST_F(UnwrapColours, RangesBeginAtNoneAndTellTheMean) {
  std::vector<float> values(mesh_->triangleCount(), 1.0f);
  for (std::size_t t = 0; t < values.size(); t += 2) values[t] = 1.5f;
  for (const ColorMode mode : {ColorMode::Stretch, ColorMode::AngleDistortion}) {
    setUnwrap({});
    EXPECT_FALSE(renderer_->canShow(mode));
    setUnwrap({{}, values, values, values});
    const auto range = renderer_->scalarRange(flat(mode));
    ASSERT_TRUE(range);
    EXPECT_EQ(range->min, 1);
    EXPECT_NEAR(range->max, 1.5, 0.06);
    EXPECT_TRUE(range->hasMean);
    EXPECT_NEAR(range->mean, 1.25, 1e-6);
    EXPECT_EQ(range->scale, ScalarScale::Log);
    EXPECT_GE(scalarTicks(*range, 5).size(), 3u);
  }
}

TEST_F(UnwrapColours, AreaIsWhiteWhereThereIsNoneAndDryWhereNothingIsKnown) {
  std::vector<float> values(mesh_->triangleCount(), 0.0f);
  const Index large = 2 * (2 * kColumns + 3), small = 2 * (5 * kColumns + 9), unknown = 40;
  for (Index t = 0; t < 24; ++t) values[large + t % 4] = 1.2f;
  for (Index t = 0; t < 24; ++t) values[small + t % 4] = -1.2f;
  values[unknown] = std::numeric_limits<float>::quiet_NaN();
  setUnwrap({{}, values, values, values});
  const auto range = renderer_->scalarRange(flat(ColorMode::AreaDistortion));
  ASSERT_TRUE(range);
  EXPECT_EQ(range->min, -range->max);
  const Image image = draw(flat(ColorMode::AreaDistortion));
  const auto at = [&](Index triangle) {
    const glm::ivec2 p = pixelOf(middle(triangle));
    return image.at(p.x, p.y);
  };
  EXPECT_GT(std::min({at(0)[0], at(0)[1], at(0)[2]}), 235);
  EXPECT_GT(at(large)[1], at(large)[0]);  // green: too large in the texture
  EXPECT_GT(at(small)[0], at(small)[1]);  // purple: too small
  EXPECT_EQ(at(unknown), (Rgba8{0x6A, 0x6A, 0x6A, 255}));
}

class Cuts : public test::TwoCharts {};

TEST_F(Cuts, AreDashedInAColourOfTheirOwnAndOnlyThere) {
  RenderSettings settings = flat(ColorMode::Charts);
  settings.cutWidth = 3;
  const Image without = draw(settings);
  setCuts(cut());
  const Image with = draw(settings);
  int bright = 0, dark = 0;
  for (double y = 1.2; y < 5.8; y += 0.05) {
    const glm::ivec2 p = pixelOf(inSpace(4, y));
    const Rgba8 color = with.at(p.x, p.y);
    EXPECT_NE(color, without.at(p.x, p.y)) << y;
    if (color[0] > 220 && color[1] > 150 && color[2] < 90) ++bright;
    if (color[0] < 60 && color[1] < 60) ++dark;
  }
  EXPECT_GT(bright, 25);
  EXPECT_GT(dark, 8);
  for (const double x : {2.5, 5.5, 12.5}) {
    const glm::ivec2 p = pixelOf(inSpace(x, 3.5));
    EXPECT_EQ(with.at(p.x, p.y), without.at(p.x, p.y));
  }
  settings.cuts = false;
  EXPECT_EQ(draw(settings), without);
}

TEST_F(Cuts, GoWithAnEmptyList) {
  const RenderSettings settings = flat(ColorMode::Charts);
  const Image without = draw(settings);
  setCuts(cut());
  setCuts({});
  EXPECT_EQ(draw(settings), without);
}

/// The picture's colours lie where the texture has its places: u to the right, v upwards.
TEST_F(Checker, AnOwnPictureFillsTheTextureOnceAndUpright) {
  auto picture = std::make_shared<Image>(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      picture->at(x, y) = {static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(4 * y), 90,
                           255};
    }
  }
  RenderSettings settings = flat(ColorMode::Checkerboard);
  settings.checkerKind = CheckerKind::Picture;
  RenderSettings squares = settings;
  squares.checkerKind = CheckerKind::Squares;
  EXPECT_EQ(draw(settings), draw(squares));  // there is none yet
  settings.checkerPicture = picture;
  const Image image = draw(settings);
  for (Index t = 0; t < mesh_->triangleCount(); t += 3) {
    const glm::dvec2 uv(uvAt(chartOf(t), onPlate(middle(t))));
    const glm::ivec2 p = pixelOf(middle(t));
    EXPECT_NEAR(int{image.at(p.x, p.y)[0]}, 256 * uv.x, 9) << t;
    EXPECT_NEAR(int{image.at(p.x, p.y)[1]}, 256 * (1 - uv.y), 9) << t;
    EXPECT_NEAR(int{image.at(p.x, p.y)[2]}, 90, 1) << t;
  }
}

}  // namespace
}  // namespace chartflood
