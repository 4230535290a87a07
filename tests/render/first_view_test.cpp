#include "render/scene/first_view.h"

#include <array>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/model/build_mesh.h"
#include "tests/render/shapes.h"

namespace chartflood {
namespace {

/// A box with its lowest corner at 0; open below where it has no bottom.
std::shared_ptr<const Mesh> box(const glm::dvec3& size, const char* file = "") {
  auto input = std::make_shared<InputMesh>();
  input->file = file;
  input->faceStart = {0};
  for (int i = 0; i < 8; ++i) {
    input->positions.emplace_back((i & 1) * size.x, ((i >> 1) & 1) * size.y,
                                  ((i >> 2) & 1) * size.z);
  }
  for (const auto& [a, b, c, d] : {std::array<Index, 4>{0, 2, 3, 1},
                                   {4, 5, 7, 6},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    for (const Index corner : {a, b, c, d}) input->corners.push_back(corner);
    input->faceStart.push_back(input->corners.size());
  }
  return buildMesh(std::move(input));
}

TEST(FirstView, ATallBoxStandsAlongItsHeight) {
  EXPECT_EQ(likelyUpAxis(*box({1, 1, 3})), UpAxis::Z);
  EXPECT_EQ(likelyUpAxis(*box({1, 3, 1})), UpAxis::Y);
  EXPECT_EQ(likelyUpAxis(*box({1, 1, 1})), UpAxis::Y);
}

TEST(FirstView, WhatTheFormatSaysWins) {
  EXPECT_EQ(likelyUpAxis(*box({1, 1, 3}, "a.glb")), UpAxis::Y);
  EXPECT_EQ(likelyUpAxis(*box({1, 3, 1}, "a.3MF")), UpAxis::Z);
}

TEST(FirstView, AFlatSupportTells) {
  EXPECT_EQ(likelyUpAxis(*test::plate(4, 3)), UpAxis::Y) << "seen from above it supports nothing";
  auto input = std::make_shared<InputMesh>();
  // A pyramid on a square in the xy plane.
  input->positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}};
  input->corners = {0, 3, 2, 1, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  input->faceStart = {0, 4, 7, 10, 13, 16};
  EXPECT_EQ(likelyUpAxis(*buildMesh(std::move(input))), UpAxis::Z);
}

TEST(FirstView, NoFlatSideFacesTheEye) {
  for (const glm::dvec3& size : {glm::dvec3(3, 1, 1), glm::dvec3(1, 1, 3), glm::dvec3(1, 1, 1),
                                 glm::dvec3(3, 2, 0.2), glm::dvec3(0.2, 2, 3)}) {
    Camera camera;
    lookAtFirst(camera, *box(size));
    for (const glm::dvec3& side : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
      const double facing = std::abs(glm::dot(camera.forward(), side));
      EXPECT_LT(facing, 0.9) << size.x << ' ' << size.y << ' ' << size.z;
      EXPECT_GT(facing, 0.2) << "three sides are seen";
    }
    EXPECT_LT(camera.forward().y, 0) << "from above";
    EXPECT_NEAR(glm::dot(camera.right(), glm::dvec3(0, 1, 0)), 0, 1e-9) << "upright";
  }
}

}  // namespace
}  // namespace chartflood
