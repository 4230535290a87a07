#include <gtest/gtest.h>

#include "io_support.h"

namespace chartflood::test {
namespace {

using Faces = std::vector<std::vector<Index>>;

constexpr const char* kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Faces facesAfter(const std::string& lines) {
  return facesOf(*readBytes("a.obj", kCorners + lines));
}
std::string refusalAfter(const std::string& lines) { return refusalOf("a.obj", kCorners + lines); }

TEST(ReadObj, KeepsVerticesAndPolygonsInTheirOrder) {
  const auto mesh = readBytes("a.obj", std::string(kCorners) + "f 4 3 2 1\nf 1 2 3\n");
  ASSERT_EQ(mesh->positions.size(), 4u);
  EXPECT_EQ(mesh->positions[2], glm::dvec3(1, 1, 0));
  EXPECT_EQ(facesOf(*mesh), (Faces{{3, 2, 1, 0}, {0, 1, 2}}));
  EXPECT_TRUE(mesh->repairs.empty());
}

TEST(ReadObj, TakesEveryFormOfCorner) {
  EXPECT_EQ(facesAfter("vt 0 0\nvn 0 0 1\nf 1/1 2//1 3/1/1 4/\n"), (Faces{{0, 1, 2, 3}}));
  EXPECT_EQ(facesAfter("f 1// 2// 3//\n"), (Faces{{0, 1, 2}}));
}

TEST(ReadObj, CountsNegativeNumbersBackFromThePresentVertex) {
  EXPECT_EQ(facesAfter("f -4 -3 -2\nv 5 5 5\nf -1 -2 -3\n"), (Faces{{0, 1, 2}, {4, 3, 2}}));
}

TEST(ReadObj, TakesVerticesThatFollowTheirFaces) {
  EXPECT_EQ(facesOf(*readBytes("a.obj", std::string("f 1 2 3\n") + kCorners)), (Faces{{0, 1, 2}}));
}

TEST(ReadObj, TakesAllLineEndsBlanksCommentsAndContinuations) {
  EXPECT_EQ(facesAfter("f 1 2 \\\n 3 4\n"), (Faces{{0, 1, 2, 3}}));
  EXPECT_EQ(facesAfter("f 1 2 \\\r\n3\r\n"), (Faces{{0, 1, 2}}));
  EXPECT_EQ(facesAfter("\tf\t1  2 3 # a comment with \\\nf 2 3 4"), (Faces{{0, 1, 2}, {1, 2, 3}}));
  EXPECT_EQ(facesOf(*readBytes("a.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r")),
            (Faces{{0, 1, 2}}));
  EXPECT_EQ(facesOf(*readBytes("a.obj", "\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
            (Faces{{0, 1, 2}}));
}

TEST(ReadObj, ABackslashInANameIsPartOfTheName) {
  EXPECT_EQ(facesAfter("o folder\\\nf 1 2 3\n"), (Faces{{0, 1, 2}}));
}

TEST(ReadObj, KeepsFacesThatCannotBeUsedForTheNumbering) {
  EXPECT_EQ(facesAfter("f 1\nf\nf 1 2 3\nf 2 2 3\n"), (Faces{{0}, {}, {0, 1, 2}, {1, 1, 2}}));
}

TEST(ReadObj, ReportsWhatItLeavesOut) {
  const auto mesh = readBytes(
      "a.obj", std::string(kCorners) + "vt 0 0\nl 1 2\np 1\nwhatever 5\nf 1/2 2/1 3/1\nf 1 2 4\n");
  EXPECT_EQ(countOf(mesh->repairs, "points-and-lines-ignored"), 2u);
  EXPECT_EQ(countOf(mesh->repairs, "unknown-lines-ignored"), 1u);
  EXPECT_EQ(countOf(mesh->repairs, "missing-texture-coordinates"), 1u);
}

TEST(ReadObj, TextureCoordinatesMayFollowTheirFaces) {
  const auto mesh = readBytes("a.obj", std::string(kCorners) + "f 1/1 2/1 3/1\nvt 0 0\n");
  EXPECT_TRUE(mesh->repairs.empty());
}

TEST(ReadObj, ReadsCoordinatesExactly) {
  const auto mesh = readBytes("a.obj", "v 0.1 -2.5e-3 1e22\nv +1 .5 2.\n"
                                       "v 1.7976931348623157e308 4.9e-324 0.30000000000000004\n"
                                       "f 1 2 3\n");
  EXPECT_EQ(mesh->positions[0], glm::dvec3(0.1, -2.5e-3, 1e22));
  EXPECT_EQ(mesh->positions[1], glm::dvec3(1, .5, 2));
  EXPECT_EQ(mesh->positions[2], glm::dvec3(1.7976931348623157e308, 4.9e-324, 0.30000000000000004));
}

TEST(ReadObj, RefusesWithTheLine) {
  EXPECT_EQ(refusalAfter("f 1 2 9\n"), "line 5 names vertex 9 but there are 4");
  EXPECT_EQ(refusalAfter("f 1 2 0\n"),
            "line 5 names vertex 0, but OBJ files count vertices from 1");
  EXPECT_EQ(refusalAfter("f 1 2 -5\n"), "line 5 counts 5 vertices back, but only 4 came before it");
  EXPECT_EQ(refusalAfter("\n\nf 1 2 x\n"), "line 7 has \"x\" where a vertex number is expected");
  EXPECT_EQ(refusalAfter("f 1 2 3.5\n"), "line 5 has \"3.5\" where a vertex number is expected");
  EXPECT_EQ(refusalAfter("f 1 2 99999999999999999999\n"),
            "line 5 names vertex \"99999999999999999999\", which cannot exist");
  EXPECT_EQ(refusalAfter("v 1 2\n"), "line 5 gives fewer than three coordinates for a vertex");
  EXPECT_EQ(refusalAfter("v 1,5 2 3\n"), "line 5 has \"1,5\" where a coordinate is expected");
  EXPECT_EQ(refusalAfter("v 1 2 1e999\n"), "line 5 has \"1e999\", which is too large a number");
}

TEST(ReadObj, RefusesFilesWithoutFacesAndOtherContent) {
  EXPECT_EQ(refusalAfter(""), "it has 4 vertices but no faces");
  EXPECT_EQ(refusalOf("a.obj", "# nothing\n"), "it is not an OBJ mesh: no line gives a vertex");
  EXPECT_EQ(refusalOf("a.obj", ""), "the file is empty");
  EXPECT_EQ(refusalOf("a.obj", std::string("v\0", 2)), "it holds binary data where OBJ is text");
  EXPECT_EQ(refusalOf("a.obj", "\xff\xfe"
                               "v"),
            "its text is UTF-16; save it as plain text (UTF-8)");
  EXPECT_EQ(refusalOf("a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
            "vertex 1 has a coordinate that is not a finite number");
}

TEST(ReadObj, KeepsVerticesThatBuildingJoins) {
  const auto mesh = buildBytes("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 -0\n"
                                        "f 1 2 3\nf 4 5 6\n");
  EXPECT_EQ(countOf(mesh->repairs(), "welded-vertices"), 2u);
  EXPECT_EQ(mesh->componentCount(), 1u);
  EXPECT_EQ(mesh->input().positions.size(), 6u);
}

TEST(ReadObj, LeavesApartWhatIsApart) {
  const auto mesh = buildBytes("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 3 1 0\nv 2 1 0\n"
                                        "f 1 2 3\nf 4 5 6\n");
  EXPECT_TRUE(mesh->repairs().empty());
}

}  // namespace
}  // namespace chartflood::test
