// Joining vertices at one place: core/model/weld_borders, through buildMesh().

#include <memory>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "core/gauss/compute_gauss_area.h"
#include "core/gauss/sharp_edges.h"
#include "core/model/build_mesh.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

using test::repairCount;

/// Appends a unit cube of quads; `split`: every side has vertices of its own.
void addCube(InputMesh& input, const glm::dvec3& at, bool split) {
  const std::array<std::array<Index, 4>, 6> faces = {
      {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};
  const auto corner = [&](Index i) { return at + glm::dvec3(i / 4, i / 2 % 2, i % 2); };
  if (input.faceStart.empty()) input.faceStart.push_back(0);
  const Index first = static_cast<Index>(input.positions.size());
  if (!split) {
    for (Index i = 0; i < 8; ++i) input.positions.push_back(corner(i));
  }
  for (const auto& face : faces) {
    for (const Index i : face) {
      input.corners.push_back(split ? static_cast<Index>(input.positions.size()) : first + i);
      if (split) input.positions.push_back(corner(i));
    }
    input.faceStart.push_back(input.corners.size());
  }
}

/// A flat grid of n x n faces, and the same from behind with vertices of its own.
InputMesh doubleSided(Index n, bool triangles) {
  InputMesh input = test::copyInput(*test::grid(n, triangles));
  const Index vertices = static_cast<Index>(input.positions.size());
  const std::size_t faces = input.faceCount();
  const std::vector<glm::dvec3> copies = input.positions;
  input.positions.insert(input.positions.end(), copies.begin(), copies.end());
  for (std::size_t f = 0; f < faces; ++f) {
    std::vector<Index> face(input.face(f).begin(), input.face(f).end());
    for (auto v = face.rbegin(); v != face.rend(); ++v) input.corners.push_back(vertices + *v);
    if (!input.faceStart.empty()) input.faceStart.push_back(input.corners.size());
  }
  return input;
}

/// Gives corners vertices of their own at the given share of vertices' smooth sectors: everywhere
/// across a sharp edge, and in a few other places.
InputMesh splitAtCreases(const Mesh& mesh, double sharpAngle, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto sharp = findSharpSides(mesh, sharpAngle);
  const auto cut = [&](Index side) {
    const Index other = mesh.opposite()[side];
    if (other == kNone) return true;
    return sharp[side] != 0 || (std::min(side, other) * 2654435761u ^ seed) % 16 == 0;
  };
  InputMesh out = mesh.input();
  std::vector<bool> visited(3 * mesh.triangleCount(), false);
  std::set<Index> taken;
  for (Index s = 0; s < visited.size(); ++s) {
    if (visited[s]) continue;
    Index first = s;
    for (Index back = s; !cut(back);) {
      back = Mesh::nextSide(mesh.opposite()[back]);
      first = back;
      if (back == s) break;
    }
    const Index old = mesh.inputVertex(mesh.sideStart(s));
    Index vertex = old;
    if (!taken.insert(old).second) {
      vertex = static_cast<Index>(out.positions.size());
      const glm::dvec3 p = out.positions[old];
      out.positions.push_back(p);
    }
    for (Index side = first; !visited[side];) {
      visited[side] = true;
      out.corners[mesh.inputCorner(side)] = vertex;
      const Index previous = Mesh::previousSide(side);
      if (cut(previous)) break;
      side = mesh.opposite()[previous];
    }
  }
  return out;
}

std::shared_ptr<const Mesh> build(const InputMesh& input, double weld) {
  return buildMesh(std::make_shared<const InputMesh>(input), weld);
}

TEST(WeldBorders, MakesOneCubeOfSixSides) {
  InputMesh input;
  addCube(input, {0, 0, 0}, true);
  const auto apart = build(input, kNoWeld);
  EXPECT_EQ(apart->componentCount(), 6u);
  EXPECT_TRUE(apart->repairs().empty());
  const auto cube = build(input, 0);
  EXPECT_EQ(cube->componentCount(), 1u);
  EXPECT_TRUE(cube->closed());
  EXPECT_EQ(cube->eulerNumber(), 2);
  EXPECT_EQ(repairCount(*cube, "welded-vertices"), 16u);
  EXPECT_EQ(computeGaussArea(*cube, 45).sharpEdges.size(), 12u);
  EXPECT_EQ(cube->input().positions.size(), 24u);
}

TEST(WeldBorders, LeavesBoxesThatTouchAsTheyAre) {
  for (const glm::dvec3& at : {glm::dvec3(1, 0, 0), {1, 1, 0}, {1, 1, 1}}) {
    InputMesh input;
    addCube(input, {0, 0, 0}, false);
    addCube(input, at, false);
    const auto mesh = build(input, 0);
    EXPECT_EQ(mesh->componentCount(), 2u);
    EXPECT_TRUE(mesh->closed());
    EXPECT_TRUE(mesh->repairs().empty());
  }
}

TEST(WeldBorders, JoinsBoxesInPiecesAwayFromWhereTheyTouch) {
  InputMesh edge;  // along an edge, which has four sides
  addCube(edge, {0, 0, 0}, true);
  addCube(edge, {1, 1, 0}, true);
  EXPECT_EQ(build(edge, 0)->componentCount(), 2u);
  InputMesh face;  // the two sides that touch stay alone
  addCube(face, {0, 0, 0}, true);
  addCube(face, {1, 0, 0}, true);
  const auto touching = build(face, 0);
  EXPECT_EQ(touching->componentCount(), 4u);
  EXPECT_EQ(repairCount(*touching, "non-manifold-edges"), 4u);
  EXPECT_EQ(repairCount(*touching, "lone-faces"), 2u);
}

TEST(WeldBorders, LeavesBothSidesOfASheetApart) {
  for (const Index n : {1u, 2u, 5u}) {
    for (const bool triangles : {true, false}) {
      const auto mesh = build(doubleSided(n, triangles), 0);
      EXPECT_EQ(mesh->componentCount(), 2u) << n << triangles;
      EXPECT_EQ(mesh->boundaryLoopCount(), 2u);
      EXPECT_TRUE(mesh->repairs().empty());
    }
  }
}

TEST(WeldBorders, LeavesAWallOnAFloorApart) {
  // A floor of two quads; a wall stands on the edge between them, with vertices of its own.
  const auto mesh = test::meshOf({{0, 0, 0},
                                  {1, 0, 0},
                                  {2, 0, 0},
                                  {0, 1, 0},
                                  {1, 1, 0},
                                  {2, 1, 0},
                                  {1, 0, 0},
                                  {1, 1, 0},
                                  {1, 0, 1},
                                  {1, 1, 1}},
                                 {{0, 1, 4, 3}, {1, 2, 5, 4}, {6, 7, 9, 8}});
  EXPECT_EQ(mesh->componentCount(), 2u);
  EXPECT_TRUE(mesh->repairs().empty());
}

TEST(WeldBorders, JoinsSidesThatRunAgainstEachOtherAndTurnsThem) {
  const auto mesh = test::meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                 {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(mesh->componentCount(), 1u);
  EXPECT_EQ(repairCount(*mesh, "turned-faces"), 1u);
}

TEST(WeldBorders, LeavesOutEdgesOfNoLengthThatNoOtherFaceHas) {
  // The top of a pyramid as engines write it: quads with two corners at one place.
  test::Polygons faces;
  std::vector<glm::dvec3> p = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (Index i = 0; i < 4; ++i) p.emplace_back(0.5, 0.5, 1);
  for (Index i = 0; i < 4; ++i) faces.push_back({i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i});
  faces.push_back({3, 2, 1, 0});
  const auto mesh = test::meshOf(p, faces);
  EXPECT_TRUE(mesh->closed());
  EXPECT_EQ(mesh->faceCount(), 5u);
  EXPECT_EQ(mesh->eulerNumber(), 2);
}

TEST(WeldBorders, LeavesOutTrianglesOfNoLengthOnlyBetweenTwoFaces) {
  // A fan of two triangles about a place that each has as a vertex of its own, and a third, of no
  // width, between them; then without the second.
  const std::vector<glm::dvec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 1, 0}};
  const auto fan = test::meshOf(p, {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}});
  EXPECT_EQ(fan->faceCount(), 2u);
  EXPECT_EQ(fan->componentCount(), 1u);
  const auto lone = test::meshOf(p, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(lone->faceCount(), 2u);
}

TEST(WeldBorders, ClosesGapsUpToADistance) {
  InputMesh input;
  addCube(input, {0, 0, 0}, true);
  std::mt19937 random(5);
  for (glm::dvec3& p : input.positions) {
    for (int i = 0; i < 3; ++i) p[i] += 1e-3 * (static_cast<double>(random() % 1000) / 1000 - 0.5);
  }
  EXPECT_EQ(build(input, 0)->componentCount(), 6u);
  EXPECT_EQ(build(input, 1e-5)->componentCount(), 6u);
  const auto cube = build(input, 5e-3);
  EXPECT_TRUE(cube->closed());
  EXPECT_EQ(cube->componentCount(), 1u);
}

class SplitSamples : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samples, SplitSamples,
                         testing::Values("cube", "cylinder", "rocket", "gear", "torus", "sphere"));

TEST_P(SplitSamples, AreTheSameSurfaceAgain) {
  const auto whole = test::sampleMesh(GetParam(), 2500);
  const GaussArea expected = computeGaussArea(*whole, 45);
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const InputMesh split = splitAtCreases(*whole, 30, seed);
    ASSERT_GT(split.positions.size(), whole->vertexCount());
    const auto mesh = build(split, 0);
    EXPECT_EQ(mesh->componentCount(), whole->componentCount());
    EXPECT_EQ(mesh->boundaryLoopCount(), whole->boundaryLoopCount());
    EXPECT_EQ(mesh->eulerNumber(), whole->eulerNumber());
    EXPECT_EQ(repairCount(*mesh, "welded-vertices"), split.positions.size() - whole->vertexCount());
    EXPECT_NEAR(computeGaussArea(*mesh, 45).total(), expected.total(),
                1e-9 * std::max(1.0, expected.total()));
    // In any order of faces, each from any corner.
    const auto shuffled = build(test::shuffledFaces(split, seed), 0);
    EXPECT_EQ(shuffled->componentCount(), whole->componentCount());
    EXPECT_EQ(shuffled->eulerNumber(), whole->eulerNumber());
  }
}

}  // namespace
}  // namespace chartflood
