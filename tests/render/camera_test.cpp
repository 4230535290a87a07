#include "render/scene/camera.h"

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace chartflood {
namespace {

std::vector<glm::dvec3> boxCorners(const glm::dvec3& low, const glm::dvec3& high) {
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  }
  return corners;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Camera, FrontViewLooksAlongMinusZWithYUp) {
  Camera camera;
  camera.look(StandardView::Front);
  expectNear(camera.forward(), {0, 0, -1});
  expectNear(camera.upward(), {0, 1, 0});
  expectNear(camera.eye(), {0, 0, 2});
}

TEST(Camera, FrontViewOfAZUpModelLooksAlongPlusY) {
  Camera camera;
  camera.up = UpAxis::Z;
  camera.look(StandardView::Front);
  expectNear(camera.forward(), {0, 1, 0});
  expectNear(camera.upward(), {0, 0, 1});
  EXPECT_NEAR(camera.azimuthDegrees(), 0, 1e-9);
}

TEST(Camera, StandardViewsAreReachedByOrbiting) {
  Camera camera, right;
  camera.look(StandardView::Front);
  right.look(StandardView::Right);
  camera.orbit(-std::acos(-1.0) / 2, 0);
  expectNear(camera.forward(), right.forward());
  expectNear(camera.upward(), right.upward());
}

TEST(Camera, OrbitKeepsTargetAndDistanceAndHorizon) {
  Camera camera;
  camera.target = {0.1, 0.2, 0.3};
  camera.look(StandardView::Front);
  for (int i = 0; i < 100; ++i) camera.orbit(0.37, 0.11 * std::sin(i));
  EXPECT_NEAR(glm::distance(camera.eye(), camera.target), camera.distance, 1e-9);
  EXPECT_NEAR(camera.right().y, 0, 1e-9);
}

TEST(Camera, OrbitStopsAtThePole) {
  Camera camera;
  camera.look(StandardView::Front);
  camera.orbit(0, 10);
  EXPECT_NEAR(camera.elevationDegrees(), 90, 1e-6);
  camera.orbit(0, 1);
  EXPECT_NEAR(camera.elevationDegrees(), 90, 1e-6);
  camera.orbit(0, -std::acos(-1.0) / 4);
  EXPECT_NEAR(camera.elevationDegrees(), 45, 1e-6);
}

TEST(Camera, TrackballBringsTheGraspedPointToTheHand) {
  Camera camera;
  camera.look(StandardView::Front);
  // A quarter of the way to the right on the ball: the front side must turn to the right.
  camera.trackball({0, 0}, {0.5, 0}, 1);
  EXPECT_GT(camera.project({0, 0, 0.4}, 1, {}).x, 0.05);
  camera.trackball({0.5, 0}, {0, 0}, 1);
  EXPECT_NEAR(camera.project({0, 0, 0.4}, 1, {}).x, 0, 1e-9);
}

TEST(Camera, ZoomKeepsThePlaceUnderTheCursor) {
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = orthographic;
    camera.look(StandardView::Oblique);
    const glm::dvec2 cursor(0.6, -0.3);
    const double aspect = 1.5;
    const Ray ray = camera.ray(cursor, aspect);
    const double along = glm::dot(camera.target - ray.origin, camera.forward()) /
                         glm::dot(ray.direction, camera.forward());
    const glm::dvec3 point = ray.origin + ray.direction * along;
    const double before = camera.halfHeight();
    camera.zoom(1.7, cursor, aspect);
    EXPECT_NEAR(camera.halfHeight(), before / 1.7, 1e-12);
    const glm::dvec3 after = camera.project(point, aspect, {});
    EXPECT_NEAR(after.x, cursor.x, 1e-9);
    EXPECT_NEAR(after.y, cursor.y, 1e-9);
  }
}

TEST(Camera, PanMovesThePointUnderTheCursorWithIt) {
  Camera camera;
  camera.look(StandardView::Left);
  const glm::dvec2 from(-0.2, 0.1), to(0.5, -0.4);
  camera.pan(from, to, 2);
  const glm::dvec3 origin = camera.project({0, 0, 0}, 2, {});
  EXPECT_NEAR(origin.x, to.x - from.x, 1e-9);
  EXPECT_NEAR(origin.y, to.y - from.y, 1e-9);
}

TEST(Camera, RayAndProjectionAgree) {
  for (const bool orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = orthographic;
    camera.look(StandardView::Oblique);
    const Ray ray = camera.ray({0.3, 0.7}, 1.25);
    for (const double along : {1.7, 2.0, 2.3}) {
      const glm::dvec3 p = camera.project(ray.origin + ray.direction * along, 1.25, {});
      EXPECT_NEAR(p.x, 0.3, 1e-9);
      EXPECT_NEAR(p.y, 0.7, 1e-9);
    }
  }
}

TEST(Camera, FrameTouchesTheMarginFromInside) {
  for (const bool orthographic : {false, true}) {
    for (const double aspect : {0.5, 1.0, 2.4}) {
      for (const double inset : {0.0, 0.2}) {
        Camera camera;
        camera.orthographic = orthographic;
        camera.look(StandardView::Oblique);
        const auto corners = boxCorners({1, 2, 3}, {1.4, 2.1, 3.9});
        camera.frame(corners, aspect, 0.05, inset);
        const BoundingSphere bounds = boundingSphere(corners);
        double right = -2, left = 2, top = -2, bottom = 2;
        for (const glm::dvec3& corner : corners) {
          const glm::dvec3 p = camera.project(corner, aspect, bounds);
          right = std::max(right, p.x);
          left = std::min(left, p.x);
          top = std::max(top, p.y);
          bottom = std::min(bottom, p.y);
          EXPECT_GT(p.z, -1);
          EXPECT_LT(p.z, 1);
        }
        EXPECT_LT(right, 0.9 - 2 * inset + 1e-9);
        EXPECT_GT(left, -0.9 - 1e-9);
        EXPECT_LT(top, 0.9 + 1e-9);
        EXPECT_GT(bottom, -0.9 - 1e-9);
        const bool touchesSides = right > 0.9 - 2 * inset - 1e-6 && left < -0.9 + 1e-6;
        const bool touchesEnds = top > 0.9 - 1e-6 && bottom < -0.9 + 1e-6;
        EXPECT_TRUE(touchesSides || touchesEnds);
      }
    }
  }
}

TEST(Camera, NearAndFarHoldModelsOfAnySize) {
  for (const double size : {1e-4, 1.0, 1e4}) {
    Camera camera;
    camera.look(StandardView::Oblique);
    const auto corners = boxCorners(glm::dvec3(-size), glm::dvec3(size));
    camera.frame(corners, 1);
    const BoundingSphere bounds = boundingSphere(corners);
    EXPECT_LT(camera.project(camera.forward() * size, 1, bounds).z, 1);
    EXPECT_GT(camera.project(-camera.forward() * size, 1, bounds).z, -1);
  }
}

TEST(Camera, SwitchingToOrthographicKeepsSizeAtTheTarget) {
  Camera camera;
  camera.look(StandardView::Front);
  const double perspective = camera.project({0.2, 0, 0}, 1, {}).x;
  camera.orthographic = true;
  EXPECT_NEAR(camera.project({0.2, 0, 0}, 1, {}).x, perspective, 1e-12);
}

TEST(Camera, UnknownViewIsRefusedByName) {
  EXPECT_EQ(standardViewFromId("top"), StandardView::Top);
  EXPECT_THROW(standardViewFromId("sideways"), UsageError);
}

}  // namespace
}  // namespace chartflood
