#include <gtest/gtest.h>

#include "render/scene/uv_camera.h"

namespace chartflood {
namespace {

void expectNear(const glm::dvec2& a, const glm::dvec2& b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(UvCamera, PixelsAndTexturePlacesAreInverse) {
  UvCamera camera;
  camera.center = {0.3, 0.7};
  camera.span = 0.21;
  for (const glm::dvec2 size : {glm::dvec2(400, 300), glm::dvec2(200, 900)}) {
    for (const glm::dvec2 uv : {glm::dvec2(0, 0), glm::dvec2(0.31, 0.72), glm::dvec2(-3, 5)}) {
      expectNear(camera.toUv(camera.toPixel(uv, size), size), uv);
    }
  }
}

TEST(UvCamera, TheExactOneShowsTheTextureAndNothingElse) {
  const glm::dvec2 size(512, 512);
  expectNear(UvCamera::exact().toPixel({0, 0}, size), {0, 512});
  expectNear(UvCamera::exact().toPixel({1, 1}, size), {512, 0});
}

TEST(UvCamera, TheWholeTextureIsSeenInAnyShape) {
  for (const glm::dvec2 size : {glm::dvec2(800, 200), glm::dvec2(150, 700)}) {
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1, 1)}) {
      const glm::dvec2 p = UvCamera::whole().toPixel(corner, size);
      EXPECT_GT(p.x, 0);
      EXPECT_GT(p.y, 0);
      EXPECT_LT(p.x, size.x);
      EXPECT_LT(p.y, size.y);
    }
  }
}

TEST(UvCamera, ZoomKeepsThePlaceUnderThePointer) {
  const glm::dvec2 size(400, 300), pointer(97, 211);
  UvCamera camera;
  const glm::dvec2 before = camera.toUv(pointer, size);
  camera.zoom(2.5, pointer, size);
  expectNear(camera.toUv(pointer, size), before);
  EXPECT_NEAR(camera.span, UvCamera{}.span / 2.5, 1e-12);
  camera.zoom(1 / 2.5, pointer, size);
  expectNear(camera.center, UvCamera{}.center);
}

TEST(UvCamera, ZoomStopsAtItsLimits) {
  UvCamera camera;
  for (int i = 0; i < 100; ++i) camera.zoom(3, {10, 10}, {100, 100});
  EXPECT_EQ(camera.span, UvCamera::kLeastSpan);
  for (int i = 0; i < 100; ++i) camera.zoom(1 / 3.0, {10, 10}, {100, 100});
  EXPECT_EQ(camera.span, UvCamera::kMostSpan);
}

TEST(UvCamera, PanCarriesThePlaceAlong) {
  const glm::dvec2 size(400, 300), from(100, 100), to(131, 84);
  UvCamera camera;
  const glm::dvec2 place = camera.toUv(from, size);
  camera.pan(from, to, size);
  expectNear(camera.toUv(to, size), place);
}

TEST(UvCamera, FramesABox) {
  const glm::dvec2 size(400, 200);
  UvCamera camera;
  camera.frame({0.2, 0.4}, {0.3, 0.44}, size);
  const glm::dvec2 low = camera.toPixel({0.2, 0.4}, size), high = camera.toPixel({0.3, 0.44}, size);
  EXPECT_NEAR(0.5 * (low.x + high.x), 200, 1e-6);
  EXPECT_NEAR(0.5 * (low.y + high.y), 100, 1e-6);
  EXPECT_GT(high.x - low.x, 300);
  EXPECT_LT(high.x - low.x, 400);
}

}  // namespace
}  // namespace chartflood
