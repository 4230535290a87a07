// Over all real meshes at hand: the labels and the mesh that the program writes, checked by means
// of their own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/gauss/compute_gauss_area.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "tests/support/exported_obj.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;

std::vector<std::string> meshFiles() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(CHARTFLOOD_MESHES, missing)) {
    const std::string ending = entry.path().extension().string();
    for (const char* known : {".obj", ".ply", ".off", ".stl", ".glb", ".gltf"}) {
      if (ending == known) names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  // Without meshes one test remains, which says that they are missing.
  if (names.empty()) names.push_back("");
  return names;
}

/// Sets of faces that grow together.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// Pieces into which the charts fall: one a chart when each is connected.
std::size_t pieces(const Mesh& mesh, const std::vector<long>& chartOfFace) {
  UnionFind sets(mesh.faceCount());
  for (Index side = 0; side < mesh.opposite().size(); ++side) {
    const Index other = mesh.opposite()[side];
    if (other == kNone) continue;
    const Index a = mesh.faceOf(side / 3), b = mesh.faceOf(other / 3);
    if (chartOfFace[a] == chartOfFace[b]) sets.join(a, b);
  }
  std::set<std::size_t> roots;
  for (std::size_t face = 0; face < mesh.faceCount(); ++face) roots.insert(sets.root(face));
  return roots.size();
}

/// Gauss area of each chart from the definition: an edge counts when both its triangles are in the
/// chart, a vertex when all its triangles are.
std::vector<double> gaussAreas(const Mesh& mesh, const GaussArea& gauss,
                               const std::vector<long>& chartOfFace, std::size_t charts) {
  std::vector<double> area(charts, 0.0);
  const auto chartOf = [&](Index triangle) { return chartOfFace[mesh.faceOf(triangle)]; };
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    area[static_cast<std::size_t>(chartOf(t))] += gauss.triangle[t];
  }
  for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
    const Index side = gauss.sharpEdges[i];
    const long a = chartOf(side / 3), b = chartOf(mesh.opposite()[side] / 3);
    if (a == b) area[static_cast<std::size_t>(a)] += gauss.edge[i];
  }
  std::vector<std::set<long>> around(mesh.vertexCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    for (const Index vertex : mesh.triangles()[t]) around[vertex].insert(chartOf(t));
  }
  for (std::size_t i = 0; i < gauss.corners.size(); ++i) {
    const std::set<long>& charts_ = around[gauss.corners[i]];
    if (charts_.size() == 1) area[static_cast<std::size_t>(*charts_.begin())] += gauss.corner[i];
  }
  return area;
}

class RealMesh : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (GetParam().empty()) GTEST_SKIP() << "no meshes in " << CHARTFLOOD_MESHES;
    file_ = std::filesystem::path(CHARTFLOOD_MESHES) / GetParam();
    mesh_ = buildMesh(readMesh(file_));
    const ProgramRun done =
        runProgramIn(folder_.path(), {CHARTFLOOD_PROGRAM, std::filesystem::absolute(file_).string(),
                                      "--export-labels=labels.txt", "--report=report.json",
                                      "--export-mesh=charts.obj"});
    ASSERT_EQ(done.exitCode, 0) << done.errors;
    report_ = json::parse(readAll(folder_.path() / "report.json"));
    std::istringstream stream(readAll(folder_.path() / "labels.txt"));
    for (long value; stream >> value;) labels_.push_back(value);
  }

  void checkLabels() const;
  void checkObj() const;

  TemporaryFolder folder_;
  std::filesystem::path file_;
  std::shared_ptr<const Mesh> mesh_;
  json report_;
  std::vector<long> labels_;  ///< of the faces of the file
};

void RealMesh::checkLabels() const {
  const Mesh& mesh = *mesh_;
  ASSERT_EQ(labels_.size(), mesh.input().faceCount());
  std::vector<long> chartOfFace(mesh.faceCount());
  for (Index face = 0; face < mesh.faceCount(); ++face) {
    chartOfFace[face] = labels_[mesh.inputFace(face)];
    ASSERT_GE(chartOfFace[face], 0) << "face " << face << " has no chart";
  }
  const auto dropped = std::count(labels_.begin(), labels_.end(), -1);
  EXPECT_EQ(static_cast<std::size_t>(dropped), labels_.size() - mesh.faceCount());
  const std::set<long> charts(chartOfFace.begin(), chartOfFace.end());
  // 20, or as many as the model has flat regions; each part has one, and crumbs theirs on top.
  const std::size_t wanted = report_["results"][0]["charts"].get<std::size_t>();
  EXPECT_GE(wanted, mesh.componentCount());
  EXPECT_LE(wanted, std::min(mesh.faceCount(), 20 + mesh.componentCount()));
  if (mesh.componentCount() == 1 && mesh.faceCount() > 1000) EXPECT_EQ(wanted, 20u);
  EXPECT_EQ(charts.size(), wanted);
  EXPECT_EQ(*charts.rbegin(), static_cast<long>(wanted) - 1);
  EXPECT_EQ(pieces(mesh, chartOfFace), wanted) << "a chart is not connected";

  const GaussArea gauss = computeGaussArea(mesh, 45);
  const std::vector<double> areas = gaussAreas(mesh, gauss, chartOfFace, wanted);
  const json& perChart = report_["results"][0]["per_chart"];
  ASSERT_EQ(perChart.size(), wanted);
  for (std::size_t c = 0; c < wanted; ++c) {
    EXPECT_NEAR(perChart[c]["gauss_area"].get<double>(), areas[c], 1e-9 * (1 + areas[c])) << c;
  }
  const double total = report_["results"][0]["gauss_area"]["total"].get<double>();
  EXPECT_NEAR(total, gauss.total(), 1e-9 * total);
}

/// Vertices and faces as in the file, every chart a disk, nothing flipped, nothing on top of
/// another.
void RealMesh::checkObj() const {
  const test::ExportedObj obj = test::parseObj(folder_.path() / "charts.obj");
  const InputMesh& input = mesh_->input();
  ASSERT_EQ(obj.vertices.size(), input.positions.size());
  for (std::size_t v = 0; v < obj.vertices.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(obj.vertices[v][static_cast<std::size_t>(axis)], input.positions[v][axis]) << v;
    }
  }
  ASSERT_EQ(obj.faces.size(), input.faceCount());
  for (std::size_t f = 0; f < obj.faces.size(); ++f) {
    const auto face = input.face(f);
    ASSERT_TRUE(std::equal(face.begin(), face.end(), obj.faces[f].vertex.begin(),
                           obj.faces[f].vertex.end()))
        << "face " << f;
  }

  const test::TextureFigures figures = test::measureTexture(obj, 2048);
  EXPECT_EQ(figures.charts.size(), report_["results"][0]["charts"].get<std::size_t>());
  EXPECT_EQ(figures.facesWithoutTexture, input.faceCount() - mesh_->faceCount());
  for (const test::TextureChart& chart : figures.charts) {
    EXPECT_TRUE(chart.disk) << chart.group;
    EXPECT_TRUE(chart.weldedDisk) << chart.group << " closes where equal places are one";
    EXPECT_EQ(chart.flipped, 0u) << chart.group;
  }
  EXPECT_GE(figures.lowest, 0);
  EXPECT_LE(figures.highest, 1);
  EXPECT_EQ(figures.overlapInside, 0u);
  EXPECT_EQ(figures.overlapBetween, 0u);
  const double efficiency = report_["results"][0]["packing_efficiency"].get<double>();
  EXPECT_NEAR(figures.covered, efficiency, 0.01);
  EXPECT_EQ(report_["results"][0]["flipped_triangles"], 0);
}

TEST_P(RealMesh, ArrivesInFlatDisksOfTheNumberAskedFor) {
  checkLabels();
  checkObj();
}

INSTANTIATE_TEST_SUITE_P(Files, RealMesh, testing::ValuesIn(meshFiles()), [](const auto& file) {
  std::string name = file.param.empty() ? "none" : file.param;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
});

}  // namespace
}  // namespace chartflood
