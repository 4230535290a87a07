// The same surface from any file: repeated vertices, faces turned over, polygons with holes, and
// what is no surface, through the whole program. The inputs are small files in tests/data.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>

#include "tests/support/exported_obj.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;
using test::ExportedObj;
using test::parseObj;

const std::filesystem::path kData = std::filesystem::path(CHARTFLOOD_SOURCE_ROOT) / "tests/data";

/// What the program makes of a file.
struct Outcome {
  json report;
  std::string labels;
  ExportedObj obj;

  const json& input() const { return report["input"]; }
  const json& result() const { return report["results"][0]; }
  double gauss() const { return result()["gauss_area"]["total"]; }
  std::size_t repairs(const std::string& what) const {
    for (const json& repair : input()["repairs"]) {
      if (repair["what"] == what) return repair["count"];
    }
    return 0;
  }
  std::size_t facesWithoutTexture() const {
    std::size_t count = 0;
    for (const auto& face : obj.faces) {
      for (const long texture : face.texture) {
        if (texture >= 0) continue;
        ++count;
        break;
      }
    }
    return count;
  }
  void expectDisks() const {
    for (const json& chart : result()["per_chart"]) EXPECT_TRUE(chart["disk"]) << chart["chart"];
  }
};

Outcome outcomeOf(const std::filesystem::path& file, std::vector<std::string> options) {
  const TemporaryFolder folder;
  options.insert(options.begin(), CHARTFLOOD_PROGRAM);
  for (const char* option : {"--report=r.json", "--export-labels=l.txt", "--export-mesh=o.obj"}) {
    options.push_back(option);
  }
  options.push_back(file.string());
  const ProgramRun done = runProgramIn(folder.path(), options);
  EXPECT_EQ(done.exitCode, 0) << done.errors;
  Outcome outcome;
  outcome.report = json::parse(readAll(folder.path() / "r.json"), nullptr, false);
  outcome.labels = readAll(folder.path() / "l.txt");
  outcome.obj = parseObj(folder.path() / "o.obj");
  return outcome;
}

constexpr double kSphere = 4 * std::numbers::pi;

TEST(Surface, ACubeOfEnginesIsOnePart) {
  const Outcome cube = outcomeOf(kData / "engine-cube-24-vertices.obj", {"--charts=6"});
  EXPECT_EQ(cube.input()["components"], 1);
  EXPECT_EQ(cube.input()["boundary_loops"], 0);
  EXPECT_EQ(cube.repairs("welded-vertices"), 16u);
  EXPECT_NEAR(cube.gauss(), kSphere, 1e-9);
  EXPECT_EQ(cube.obj.vertices.size(), 24u);
  const Outcome apart = outcomeOf(kData / "engine-cube-24-vertices.obj", {"--weld=off"});
  EXPECT_EQ(apart.input()["components"], 6);
  EXPECT_EQ(apart.repairs("welded-vertices"), 0u);
}

/// The triangles or polygons of an OBJ as ASCII PLY.
std::string plyOf(const ExportedObj& obj) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex " + std::to_string(obj.vertices.size()) +
      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
      std::to_string(obj.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& [x, y, z] : obj.vertices) {
    for (const double c : {x, y, z}) {
      char digits[40];
      std::snprintf(digits, sizeof digits, "%.17g ", c);
      text += digits;
    }
    text += '\n';
  }
  for (const auto& face : obj.faces) {
    text += std::to_string(face.vertex.size());
    for (const long v : face.vertex) text += ' ' + std::to_string(v);
    text += '\n';
  }
  return text;
}

TEST(Surface, ACylinderIsTheSameInThreeFormats) {
  const TemporaryFolder folder;
  const std::filesystem::path obj = kData / "cylinder-split-at-creases.obj";
  writeAll(folder.path() / "cylinder.ply", plyOf(parseObj(obj)));
  for (const auto& file :
       {obj, kData / "cylinder-split-at-creases.glb", folder.path() / "cylinder.ply"}) {
    SCOPED_TRACE(file);
    const Outcome cylinder = outcomeOf(file, {"--charts=3"});
    EXPECT_EQ(cylinder.input()["components"], 1);
    EXPECT_EQ(cylinder.input()["boundary_loops"], 0);
    EXPECT_NEAR(cylinder.gauss(), kSphere, 1e-5);
    EXPECT_GT(cylinder.repairs("welded-vertices"), 0u);
    EXPECT_EQ(cylinder.result()["charts"], 3);
    cylinder.expectDisks();
  }
}

TEST(Surface, ARandomlyTurnedHemisphereIsOnePiece) {
  const std::filesystem::path file = kData / "hemisphere-mixed-orientation.obj";
  const Outcome half = outcomeOf(file, {"--charts=8"});
  EXPECT_EQ(half.input()["components"], 1);
  EXPECT_EQ(half.result()["charts"], 8);
  EXPECT_GT(half.repairs("turned-faces"), 0u);
  EXPECT_EQ(half.repairs("inconsistent-edges"), 0u);
  half.expectDisks();
  const ExportedObj before = parseObj(file);
  ASSERT_EQ(before.faces.size(), half.obj.faces.size());
  for (std::size_t f = 0; f < before.faces.size(); ++f) {
    ASSERT_EQ(before.faces[f].vertex, half.obj.faces[f].vertex) << "as the file has it";
  }
}

TEST(Surface, APolygonWithASlitIsLaidFlat) {
  for (const char* charts : {"--charts=1", "--charts=2", "--charts=3"}) {
    SCOPED_TRACE(charts);
    const Outcome ring = outcomeOf(kData / "keyhole-polygon.obj", {charts});
    EXPECT_EQ(ring.facesWithoutTexture(), 0u);
    EXPECT_EQ(ring.obj.faces.size(), 3u);
    EXPECT_EQ(ring.obj.faces[0].vertex.size(), 10u);
    ring.expectDisks();
  }
}

TEST(Surface, EdgesOfFourFacesAreSplit) {
  const Outcome voxels = outcomeOf(kData / "voxels-4296-faces.obj", {"--charts=8"});
  EXPECT_EQ(voxels.repairs("non-manifold-edges"), 446u);
  EXPECT_EQ(voxels.facesWithoutTexture(), 0u);
  voxels.expectDisks();
}

TEST(Surface, SoupsAreReadAndFinish) {
  for (const char* name : {"soup-75.off", "soup-212.off"}) {
    SCOPED_TRACE(name);
    const Outcome soup = outcomeOf(kData / name, {"--charts=8"});
    EXPECT_GT(soup.repairs("non-manifold-edges"), 0u);
    // A face that names one vertex twice has no inside.
    EXPECT_EQ(soup.facesWithoutTexture(), soup.repairs("dropped-faces"));
    soup.expectDisks();
  }
}

}  // namespace
}  // namespace chartflood
