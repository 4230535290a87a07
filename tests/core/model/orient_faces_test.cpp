// Turning faces over: core/model/orient_faces, through buildMesh().

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/gauss/compute_gauss_area.h"
#include "core/model/build_mesh.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

using test::repairCount;

/// Turns a share of the faces of a mesh over. \returns which
std::vector<bool> turnSome(InputMesh& input, double share, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<bool> turned(input.faceCount());
  for (std::size_t f = 0; f < turned.size(); ++f) {
    turned[f] = static_cast<double>(random() % 10000) < 10000 * share;
    if (!turned[f]) continue;
    const auto face = input.face(f);
    const auto begin = input.corners.begin() + (face.data() - input.corners.data());
    std::reverse(begin, begin + static_cast<std::ptrdiff_t>(face.size()));
  }
  return turned;
}

/// A strip of quads that closes after `twists` half turns.
InputMesh strip(Index quads, int twists) {
  InputMesh input;
  input.file = "strip";
  input.faceStart.push_back(0);
  for (Index i = 0; i < quads; ++i) {
    const double around = 2 * std::numbers::pi * i / quads, tilt = around * twists / 2;
    for (const double side : {-0.3, 0.3}) {
      const double radius = 1 + side * std::cos(tilt);
      input.positions.emplace_back(radius * std::cos(around), radius * std::sin(around),
                                   side * std::sin(tilt));
    }
    const bool last = i + 1 == quads;
    const Index a = 2 * i, b = a + 1, c = last ? (twists % 2 == 0 ? 0 : 1) : a + 2;
    const Index d = last ? (twists % 2 == 0 ? 1 : 0) : a + 3;
    input.corners.insert(input.corners.end(), {a, c, d, b});
    input.faceStart.push_back(input.corners.size());
  }
  return input;
}

class TurnedSamples : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, TurnedSamples,
                         testing::Values("sphere", "torus", "rocket", "tube", "double-torus"));

TEST_P(TurnedSamples, AreOnePartWithTheSameGaussAreaWhateverIsTurned) {
  const auto whole = test::sampleMesh(GetParam(), 2500);
  const GaussArea expected = computeGaussArea(*whole, 45);
  for (const double share : {0.0005, 0.1, 0.4, 0.49}) {
    SCOPED_TRACE(share);
    InputMesh input = test::copyInput(*whole);
    const std::vector<bool> turned = turnSome(input, share, 7);
    const auto count = static_cast<std::size_t>(std::count(turned.begin(), turned.end(), true));
    const auto mesh = test::rebuild(std::move(input));
    EXPECT_EQ(repairCount(*mesh, "turned-faces"), count);
    EXPECT_EQ(repairCount(*mesh, "inconsistent-edges"), 0u);
    EXPECT_EQ(mesh->componentCount(), whole->componentCount());
    EXPECT_EQ(mesh->genus(), whole->genus());
    EXPECT_EQ(mesh->boundaryLoopCount(), whole->boundaryLoopCount());
    for (Index f = 0; f < mesh->faceCount(); ++f) ASSERT_EQ(mesh->turned(f), turned[f]) << f;
    EXPECT_NEAR(computeGaussArea(*mesh, 45).total(), expected.total(),
                1e-9 * std::max(1.0, expected.total()));
  }
}

TEST(OrientFaces, KeepsTheCornersOfTheFile) {
  for (const bool triangles : {true, false}) {
    InputMesh input = test::copyInput(*test::grid(9, triangles));
    turnSome(input, 0.3, 3);
    const auto mesh = test::rebuild(input);
    EXPECT_EQ(mesh->componentCount(), 1u);
    for (Index s = 0; s < 3 * mesh->triangleCount(); ++s) {
      ASSERT_EQ(input.corners[mesh->inputCorner(s)], mesh->inputVertex(mesh->sideStart(s)));
    }
  }
}

TEST(OrientFaces, TheFirstFaceStaysWhereTheNumbersAreEqual) {
  // Two triangles side by side, running against each other.
  const auto mesh =
      test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 2, 3}});
  EXPECT_EQ(mesh->componentCount(), 1u);
  EXPECT_FALSE(mesh->turned(0));
  EXPECT_TRUE(mesh->turned(1));
}

TEST(OrientFaces, EveryPartHasAMajorityOfItsOwn) {
  // Two tetrahedra; of the second, one face agrees with no other.
  const test::Polygons faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2},
                                {4, 5, 6}, {4, 5, 7}, {5, 6, 7}, {4, 7, 6}};
  const auto mesh = test::meshOf(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
      faces);
  EXPECT_EQ(mesh->componentCount(), 2u);
  EXPECT_TRUE(mesh->closed());
  EXPECT_TRUE(mesh->turned(4));
  EXPECT_EQ(repairCount(*mesh, "turned-faces"), 1u);
}

TEST(OrientFaces, SplitsAMoebiusStripWhereItsFacesDisagree) {
  const auto ring = test::rebuild(strip(40, 2));
  EXPECT_EQ(ring->boundaryLoopCount(), 2u);
  EXPECT_TRUE(ring->repairs().empty());
  const auto moebius = test::rebuild(strip(40, 1));
  EXPECT_EQ(repairCount(*moebius, "inconsistent-edges"), 1u);
  EXPECT_EQ(repairCount(*moebius, "turned-faces"), 0u);
  EXPECT_EQ(moebius->componentCount(), 1u);
  EXPECT_EQ(moebius->boundaryLoopCount(), 1u);
}

TEST(OrientFaces, SplitsAMoebiusStripOnceWhateverIsTurned) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    InputMesh input = strip(40, 1);
    turnSome(input, 0.4, seed);
    const auto mesh = test::rebuild(std::move(input));
    EXPECT_EQ(repairCount(*mesh, "inconsistent-edges"), 1u) << seed;
    EXPECT_EQ(mesh->componentCount(), 1u) << seed;
    EXPECT_EQ(mesh->boundaryLoopCount(), 1u) << seed;
  }
}

TEST(OrientFaces, NamesFacesThatAreLeftAlone) {
  // Three triangles about one edge: none of them has another neighbour.
  const auto book = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}},
                                 {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(repairCount(*book, "lone-faces"), 3u);
  EXPECT_EQ(
      repairCount(*test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), "lone-faces"), 0u);
}

}  // namespace
}  // namespace chartflood
