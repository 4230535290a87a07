// Seams as lines: every edge between charts, every cut, and nothing else.

#include "core/io/write/write_seams.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "export_support.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

using Pair = std::pair<Index, Index>;

std::multiset<Pair> linesOf(const ObjFile& obj, const std::string& group) {
  std::multiset<Pair> lines;
  for (const ObjFile::Line& line : obj.lines) {
    if (line.group == group) lines.insert(std::minmax(line.a, line.b));
  }
  return lines;
}

/// Edges of the file whose faces lie in different charts.
std::multiset<Pair> bordersOf(const Charted& charted) {
  std::map<Pair, std::set<Index>> charts;
  const InputMesh& input = charted.mesh->input();
  for (Index f = 0; f < charted.mesh->faceCount(); ++f) {
    const auto face = input.face(charted.mesh->inputFace(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      charts[std::minmax(face[i], face[(i + 1) % face.size()])].insert(charted.label[f]);
    }
  }
  std::multiset<Pair> borders;
  for (const auto& [edge, labels] : charts) {
    if (labels.size() > 1) borders.insert(edge);
  }
  return borders;
}

TEST(WriteSeams, AreTheEdgesBetweenCharts) {
  for (const auto& mesh : {quadCube(), sampleMesh("rocket", 4000), grid(9, false)}) {
    const Charted charted = inPatches(mesh, 1 + mesh->faceCount() / 12);
    const ObjFile obj = parseObj(seamsText(charted.view()));
    EXPECT_EQ(obj.vertices, mesh->input().positions);
    EXPECT_EQ(linesOf(obj, "seams"), bordersOf(charted));
    EXPECT_GT(obj.lines.size(), 5u);
    EXPECT_TRUE(linesOf(obj, "cuts").empty());
  }
}

TEST(WriteSeams, CutsHaveAGroupOfTheirOwn) {
  const auto mesh = grid(4, true);
  Charted charted = chartedMesh(mesh, std::vector<Index>(mesh->faceCount(), 0));
  Index cut = kNone;
  for (Index side = 0; side < mesh->opposite().size(); ++side) {
    if (mesh->sideStart(side) == 6 && mesh->sideEnd(side) == 7) cut = side;
  }
  ASSERT_NE(cut, kNone);
  cutAlong(charted, 0, {cut});
  const ObjFile obj = parseObj(seamsText(charted.view()));
  EXPECT_EQ(linesOf(obj, "cuts"), (std::multiset<Pair>{{6, 7}}));
  EXPECT_TRUE(linesOf(obj, "seams").empty()) << "open borders are no seams";
}

TEST(WriteSeams, FacesThatGluingPartedMeetInASeam) {
  // Three triangles share the edge 0 1.
  const auto mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Charted charted = inPatches(mesh, 1);
  const ObjFile obj = parseObj(seamsText(charted.view()));
  EXPECT_EQ(linesOf(obj, "seams"), (std::multiset<Pair>{{0, 1}}));
}

}  // namespace
}  // namespace chartflood::test
