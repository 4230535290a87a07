// What the program writes for real meshes, checked by means of the tests' own and by programs of
// others. Skipped where the meshes are missing; Blender and the validator only where installed.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "find_tool.h"
#include "tests/core/io/export_support.h"
#include "tests/support/run_program.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

using nlohmann::json;

const std::string kScripts = CHARTFLOOD_SOURCE_ROOT "/tests/io_tools/";

/// Quads, joined vertices, many parts, holes, handles, creases.
const std::vector<std::string> kFiles{"greek-helmet-quads.obj", "duck.glb",    "bones.off",
                                      "anchor_dense.off",       "fandisk.obj", "bracket-3.stl"};

/// Everything that the program writes for one mesh.
class ProgramExport : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    file_ = std::filesystem::absolute(std::filesystem::path(CHARTFLOOD_MESHES) / GetParam());
    if (!std::filesystem::exists(file_)) GTEST_SKIP() << "no meshes in " << CHARTFLOOD_MESHES;
    input_ = readMesh(file_);
    mesh_ = buildMesh(input_);
  }

  /// Equal calls give equal charts, so a format a call is enough.
  void exportAll() {
    run({"--export-mesh=mesh.obj", "--export-labels=labels.txt", "--report=report.json"});
    run({"--export-mesh=mesh.ply", "--export-uv=uv.svg"});
    run({"--export-mesh=mesh.glb", "--export-uv=uv.png"});
    ASSERT_FALSE(HasFatalFailure());
    obj_ = parseObj(readAll(folder_.path() / "mesh.obj"));
    report_ = json::parse(readAll(folder_.path() / "report.json"))["results"][0];
    std::istringstream stream(readAll(folder_.path() / "labels.txt"));
    for (int value; stream >> value;) labels_.push_back(value);
  }

  void run(std::vector<std::string> words) {
    words.insert(words.begin(), {CHARTFLOOD_PROGRAM, file_.string(), "--charts=12"});
    const ProgramRun done = runProgramIn(folder_.path(), words);
    ASSERT_EQ(done.exitCode, 0) << done.errors;
  }
  std::string chartOf(std::size_t face) const {
    return labels_[face] < 0 ? "dropped" : chartName(static_cast<Index>(labels_[face]));
  }

  void expectTheInputWithItsCharts();
  void expectDisks();
  void expectTextureInTheUnitSquare();
  void expectLayoutOfAllCharts();

  TemporaryFolder folder_;
  std::filesystem::path file_;
  std::shared_ptr<const InputMesh> input_;
  std::shared_ptr<const Mesh> mesh_;
  ObjFile obj_;
  json report_;              ///< of the only result
  std::vector<int> labels_;  ///< of the faces of the file
};

void ProgramExport::expectTheInputWithItsCharts() {
  EXPECT_EQ(obj_.vertices, input_->positions);
  ASSERT_EQ(obj_.faces.size(), input_->faceCount());
  ASSERT_EQ(labels_.size(), input_->faceCount());
  for (std::size_t f = 0; f < labels_.size(); ++f) {
    ASSERT_EQ(obj_.group[f], chartOf(f)) << f;
    ASSERT_EQ(obj_.faces[f].size(), input_->face(f).size());
    for (std::size_t i = 0; i < obj_.faces[f].size(); ++i) {
      ASSERT_EQ(obj_.faces[f][i].vertex, input_->face(f)[i]) << f;
    }
  }
  const PlyFile ply = parsePly(readAll(folder_.path() / "mesh.ply"));
  ASSERT_TRUE(ply.finished);
  ASSERT_EQ(ply.faces.size(), labels_.size());
  for (std::size_t f = 0; f < labels_.size(); ++f) {
    ASSERT_EQ(ply.faces[f].chart, labels_[f]) << f;
    ASSERT_EQ(ply.faces[f].vertices.size(), obj_.faces[f].size());
    for (std::size_t i = 0; i < obj_.faces[f].size(); ++i) {
      ASSERT_EQ(ply.vertices[ply.faces[f].vertices[i]], input_->positions[input_->face(f)[i]]);
      if (labels_[f] < 0 || obj_.faces[f][i].texture == kNone) continue;
      const glm::vec2 expected(obj_.texture[obj_.faces[f][i].texture]);
      ASSERT_EQ(ply.faces[f].texture[i], expected) << f;
      ASSERT_EQ(ply.texture[ply.faces[f].vertices[i]], expected) << f;
    }
  }
}

void ProgramExport::expectDisks() {
  const std::map<std::string, TextureTopology> charts = textureTopologies(obj_);
  std::size_t disks = 0;
  for (const json& chart : report_["per_chart"]) {
    if (!chart["disk"].get<bool>()) continue;
    ++disks;
    const TextureTopology& seen = charts.at(chartName(chart["chart"].get<Index>()));
    EXPECT_EQ(seen.euler(), 1) << chart["chart"];
    EXPECT_EQ(seen.boundaryLoops(), 1u) << chart["chart"];
  }
  EXPECT_EQ(disks, report_["per_chart"].size());
  // No texture coordinate serves two charts or two vertices.
  std::map<Index, std::pair<Index, int>> owner;
  for (std::size_t f = 0; f < obj_.faces.size(); ++f) {
    for (const ObjCorner& c : obj_.faces[f]) {
      if (c.texture == kNone) continue;
      // Joined vertices share their texture coordinate.
      const Index vertex = mesh_->standIn(c.vertex);
      const std::pair<Index, int> now{vertex, labels_[f]};
      ASSERT_EQ(owner.try_emplace(c.texture, now).first->second, now);
    }
  }
  EXPECT_EQ(owner.size(), obj_.texture.size());
}

void ProgramExport::expectTextureInTheUnitSquare() {
  std::size_t flipped = 0, triangles = 0;
  double area = 0;
  for (const auto& face : obj_.faces) {
    if (face.empty() || face[0].texture == kNone) continue;
    for (const ObjCorner& corner : face) {
      const glm::dvec2& uv = obj_.texture[corner.texture];
      ASSERT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1) << uv.x << " " << uv.y;
    }
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const glm::dvec2 &a = obj_.texture[face[0].texture], &b = obj_.texture[face[i].texture],
                       &c = obj_.texture[face[i + 1].texture];
      const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      ++triangles;
      // Turning and moving a chart rounds, which may turn slivers over.
      flipped += twice < -1e-15 ? 1 : 0;
      area += twice / 2;
    }
  }
  EXPECT_EQ(triangles, mesh_->triangleCount());
  EXPECT_LE(flipped, report_["flipped_triangles"].get<std::size_t>());
  EXPECT_NEAR(area, report_["packing_efficiency"].get<double>(), 0.02);
}

void ProgramExport::expectLayoutOfAllCharts() {
  const std::string svg = readAll(folder_.path() / "uv.svg");
  std::size_t groups = 0;
  for (std::size_t at = 0; (at = svg.find("<g id=\"chart_", at)) != std::string::npos; ++at) {
    ++groups;
  }
  EXPECT_EQ(groups, report_["charts"].get<std::size_t>());
  EXPECT_TRUE(readAll(folder_.path() / "uv.png").starts_with("\x89PNG"));
}

TEST_P(ProgramExport, HoldsTheInputAndItsCharts) {
  exportAll();
  if (HasFatalFailure()) return;
  expectTheInputWithItsCharts();
  expectDisks();
  expectTextureInTheUnitSquare();
  expectLayoutOfAllCharts();
}

TEST_P(ProgramExport, OpensInBlender) {
  const std::filesystem::path blender = findTool("blender");
  if (blender.empty()) GTEST_SKIP() << "Blender is not installed";
  exportAll();
  if (HasFatalFailure()) return;
  const ProgramRun opened = runProgramIn(
      folder_.path(),
      {blender.string(), "--background", "--factory-startup", "--python-exit-code", "1", "--python",
       kScripts + "open_in_blender.py", "--", "seen.json", "mesh.obj", "mesh.ply", "mesh.glb"});
  ASSERT_EQ(opened.exitCode, 0) << opened.output << opened.errors;
  bool noNumpy = false;
  for (const json& seen : json::parse(readAll(folder_.path() / "seen.json"))) {
    SCOPED_TRACE(std::string(seen["file"]) + " by " + std::string(seen["importer"]));
    if (seen.contains("error") && std::string(seen["error"]).find("'numpy'") != std::string::npos) {
      noNumpy = true;
      continue;
    }
    ASSERT_FALSE(seen.contains("error")) << seen["error"];
    const bool triangles = std::string(seen["file"]).ends_with(".glb");
    EXPECT_EQ(seen["objects"], 1);
    EXPECT_EQ(seen["faces"], triangles ? mesh_->triangleCount() : input_->faceCount());
    EXPECT_EQ(seen["texture_layers"], 1);
    EXPECT_EQ(seen["repaired"], false);
    // Vertices that reading joined are apart in files that keep the input's.
    if (triangles || repairCount(*mesh_, "welded-vertices") == 0) {
      EXPECT_EQ(seen["islands"], report_["charts"]);
    }
    EXPECT_TRUE(seen["low"] >= 0.0 && seen["high"] <= 1.0);
  }
  if (noNumpy) GTEST_SKIP() << "Blender opens GLB only where python3-numpy is installed";
}

TEST_P(ProgramExport, PassesTheGltfValidator) {
  const std::filesystem::path node = findTool("node");
  if (node.empty()) GTEST_SKIP() << "Node.js is not installed";
  const std::string found = "require('gltf-validator')";
  if (runProgramIn(folder_.path(), {node.string(), "-e", found}).exitCode != 0) {
    GTEST_SKIP() << "the package gltf-validator is in no folder that NODE_PATH names";
  }
  run({"--export-mesh=mesh.glb"});
  if (HasFatalFailure()) return;
  const ProgramRun checked =
      runProgramIn(folder_.path(), {node.string(), kScripts + "validate_glb.js", "mesh.glb"});
  ASSERT_EQ(checked.exitCode, 0) << checked.errors;
  const json report = json::parse(checked.output)[0];
  EXPECT_EQ(report["errors"], 0) << report["messages"];
  EXPECT_EQ(report["warnings"], 0) << report["messages"];
  EXPECT_EQ(report["info"]["totalTriangleCount"], mesh_->triangleCount());
}

INSTANTIATE_TEST_SUITE_P(Files, ProgramExport, testing::ValuesIn(kFiles), [](const auto& file) {
  std::string name = file.param;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
});

}  // namespace
}  // namespace chartflood::test
