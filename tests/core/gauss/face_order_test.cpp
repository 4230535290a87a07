// Gauss areas do not hang on the order of faces and their corners: core/gauss.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/gauss/compute_gauss_area.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

void expectSameInAnyOrder(const Mesh& mesh) {
  for (const double angle : {20.0, 45.0, 180.0}) {
    const GaussArea expected = computeGaussArea(mesh, angle);
    for (const std::uint32_t seed : {1u, 2u}) {
      const auto shuffled = test::rebuild(test::shuffledFaces(mesh.input(), seed));
      const GaussArea found = computeGaussArea(*shuffled, angle);
      EXPECT_NEAR(found.total(), expected.total(), 1e-9 * expected.total()) << angle;
      EXPECT_NEAR(found.signedTotal, expected.signedTotal, 1e-6) << angle;
    }
  }
}

class RealMeshes : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Folder, RealMeshes,
                         testing::Values("happy-buddha-20000.obj", "happy-buddha-19976.ply",
                                         "rocker-arm.obj", "fandisk.obj", "homer.obj", "cow.obj",
                                         "bones.off", "cheese.off", "anchor_dense.off"));

TEST_P(RealMeshes, HaveOneGaussAreaInAnyOrder) {
  const auto mesh = test::realMesh(GetParam());
  if (!mesh) GTEST_SKIP() << "the folder of real meshes is not there";
  if (!mesh->facesAreTriangles()) GTEST_SKIP() << "diagonals hang on the first corner";
  expectSameInAnyOrder(*mesh);
}

TEST(SignedGaussArea, IsThatOfTheEulerNumberWhereNothingFolds) {
  for (const char* file : {"rocker-arm.obj", "fandisk.obj", "homer.obj", "casting.off",
                           "bracket-3.stl", "armadillo-80354.ply"}) {
    const auto mesh = test::realMesh(file);
    if (!mesh) GTEST_SKIP() << "the folder of real meshes is not there";
    ASSERT_TRUE(mesh->closed());
    EXPECT_NEAR(computeGaussArea(*mesh, 45).signedTotal,
                2 * std::numbers::pi * static_cast<double>(mesh->eulerNumber()), 1e-6)
        << file;
  }
}

TEST(FaceOrder, FoldedSheetsHaveOneGaussArea) {
  // A grid crumpled onto few places, so that faces lie on each other and normals are opposite.
  InputMesh input = test::copyInput(*test::grid(14, true));
  for (auto& p : input.positions) {
    p = {std::fabs(std::fmod(p.x, 4.0) - 2), std::fabs(std::fmod(p.y, 6.0) - 3),
         static_cast<double>(static_cast<int>(p.x + p.y) % 3 == 0)};
  }
  expectSameInAnyOrder(*test::rebuild(input));
}

}  // namespace
}  // namespace chartflood
