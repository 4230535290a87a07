// Models of few planes and bodies of revolution: core/segment/flat_regions, revolution, and the
// charts that begin with them.

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/gauss/compute_gauss_area.h"
#include "core/segment/creases/crease_start.h"
#include "core/segment/creases/flat_regions.h"
#include "core/segment/creases/revolution.h"
#include "tests/support/part_models.h"
#include "tests/support/segment_inputs.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

using glm::dvec2;

std::shared_ptr<const Mesh> boxModel(Index count, Index n = 1) {
  test::PartModel model;
  for (Index i = 0; i < count; ++i) model.addBox({3.0 * i, 0, 0}, {1, 1, 1.0 + i % 3}, n);
  return model.mesh();
}

std::shared_ptr<const Mesh> prismOf(const std::vector<dvec2>& outline) {
  test::PartModel model;
  model.addPrism({0, 0, 0}, outline, 1);
  return model.mesh();
}

std::shared_ptr<const Mesh> regularPrism(Index corners) {
  std::vector<dvec2> outline;
  for (Index i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    outline.emplace_back(std::cos(angle), std::sin(angle));
  }
  return prismOf(outline);
}

std::shared_ptr<const Mesh> turned(const std::vector<dvec2>& profile, Index around) {
  test::PartModel model;
  model.addRevolved({0, 0, 0}, profile, around);
  return model.mesh();
}

std::shared_ptr<const Mesh> flatGrid(Index n) {
  test::PartModel model;
  model.addGrid({0, 0, 0}, 1, n);
  return model.mesh();
}

Segmentation finishedPlanes(const SegmentInputs& in, std::size_t charts) {
  SegmentOptions options;
  options.charts = charts;
  const auto stepper = makeCreaseStart(in, options);
  Progress progress;
  EXPECT_EQ(stepper->advance(StepUnit::Converged, 1, progress), StepOutcome::Finished);
  return *stepper->state();
}

/// Quads whose diagonal lies between two charts.
std::size_t cutQuads(const Mesh& mesh, const Segmentation& state) {
  const auto partner = quadPartners(mesh, *flatRegions(mesh, mesh.faceCount()));
  std::size_t cut = 0;
  for (Index f = 0; f < partner.size(); ++f) {
    cut += partner[f] != kNone && partner[f] > f && state.label[f] != state.label[partner[f]];
  }
  return cut;
}

std::size_t lonelyTriangles(const Segmentation& state) {
  std::vector<std::size_t> faces(state.chartCount, 0);
  for (const Index chart : state.label) ++faces[chart];
  return static_cast<std::size_t>(std::count(faces.begin(), faces.end(), 1u));
}

TEST(Features, AreFlatRegionsOfAllParts) {
  EXPECT_EQ(featureCount(*boxModel(1)), 6u);
  EXPECT_EQ(featureCount(*boxModel(1, 10)), 6u);
  EXPECT_EQ(featureCount(*boxModel(3)), 18u);
  EXPECT_EQ(featureCount(*flatGrid(1)), 1u);
  EXPECT_EQ(featureCount(*flatGrid(10)), 1u);
  EXPECT_EQ(featureCount(*regularPrism(6)), 8u);
  EXPECT_EQ(featureCount(*test::quadCube()), 6u);
}

TEST(Features, OfCurvedModelsAreMoreThanAnyDefault) {
  EXPECT_GT(featureCount(*test::sampleMesh("sphere", 1000)), 1000000u);
  EXPECT_GT(featureCount(*test::sampleMesh("torus", 300)), 1000000u);
}

TEST(Features, LeaveNoTriangleAlone) {
  EXPECT_EQ(featureCount(*regularPrism(3)), 3u);
  const Segmentation state = finishedPlanes(test::segmentInputs(regularPrism(3)), 3);
  EXPECT_EQ(lonelyTriangles(state), 0u);
}

TEST(FlatStart, ABoxIsSixSquares) {
  for (const Index n : {1u, 10u}) {
    const auto mesh = boxModel(1, n);
    const SegmentInputs in = test::segmentInputs(mesh);
    EXPECT_TRUE(suitsCreaseStart(in, 6));
    const Segmentation state = finishedPlanes(in, 6);
    test::expectValid(*mesh, *in.gaussArea, state);
    const auto sides = flatRegions(*mesh, 100);
    ASSERT_EQ(sides->count, 6u);
    EXPECT_EQ(sides->label, state.label);
  }
}

TEST(FlatStart, WantsNoMoreThanAModelWithFewPlanesHas) {
  EXPECT_TRUE(hasFlatParts(*boxModel(1), 20));
  EXPECT_TRUE(hasFlatParts(*boxModel(1, 40), 20));
  EXPECT_TRUE(hasFlatParts(*boxModel(200), 1000));
  EXPECT_FALSE(hasFlatParts(*test::sampleMesh("sphere", 5000), 20));
  EXPECT_FALSE(hasFlatParts(*test::sampleMesh("sphere", 20000), 15000)) << "too many joins";
}

struct PlaneSweep {
  const char* name;
  std::shared_ptr<const Mesh> mesh;
};
std::vector<PlaneSweep> sweepModels() {
  const std::vector<dvec2> cylinder = {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}};
  const std::vector<dvec2> cone = {{0, 0}, {0.5, 0}, {0, 1}};
  const std::vector<dvec2> angle = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  return {{"box", boxModel(1)},
          {"three boxes", boxModel(3)},
          {"two hundred boxes", boxModel(200)},
          {"plane", flatGrid(10)},
          {"prism", regularPrism(12)},
          {"angle", prismOf(angle)},
          {"cylinder", turned(cylinder, 24)},
          {"cone", turned(cone, 24)},
          {"tessellated box", boxModel(1, 10)}};
}

TEST(FlatStart, CutsNoQuadWhileAnotherEdgeCanBeABorder) {
  for (const auto& [name, mesh] : sweepModels()) {
    const SegmentInputs in = test::segmentInputs(mesh);
    const auto partner = quadPartners(*mesh, *flatRegions(*mesh, mesh->faceCount()));
    const std::size_t quads =
        (mesh->faceCount() -
         static_cast<std::size_t>(std::count(partner.begin(), partner.end(), kNone))) /
        2;
    const std::size_t units = mesh->faceCount() - quads;
    for (const std::size_t asked : {1u, 2u, 3u, 5u, 6u, 7u, 12u, 20u, 40u, 100u, 300u, 1000u}) {
      if (!hasFlatParts(*mesh, asked)) continue;
      const Segmentation state = finishedPlanes(in, asked);
      test::expectValid(*mesh, *in.gaussArea, state);
      const std::size_t charts = state.chartCount;
      EXPECT_EQ(charts, std::min(std::max(asked, mesh->componentCount()), mesh->faceCount()))
          << name << ' ' << asked;
      EXPECT_EQ(cutQuads(*mesh, state), charts > units ? charts - units : 0)
          << name << ' ' << asked;
    }
  }
}

TEST(Creases, DivideNoSmoothModelBecauseItHasParts) {
  test::PartModel model;
  for (Index i = 0; i < 6; ++i) model.addBall({3.0 * i, 0, 0}, 1, 20);
  EXPECT_FALSE(suitsCreaseStart(test::segmentInputs(model.mesh()), 20));
}

TEST(Revolution, IsSeenByItsCreases) {
  const std::vector<dvec2> shaft = {{0, 0},    {0.2, 0},   {0.2, 0.5}, {0.4, 0.5},
                                    {0.4, 1.}, {0.25, 1.}, {0.25, 2.}, {0, 2.}};
  std::vector<dvec2> bottle = {{0, 0}, {0.4, 0}};
  for (int i = 1; i <= 10; ++i) bottle.emplace_back(0.4 + 0.002 * i * (10 - i), 0.1 * i);
  for (int i = 1; i <= 10; ++i) bottle.emplace_back(0.4 - 0.025 * i, 1 + 0.03 * i);
  bottle.insert(bottle.end(), {{0.15, 1.7}, {0, 1.7}});
  for (const auto& profile : {shaft, bottle}) {
    const auto mesh = turned(profile, 48);
    EXPECT_TRUE(ringsBetweenCreases(*mesh, computeGaussArea(*mesh, 45)));
    EXPECT_TRUE(suitsCreaseStart(test::segmentInputs(mesh), 20));
  }
}

TEST(Revolution, IsNotWhatHasOtherCreasesOrNone) {
  for (const char* sample : {"rocket", "gear", "sphere", "torus", "cube"}) {
    const auto mesh = test::sampleMesh(sample, 3000);
    EXPECT_FALSE(ringsBetweenCreases(*mesh, computeGaussArea(*mesh, 45))) << sample;
  }
  // A round hole in a plate has two round creases, and a ball beside does not turn with them.
  test::PartModel model;
  const std::vector<dvec2> disk = {{0, 0}, {0.2, 0}, {0.2, 0.1}, {0, 0.1}};
  model.addRevolved({0, 0, 0}, disk, 24);
  model.addBall({2, 0, 0}, 1, 30);
  const auto mesh = model.mesh();
  EXPECT_FALSE(ringsBetweenCreases(*mesh, computeGaussArea(*mesh, 45)));
}

}  // namespace
}  // namespace chartflood
