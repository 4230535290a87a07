#include "tests/render/scene.h"

namespace chartflood {
namespace {

class Picking : public test::GlTest {};

TEST_F(Picking, EachTriangleIsFoundWhereItIsSeen) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  renderer_->setSegmentation(&sides);
  for (const bool orthographic : {false, true}) {
    camera_.orthographic = orthographic;
    const auto seen = seenTriangles();
    ASSERT_GT(seen.size(), 60u);
    for (std::size_t i = 0; i < seen.size(); i += 7) {
      const auto& [triangle, pixel] = seen[i];
      const Pick pick = renderer_->pick(camera_, kWidth, kHeight, pixel.x, pixel.y);
      ASSERT_TRUE(pick.hit());
      EXPECT_EQ(pick.triangle, triangle);
      EXPECT_EQ(pick.face, triangle);
      EXPECT_EQ(pick.chart, sides.label[triangle]);
      EXPECT_LT(glm::distance(pick.point, middle(triangle)), 0.01);
    }
  }
}

TEST_F(Picking, PolygonsAreFoundByAnyOfTheirTriangles) {
  show(test::quadCube(2));
  for (const auto& [triangle, pixel] : seenTriangles()) {
    EXPECT_EQ(renderer_->pick(camera_, kWidth, kHeight, pixel.x, pixel.y).face, triangle / 2);
  }
}

TEST_F(Picking, OutsideTheModelAndThePictureIsNothing) {
  show(test::cube(2));
  EXPECT_FALSE(renderer_->pick(camera_, kWidth, kHeight, 0, 0).hit());
  EXPECT_FALSE(renderer_->pick(camera_, kWidth, kHeight, -1, 5).hit());
  EXPECT_FALSE(renderer_->pick(camera_, kWidth, kHeight, kWidth, 5).hit());
}

TEST_F(Picking, HiddenChartsAreSeenThrough) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  renderer_->setSegmentation(&sides);
  const auto [triangle, pixel] = seenTriangles().front();
  RenderSettings settings = flat(ColorMode::Charts);
  settings.hiddenCharts = {sides.label[triangle]};
  draw(settings);
  const Pick behind = renderer_->pick(camera_, kWidth, kHeight, pixel.x, pixel.y);
  ASSERT_TRUE(behind.hit());
  EXPECT_NE(behind.chart, sides.label[triangle]);
}

TEST_F(Picking, NumbersStandInsideTheirVisibleChart) {
  show(test::cube(4));
  const Segmentation sides = cubeSides();
  renderer_->setSegmentation(&sides);
  const RenderSettings settings = flat(ColorMode::Charts);
  draw(settings);
  const auto labels = renderer_->chartLabels(camera_, settings, 1600, 1200);
  EXPECT_EQ(labels.size(), 3u);
  for (const ChartLabel& label : labels) {
    const Pick pick = renderer_->pick(camera_, 1600, 1200, static_cast<int>(label.place.x),
                                      static_cast<int>(label.place.y));
    EXPECT_EQ(pick.chart, label.chart);
    EXPECT_GT(label.room, 50);
  }
}

}  // namespace
}  // namespace chartflood
