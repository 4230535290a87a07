#include <limits>

#include <gtest/gtest.h>

#include "io_support.h"

namespace chartflood::test {
namespace {

using Faces = std::vector<std::vector<Index>>;

const std::string kBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 2 1 0\n";

TEST(ReadOff, TakesTheUsualHeaders) {
  for (const std::string head :
       {"OFF\n4 2 0\n", "OFF 4 2 0\n", "OFF4 2 0\n", "# made\n\n OFF # x\n4 2\n", "COFF\n4 2 0\n",
        "STCNOFF\n4 2 0\n", "\xef\xbb\xbfOFF\n4 2 0\n"}) {
    SCOPED_TRACE(head);
    const auto mesh = readBytes("a.off", head + kBody);
    EXPECT_EQ(mesh->positions[2], glm::dvec3(1, 1, 0));
    EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2, 3}, {2, 1, 0}}));
    EXPECT_TRUE(mesh->repairs.empty());
  }
}

TEST(ReadOff, LeavesColoursNormalsAndCommentsAside) {
  const auto mesh = readBytes("a.off", "NCOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 1\n# between\n"
                                       "1 0 0 0 0 1 0 1 0 1 # here\n0 1 0 0 0 1 1 1 1 1\n"
                                       "3 0 1 2 0.5 0.5 0.5\n");
  EXPECT_EQ(mesh->positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2}}));
}

TEST(ReadOff, DividesByTheFourthCoordinate) {
  const auto mesh = readBytes("a.off", "4OFF\n3 1 0\n0 0 0 1\n2 0 4 2\n0 1 0 1\n3 0 1 2\n");
  EXPECT_EQ(mesh->positions[1], glm::dvec3(1, 0, 2));
  EXPECT_EQ(refusalOf("a.off", "4OFF\n3 1 0\n0 0 0 0\n2 0 4 2\n0 1 0 1\n3 0 1 2\n"),
            "line 3 has a point at infinity (its fourth coordinate is 0)");
}

TEST(ReadOff, RefusesWithTheLine) {
  EXPECT_EQ(refusalOf("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 4\n3 2 1 0\n"),
            "line 7 names vertex 4 but there are 4 (counted from 0)");
  EXPECT_EQ(refusalOf("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 -1\n3 2 1 0\n"),
            "line 7 names vertex -1 but there are 4 (counted from 0)");
  EXPECT_EQ(refusalOf("a.off", "OFF\n3 1 0\n0 0 0\n1 0 x\n"),
            "line 4 has \"x\" where a coordinate is due");
  EXPECT_EQ(refusalOf("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
            "line 7 ends the file where a vertex number is due");
  EXPECT_EQ(refusalOf("a.off", "OFF\n353535235358 1 0\n0 0 0\n"),
            "line 2 counts 353535235358 vertices, more than the file can hold");
  EXPECT_EQ(refusalOf("a.off", "OFF\n3 -1 0\n0 0 0\n1 0 0\n0 1 0\n"),
            "line 2 counts fewer than 0 faces");
  EXPECT_EQ(refusalOf("a.off", "OFF BINARY\n"),
            "it is a binary OFF file; save it as text OFF, PLY or OBJ");
  EXPECT_EQ(refusalOf("a.off", "nOFF 4\n"),
            "its points have a number of dimensions of their own (nOFF); save it as OFF");
  EXPECT_EQ(refusalOf("a.off", "3 1 0\n"), "it is not an OFF mesh: it does not begin with OFF");
}

TEST(ReadOff, SaysThatTheFileGoesOn) {
  const auto mesh = readBytes("a.off", "OFF\n4 1 0\n" + kBody);
  EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2, 3}}));
  EXPECT_EQ(countOf(mesh->repairs, "rows-after-end-ignored"), 1u);
}

std::string facet(const std::vector<float>& corners) {
  std::string bytes(12, '\0');
  for (const float x : corners) bytes += bytesOf(x);
  return bytes + std::string(2, '\0');
}

std::string binaryStl(std::uint32_t count, const std::string& facets,
                      const std::string& name = "solid or not") {
  std::string head = name;
  head.resize(80, ' ');
  return head + bytesOf(count) + facets;
}

const std::string kTwoFacets =
    facet({0, 0, 0, 1, 0, 0, 0, 1, 0}) + facet({1, 0, 0, 1, 1, 0, -0.f, 1, 0});

TEST(ReadStl, JoinsCornersAtTheSamePlaceInTheirOrder) {
  const auto mesh = readBytes("a.stl", binaryStl(2, kTwoFacets));
  ASSERT_EQ(mesh->positions.size(), 4u);
  EXPECT_EQ(mesh->positions[3], glm::dvec3(1, 1, 0));
  EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_TRUE(mesh->repairs.empty());
}

TEST(ReadStl, ChecksTheCountAgainstTheLength) {
  const auto longer = readBytes("a.stl", binaryStl(1, kTwoFacets));
  EXPECT_EQ(longer->faceCount(), 2u);
  EXPECT_EQ(countOf(longer->repairs, "facet-count-corrected"), 1u);
  const auto trailing = readBytes("a.stl", binaryStl(2, kTwoFacets + "abc", "x"));
  EXPECT_EQ(trailing->faceCount(), 2u);
  EXPECT_EQ(countOf(trailing->repairs, "bytes-after-end-ignored"), 3u);
  EXPECT_EQ(refusalOf("a.stl", binaryStl(0xffffffff, kTwoFacets)),
            "its header counts 4294967295 triangles but it has room for 2");
  EXPECT_EQ(refusalOf("a.stl", binaryStl(0, "")), "it has no faces");
  EXPECT_EQ(refusalOf("a.stl", "short"), "it is too short for an STL mesh (5 bytes)");
}

TEST(ReadStl, RefusesCoordinatesThatAreNoNumbers) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusalOf("a.stl", binaryStl(1, facet({0, 0, nan, 1, 0, 0, 0, 1, 0}))),
            "vertex 1 has a coordinate that is not a finite number");
}

TEST(ReadStl, TakesText) {
  const std::string triangle = "facet normal nan 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                               "VERTEX 0 1.0e0 0\nendloop\nendfacet\n";
  const auto mesh = readBytes("a.stl", "Solid two words\n" + triangle + triangle +
                                           "endsolid two words\nsolid\nendsolid\n");
  EXPECT_EQ(mesh->positions.size(), 3u);
  EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_EQ(countOf(readBytes("a.stl", "solid\n" + triangle)->repairs, "missing-end"), 1u);
}

TEST(ReadStl, KeepsPolygonsOfText) {
  const auto mesh = readFile(std::string(CHARTFLOOD_CASES) + "/ascii-stl-quad-loops.stl");
  EXPECT_EQ(mesh->faceCount(), 6u);
  for (std::size_t f = 0; f < mesh->faceCount(); ++f) EXPECT_EQ(mesh->face(f).size(), 4u);
  EXPECT_EQ(mesh->positions.size(), 8u);
}

TEST(ReadStl, RefusesBrokenTextWithTheLine) {
  EXPECT_EQ(refusalOf("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
            "line 5 ends the file where \"vertex\" is due");
  EXPECT_EQ(refusalOf("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 "
                               "0\nendloop\n"),
            "line 6 has \"endloop\" where \"vertex\" is due");
  EXPECT_EQ(refusalOf("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 "
                               "0\nvertex 0 0 0\nvertex 0 0 0\nendfacet\n"),
            "line 8 has \"endfacet\" where \"vertex\" or \"endloop\" is due");
  EXPECT_EQ(refusalOf("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n"),
            "line 4 has \"zero\" where a coordinate is due");
  EXPECT_EQ(refusalOf("a.stl", "solid a\nendsolid a\n"), "it has no faces");
}

}  // namespace
}  // namespace chartflood::test
