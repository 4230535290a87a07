// Marks of problems in pictures: where they are, that patterns differ by more than colour, and that
// nothing else changes.

#include <array>

#include "tests/render/two_charts.h"

namespace chartflood {
namespace {

class MarkPixels : public test::TwoCharts {
 protected:
  static constexpr int kSize = 300;

  static RenderSettings marked() {
    RenderSettings settings = flat(ColorMode::Charts);
    settings.problems = true;
    return settings;
  }
  Image drawUv(const RenderSettings& settings) {
    return renderUvImage(*renderer_, UvCamera::exact(), settings, {.frame = false},
                         {kSize, kSize, 1, 1});
  }
  /// Marks the left half of the plate.
  SurfaceMarks leftHalf(TriangleMark mark) const {
    SurfaceMarks marks;
    for (Index t = 0; t < mesh_->triangleCount(); ++t) {
      marks.triangles.push_back(chartOf(t) == 0 ? mark : TriangleMark::None);
    }
    return marks;
  }
  /// Share of a mark's colour among the pixels of the charts' colours that it replaces.
  static double share(const Image& plain, const Image& image, const Rgba8& chart,
                      const glm::vec3& color) {
    const Rgba8 wanted = test::toRgba8(color);
    int all = 0, found = 0;
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
      if (plain.pixels()[i] != chart) continue;
      ++all;
      found += image.pixels()[i] == wanted ? 1 : 0;
    }
    return all == 0 ? 0 : static_cast<double>(found) / all;
  }
};

TEST_F(MarkPixels, EachPatternCoversItsShareOfTheMarkedChartAlone) {
  const RenderSettings settings = marked();
  RenderSettings off = settings;
  off.problems = false;
  const Image plain = draw(off), plainUv = drawUv(off);
  const Rgba8 left = test::toRgba8(renderer_->chartColor(0, settings));
  const Rgba8 right = test::toRgba8(renderer_->chartColor(1, settings));
  struct Case {
    TriangleMark mark;
    double least, most;
  };
  // Without the smooth edges; half, three quarters, half, and discs of radius 0.3.
  const Case cases[] = {{TriangleMark::Stripes, 0.25, 0.50},
                        {TriangleMark::Lattice, 0.45, 0.75},
                        {TriangleMark::Bars, 0.25, 0.50},
                        {TriangleMark::Dots, 0.10, 0.29}};
  for (const Case& each : cases) {
    setMarks(leftHalf(each.mark));
    const Image image = draw(settings), texture = drawUv(settings);
    const glm::vec3 color = markColor(each.mark);
    EXPECT_GE(share(plain, image, left, color), each.least) << static_cast<int>(each.mark);
    EXPECT_LE(share(plain, image, left, color), each.most) << static_cast<int>(each.mark);
    EXPECT_GE(share(plainUv, texture, left, color), each.least) << static_cast<int>(each.mark);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
      if (plain.pixels()[i] == right) {
        ASSERT_EQ(image.pixels()[i], right);
      }
    }
    EXPECT_EQ(draw(off), plain);
    EXPECT_EQ(drawUv(off), plainUv);
  }
}

TEST_F(MarkPixels, PatternsDifferWithoutColour) {
  const RenderSettings settings = marked();
  const glm::ivec2 corner = pixelOf(mesh_->positions()[0]), far = pixelOf(middle(2 * (7 * 16 + 7)));
  // How often the pattern begins along a row and along a column.
  const auto changes = [&](TriangleMark mark) {
    setMarks(leftHalf(mark));
    const Image image = draw(settings);
    const Rgba8 color = test::toRgba8(markColor(mark));
    std::array<int, 2> count{};
    const int midX = (corner.x + far.x) / 2, midY = (corner.y + far.y) / 2;
    for (int x = corner.x + 1; x < far.x; ++x) {
      count[0] += (image.at(x, midY) == color) != (image.at(x - 1, midY) == color) ? 1 : 0;
    }
    for (int y = far.y + 1; y < corner.y; ++y) {
      count[1] += (image.at(midX, y) == color) != (image.at(midX, y - 1) == color) ? 1 : 0;
    }
    return count;
  };
  const auto bars = changes(TriangleMark::Bars), stripes = changes(TriangleMark::Stripes);
  EXPECT_EQ(bars[0], 0);
  EXPECT_GT(bars[1], 6);
  EXPECT_GT(stripes[0], 6);
  EXPECT_GT(stripes[1], 4);
}

TEST_F(MarkPixels, PicturesInPartsAreThePicturesAsAWhole) {
  setMarks(leftHalf(TriangleMark::Lattice));
  PictureSize whole{.width = kWidth, .height = kHeight, .supersampling = 1, .samples = 1};
  PictureSize parts = whole;
  parts.largestPart = 100;
  const ImageDifference difference =
      compareImages(renderImage(*renderer_, camera_, marked(), whole),
                    renderImage(*renderer_, camera_, marked(), parts), 40);
  EXPECT_LT(difference.differentPixels, 60u);  // edges of triangles may be rounded otherwise
}

TEST_F(MarkPixels, LinesAreOnTheModelAndInTheTexture) {
  SurfaceMarks marks;
  marks.lines.push_back({cut(), {0.2f, 0.8f, 0.9f}, 4, false});
  const auto count = [&](const Image& image) {
    int found = 0;
    for (const Rgba8& p : image.pixels()) found += p == test::toRgba8({0.2f, 0.8f, 0.9f}) ? 1 : 0;
    return found;
  };
  EXPECT_EQ(count(draw(marked())), 0);
  setMarks(marks);
  EXPECT_GT(count(draw(marked())), 60);
  EXPECT_GT(count(drawUv(marked())), 60);
  // Another texture has them elsewhere, none has them nowhere.
  const Image before = drawUv(marked());
  std::vector<glm::vec2> moved = cornerUv();
  for (glm::vec2& uv : moved) uv.x += 0.02f;
  setCornerUv(moved);
  EXPECT_NE(drawUv(marked()), before);
  EXPECT_GT(count(drawUv(marked())), 60);
  setCornerUv({});
  EXPECT_EQ(count(drawUv(marked())), 0);
  setMarks({});
  EXPECT_EQ(count(draw(marked())), 0);
}

}  // namespace
}  // namespace chartflood
