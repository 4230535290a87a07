#include "core/samples/samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/model/build_mesh.h"

namespace chartflood::test {
namespace {

/// Topology of each sample: boundary loops and genus.
struct Topology {
  std::size_t loops;
  long genus;
};
const std::map<std::string, Topology> kTopology = {
    {"rocket", {0, 0}},   {"gear", {0, 1}},   {"knot", {0, 1}}, {"double-torus", {0, 2}},
    {"torus", {0, 1}},    {"sphere", {0, 0}}, {"cube", {0, 0}}, {"l-block", {0, 0}},
    {"cylinder", {0, 0}}, {"tube", {2, 0}},   {"cone", {1, 0}}, {"bumps", {1, 0}},
    {"plane", {1, 0}}};

double signedVolume(const InputMesh& mesh) {
  double volume = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    volume += glm::dot(mesh.positions[face[0]],
                       glm::cross(mesh.positions[face[1]], mesh.positions[face[2]]));
  }
  return volume / 6;
}

/// Smallest angle of each triangle in degrees, ascending.
std::vector<double> smallestAngles(const InputMesh& mesh) {
  std::vector<double> angles;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    double smallest = 180;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 p = mesh.positions[face[i]];
      const glm::dvec3 a = glm::normalize(mesh.positions[face[(i + 1) % 3]] - p);
      const glm::dvec3 b = glm::normalize(mesh.positions[face[(i + 2) % 3]] - p);
      smallest = std::min(smallest, std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)));
    }
    angles.push_back(smallest * 180 / 3.14159265358979);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

class Samples : public testing::TestWithParam<SampleInfo> {};

TEST_P(Samples, AreManifoldWithTheRightTopology) {
  for (const std::size_t wanted : {0, 300, 3000}) {
    SCOPED_TRACE(wanted);
    const auto mesh = buildMesh(makeSample(GetParam().id, wanted));
    const Topology& topology = kTopology.at(GetParam().id);
    EXPECT_EQ(mesh->componentCount(), 1u);
    EXPECT_EQ(mesh->boundaryLoopCount(), topology.loops);
    EXPECT_EQ(mesh->genus(), topology.genus);
    for (const Repair& repair : mesh->repairs()) ADD_FAILURE() << repair.text;
  }
}

TEST_P(Samples, HaveAboutTheTrianglesThatAreAskedFor) {
  for (const std::size_t wanted : {2000, 9000, 50000}) {
    const auto count = static_cast<double>(makeSample(GetParam().id, wanted)->faceCount());
    EXPECT_NEAR(count / static_cast<double>(wanted), 1, 0.1) << "of " << wanted;
  }
  EXPECT_NEAR(static_cast<double>(makeSample(GetParam().id)->faceCount()) /
                  static_cast<double>(GetParam().defaultTriangles),
              1, 0.1);
}

TEST_P(Samples, AreMadeOfWellShapedTriangles) {
  // The cone's edges follow its rulings into the tip, so that all its Gauss area lies there.
  if (std::string(GetParam().id) == "cone") return;
  const std::vector<double> angles = smallestAngles(*makeSample(GetParam().id));
  EXPECT_GT(angles[angles.size() / 100], 25);
  EXPECT_GT(angles[angles.size() / 2], 43);
  EXPECT_GT(angles.front(), 5);
}

TEST_P(Samples, FaceOutwardsWhereClosed) {
  if (kTopology.at(GetParam().id).loops > 0) return;
  EXPECT_GT(signedVolume(*makeSample(GetParam().id, 2000)), 0.01);
}

TEST_P(Samples, AreTheSameEveryTime) {
  const auto a = makeSample(GetParam().id, 2000), b = makeSample(GetParam().id, 2000);
  EXPECT_EQ(a->positions, b->positions);
  EXPECT_EQ(a->corners, b->corners);
}

INSTANTIATE_TEST_SUITE_P(All, Samples,
                         testing::ValuesIn(sampleTable().begin(), sampleTable().end()),
                         [](const auto& row) {
                           std::string name = row.param.id;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(SampleShapes, HaveTheirVolumes) {
  constexpr double pi = 3.14159265358979;
  EXPECT_NEAR(signedVolume(*makeSample("sphere", 20480)), 4 * pi / 3, 0.01);
  EXPECT_NEAR(signedVolume(*makeSample("cube", 1200)), 1, 1e-12);
  EXPECT_NEAR(signedVolume(*makeSample("l-block", 1200)), 3, 1e-12);
  EXPECT_NEAR(signedVolume(*makeSample("cylinder", 20000)), pi * 0.36 * 2, 0.01);
  EXPECT_NEAR(signedVolume(*makeSample("torus", 20000)), 2 * pi * pi * 0.16, 0.01);
}

TEST(SampleShapes, UnknownOnesAreNamed) { EXPECT_THROW(makeSample("rokcet"), UsageError); }

}  // namespace
}  // namespace chartflood::test
