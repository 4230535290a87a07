#include "tests/render/scene.h"

namespace chartflood {
namespace {

class Picking : public test::GlTest {};

TEST_F(Picking, EachTriangleIsFoundWhereItIsSeen) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  for (const bool orthographic : {false, true}) {
    camera_.orthographic = orthographic;
    const auto seen = seenTriangles();
    ASSERT_GT(seen.size(), 60u);
    for (std::size_t i = 0; i < seen.size(); i += 7) {
      const auto& [triangle, pixel] = seen[i];
      const Pick found = pick(pixel);
      ASSERT_TRUE(found.hit());
      EXPECT_EQ(found.triangle, triangle);
      EXPECT_EQ(found.face, triangle);
      EXPECT_EQ(found.chart, sides.label[triangle]);
      EXPECT_LT(glm::distance(found.point, middle(triangle)), 0.01);
    }
  }
}

TEST_F(Picking, PolygonsAreFoundByAnyOfTheirTriangles) {
  show(test::quadCube(2));
  for (const auto& [triangle, pixel] : seenTriangles()) {
    EXPECT_EQ(pick(pixel).face, triangle / 2);
  }
}

TEST_F(Picking, OutsideTheModelAndThePictureIsNothing) {
  show(test::cube(2));
  EXPECT_FALSE(pick({0, 0}).hit());
  EXPECT_FALSE(pick({-1, 5}).hit());
  EXPECT_FALSE(pick({kWidth, 5}).hit());
}

TEST_F(Picking, HiddenChartsAreSeenThrough) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  const auto [triangle, pixel] = seenTriangles().front();
  const Pick behind = pick(pixel, {sides.label[triangle]});
  ASSERT_TRUE(behind.hit());
  EXPECT_NE(behind.chart, sides.label[triangle]);
}

TEST_F(Picking, NumbersStandInsideTheirVisibleChart) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  setCharts(sides);
  const RenderSettings settings = flat(ColorMode::Charts);
  draw(settings);
  const auto labels = renderer_->chartLabels(camera_, settings, 1600, 1200);
  EXPECT_EQ(labels.size(), 3u);
  for (const ChartLabel& label : labels) {
    const Pick found = pick(glm::ivec2(label.place), {}, 1600, 1200);
    EXPECT_EQ(found.chart, label.chart);
    EXPECT_GT(label.room, 50);
  }
}

}  // namespace
}  // namespace chartflood
