/// Every file of the collections is read and built; see bad_meshes_table.cpp for what must come of
/// the broken ones.

#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "bad_meshes_table.h"
#include "core/base/error.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "io_support.h"

namespace chartflood::test {
namespace {

const std::filesystem::path kBadFolder = CHARTFLOOD_BAD_MESHES;
const std::filesystem::path kFolder = CHARTFLOOD_MESHES;

/// What came of a file, with the words that went with it.
struct Result {
  Outcome outcome = Outcome::Refused;
  std::string words;
  std::shared_ptr<const Mesh> mesh;
};

Result readAndBuild(const std::filesystem::path& file) {
  Result result;
  try {
    result.mesh = buildMesh(readMesh(file));
  } catch (const ReadError& e) {
    result.words = e.what();
    return result;
  }
  for (const Repair& repair : result.mesh->repairs()) result.words += repair.text + " ";
  result.outcome = result.words.empty() ? Outcome::Loaded : Outcome::Repaired;
  return result;
}

class BadMeshes : public testing::TestWithParam<BadMesh> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kBadFolder)) GTEST_SKIP() << kBadFolder << " is not there";
  }
};

TEST_P(BadMeshes, ComesToWhatTheTableSays) {
  const BadMesh& row = GetParam();
  const Result result = readAndBuild(kBadFolder / row.file);
  EXPECT_EQ(result.outcome, row.outcome) << result.words << row.reason;
  if (result.mesh == nullptr) {
    EXPECT_NE(result.words.find(row.file), std::string::npos) << result.words;
    EXPECT_EQ(result.words.back(), '.') << result.words;
    EXPECT_EQ(result.words.find('\n'), std::string::npos) << result.words;
    return;
  }
  EXPECT_EQ(result.mesh->triangleCount(), row.triangles) << row.reason;
  EXPECT_EQ(usedVertices(*result.mesh), row.vertices) << row.reason;
  for (const glm::dvec3& p : result.mesh->positions()) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
}

std::string nameOf(const testing::TestParamInfo<BadMesh>& info) {
  std::string name = std::to_string(info.index) + "_";
  for (const char c : std::string_view(info.param.file).substr(0, 60)) {
    const unsigned char byte = static_cast<unsigned char>(c);
    if (byte < 0x80) name.push_back(std::isalnum(byte) != 0 ? c : '_');
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, BadMeshes, testing::ValuesIn(badMeshes().begin(), badMeshes().end()),
                         nameOf);

TEST(BadMeshTable, NamesEveryFileOfTheFolder) {
  if (!std::filesystem::exists(kBadFolder)) GTEST_SKIP() << kBadFolder << " is not there";
  std::set<std::string> inTable, inFolder;
  for (const BadMesh& row : badMeshes()) inTable.insert(row.file);
  for (const auto& entry : std::filesystem::directory_iterator(kBadFolder)) {
    const std::string name = entry.path().filename().string();
    if (name != "README.md") inFolder.insert(name);
  }
  EXPECT_EQ(inTable, inFolder);
}

struct GoodMesh {
  const char* file;
  std::size_t triangles, vertices, components, loops;
  long genus;     ///< -1: not counted
  bool manifold;  ///< nothing is split
};

// The figures of the collection's own list. (It counts an edge of suzanne.obj as non-manifold that
// is the diagonal of a quad; diagonals glue.)
constexpr GoodMesh kGoodMeshes[] = {
    {"box-textured.gltf", 12, 8, 1, 0, 0, true},
    {"suzanne.obj", 968, 507, 3, 4, 0, true},
    {"fuze.obj", 1000, 502, 1, 0, 0, true},
    {"bones.off", 4204, 2154, 26, 0, 0, true},
    {"duck.glb", 4212, 2108, 1, 0, 0, true},
    {"elephant-with-holes.off", 4463, 2798, 1, 106, 3, true},
    {"tray-ascii.stl", 4520, 2216, 1, 0, 23, true},
    {"cow.obj", 5804, 2903, 1, 0, -1, false},
    {"spot.obj", 5856, 2930, 1, 0, 0, true},
    {"anchor_dense.off", 7598, 3793, 1, 0, 4, true},
    {"greek-helmet-quads.obj", 9608, 5021, 7, 9, 0, true},
    {"casting.off", 10224, 5096, 1, 0, 9, true},
    {"max-planck-ascii.ply", 10540, 5272, 1, 0, 0, true},
    {"homer.obj", 12000, 6002, 1, 0, 0, true},
    {"fandisk.obj", 12946, 6475, 1, 0, 0, true},
    {"screwdriver-bigendian.ply", 13574, 6789, 1, 0, 0, true},
    {"bracket-3.stl", 14538, 7267, 1, 0, 2, true},
    {"lion-face.off", 14859, 7529, 1, 5, 0, true},
    {"cheese.off", 17786, 8629, 1, 0, 133, true},
    {"happy-buddha-19976.ply", 19976, 9978, 1, 0, 6, true},
    {"happy-buddha-20000.obj", 20000, 9990, 1, 0, 6, true},
    {"rocker-arm.obj", 20088, 10044, 1, 0, 1, true},
    {"camelhead.off", 22704, 11381, 1, 1, 0, true},
    {"laurana-50k.ply", 49954, 25126, 1, 4, 0, true},
    {"stanford-bunny.obj", 69451, 34834, 1, 5, 0, true},
    {"armadillo-80354.ply", 80354, 40179, 1, 0, 0, true},
    {"igea-151558.ply", 151558, 75781, 1, 0, 0, true},
    {"igea-268686.ply", 268686, 134345, 1, 0, 0, true},
};

TEST(GoodMeshes, HaveTheCountsOfTheirList) {
  if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << kFolder << " is not there";
  for (const GoodMesh& row : kGoodMeshes) {
    SCOPED_TRACE(row.file);
    const auto mesh = buildMesh(readMesh(kFolder / row.file));
    EXPECT_EQ(mesh->triangleCount(), row.triangles);
    EXPECT_EQ(usedVertices(*mesh), row.vertices);
    if (!row.manifold) {
      EXPECT_GT(countOf(mesh->repairs(), "split-vertices"), 0u);
      continue;
    }
    EXPECT_EQ(mesh->componentCount(), row.components);
    EXPECT_EQ(mesh->boundaryLoopCount(), row.loops);
    EXPECT_EQ(mesh->genus(), row.genus);
    EXPECT_EQ(countOf(mesh->repairs(), "split-vertices"), 0u);
  }
}

}  // namespace
}  // namespace chartflood::test
