// Written meshes in programs of others: Blender opens every format, the Khronos validator finds
// nothing wrong with GLB. Skipped where these programs are missing.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

#include "core/io/write/file_output.h"
#include "core/io/write/write_seams.h"
#include "core/io/write_mesh.h"
#include "find_tool.h"
#include "tests/core/io/export_support.h"
#include "tests/support/run_program.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

using nlohmann::json;

const std::string kScripts = CHARTFLOOD_SOURCE_ROOT "/tests/io_tools/";

struct Sample {
  std::string name;
  Charted charted;
};

/// Triangles and quads, closed and open, with one chart cut open.
std::vector<Sample> samples() {
  std::vector<Sample> all;
  all.push_back({"cube", inPatches(quadCube(), 1)});
  all.push_back({"rocket", inPatches(sampleMesh("rocket", 3000), 150)});
  all.push_back({"quads", inPatches(grid(12, false), 20)});
  all.push_back({"hexagons", inPatches(meshOf({{0, 0, 0},
                                               {2, 0, 0},
                                               {3, 1, 0},
                                               {2, 2, 0},
                                               {0, 2, 0},
                                               {-1, 1, 0},
                                               {2, -2, 1},
                                               {0, -2, 1}},
                                              {{0, 1, 2, 3, 4, 5}, {1, 0, 7, 6}}),
                                       1)});
  // Blender compares texture coordinates by value, so the two sides of the cut are drawn apart.
  Charted slit = inPatches(grid(4, true), 64);
  for (Index side = 0; side < slit.mesh->opposite().size(); ++side) {
    if (slit.mesh->sideStart(side) != 10 || slit.mesh->sideEnd(side) != 11) continue;
    cutAlong(slit, 0, {side});
    slit.atlas.uv[0].back().y += 0.01;
    break;
  }
  all.push_back({"slit", std::move(slit)});
  return all;
}

std::size_t placesOf(const Charted& charted) {
  std::size_t places = 0;
  for (const auto& uv : charted.atlas.uv) places += uv.size();
  return places;
}

/// What holds for every format; `vertices` and `faces` as the file has them.
void expectWhole(const json& seen, const Charted& charted, std::size_t faces,
                 std::size_t vertices) {
  ASSERT_FALSE(seen.contains("error")) << seen["error"];
  ASSERT_EQ(seen["objects"], 1);
  EXPECT_EQ(seen["faces"], faces);
  EXPECT_EQ(seen["vertices"], vertices);
  EXPECT_EQ(seen["texture_layers"], 1);
  EXPECT_EQ(seen["repaired"], false);
  EXPECT_EQ(seen["islands"], charted.charts.charts.size());
  EXPECT_GE(seen["low"], 0.0);
  EXPECT_LE(seen["high"], 1.0);
}

void expectAsWritten(const json& seen, const Charted& charted) {
  const InputMesh& input = charted.mesh->input();
  const std::string file = seen["file"];
  SCOPED_TRACE(file + " by " + std::string(seen["importer"]));
  if (file.ends_with(".obj")) {
    expectWhole(seen, charted, input.faceCount(), input.positions.size());
    EXPECT_EQ(seen["corners"], input.corners.size());
    const std::string lines = seamsText(charted.view());
    const auto seams = std::count(lines.begin(), lines.end(), 'l');
    EXPECT_EQ(seen["seams"], seams);
    if (!seen["seams_by_blender"].is_null()) {
      EXPECT_EQ(seen["seams_by_blender"], seams);
    }
  } else if (file.ends_with(".ply")) {
    expectWhole(seen, charted, input.faceCount(), placesOf(charted));
    EXPECT_EQ(seen["corners"], input.corners.size());
  } else {
    expectWhole(seen, charted, charted.mesh->triangleCount(), placesOf(charted));
  }
}

TEST(Blender, OpensEveryFormatAsWritten) {
  const std::filesystem::path blender = findTool("blender");
  if (blender.empty()) GTEST_SKIP() << "Blender is not installed";
  const TemporaryFolder folder;
  const std::vector<Sample> all = samples();
  std::vector<std::string> words{blender.string(),
                                 "--background",
                                 "--factory-startup",
                                 "--python-exit-code",
                                 "1",
                                 "--python",
                                 kScripts + "open_in_blender.py",
                                 "--",
                                 "seen.json"};
  for (const Sample& sample : all) {
    for (const MeshFormat& format : meshFormats()) {
      if (format.write == nullptr) continue;
      words.push_back(sample.name + "." + format.extension);
      writeMesh(folder.path() / words.back(), sample.charted.view());
    }
  }
  const ProgramRun run = runProgramIn(folder.path(), words);
  ASSERT_EQ(run.exitCode, 0) << run.output << run.errors;
  bool noNumpy = false;
  std::size_t opened = 0;
  for (const json& seen : json::parse(readAll(folder.path() / "seen.json"))) {
    const std::string file = seen["file"];
    if (seen.contains("error") && std::string(seen["error"]).find("'numpy'") != std::string::npos) {
      noNumpy = true;
      continue;
    }
    for (const Sample& sample : all) {
      if (file.starts_with(sample.name + ".")) expectAsWritten(seen, sample.charted);
    }
    ++opened;
  }
  EXPECT_GE(opened, all.size() * 2);
  if (noNumpy) GTEST_SKIP() << "Blender opens GLB only where python3-numpy is installed";
}

TEST(Blender, SeesSeamsAsLines) {
  const std::filesystem::path blender = findTool("blender");
  if (blender.empty()) GTEST_SKIP() << "Blender is not installed";
  const TemporaryFolder folder;
  const Charted cube = inPatches(quadCube(), 1);
  writeFileAtomically(folder.path() / "seams.obj", seamsText(cube.view()));
  const ProgramRun run = runProgramIn(
      folder.path(),
      {blender.string(), "--background", "--factory-startup", "--python-exit-code", "1", "--python",
       kScripts + "open_in_blender.py", "--", "seen.json", "seams.obj"});
  ASSERT_EQ(run.exitCode, 0) << run.output << run.errors;
  for (const json& seen : json::parse(readAll(folder.path() / "seen.json"))) {
    SCOPED_TRACE(std::string(seen["importer"]));
    ASSERT_FALSE(seen.contains("error")) << seen["error"];
    EXPECT_EQ(seen["edges"], 12);
    EXPECT_EQ(seen["vertices"], 8);
    EXPECT_EQ(seen["faces"], 0);
  }
}

TEST(GltfValidator, FindsNothingWrong) {
  const std::filesystem::path node = findTool("node");
  if (node.empty()) GTEST_SKIP() << "Node.js is not installed";
  const TemporaryFolder folder;
  const std::string found = "require('gltf-validator')";
  if (runProgramIn(folder.path(), {node.string(), "-e", found}).exitCode != 0) {
    GTEST_SKIP() << "the package gltf-validator is in no folder that NODE_PATH names";
  }
  std::vector<Sample> all = samples();
  all.push_back({"odd", inPatches(oddMesh(), 2)});
  Charted bare = inPatches(quadCube(), 2);
  bare.atlas.uv.clear();
  all.push_back({"bare", std::move(bare)});
  std::vector<std::string> words{node.string(), kScripts + "validate_glb.js"};
  for (const Sample& sample : all) {
    words.push_back(sample.name + ".glb");
    writeMesh(folder.path() / words.back(), sample.charted.view());
  }
  const ProgramRun run = runProgramIn(folder.path(), words);
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  const json reports = json::parse(run.output);
  ASSERT_EQ(reports.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(all[i].name);
    EXPECT_EQ(reports[i]["errors"], 0) << reports[i]["messages"];
    EXPECT_EQ(reports[i]["warnings"], 0) << reports[i]["messages"];
    EXPECT_EQ(reports[i]["info"]["totalTriangleCount"], all[i].charted.mesh->triangleCount());
    EXPECT_EQ(reports[i]["info"]["drawCallCount"], 1);
  }
}

}  // namespace
}  // namespace chartflood::test
