// 3MF: packages as slicers and CAD programs write them, and what must not get through.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/read_mesh.h"
#include "io_support.h"
#include "tests/support/zip_archive.h"

namespace chartflood::test {
namespace {

using testing::HasSubstr;

std::string object(int id, const std::string& content) {
  return "<object id=\"" + std::to_string(id) + "\" type=\"model\">" + content + "</object>";
}

std::string components(const std::string& list) { return "<components>" + list + "</components>"; }

std::shared_ptr<const InputMesh> readModel(const std::string& resources, const std::string& build,
                                           const std::string& attributes = "",
                                           const ZipFiles& more = {}) {
  return readBytes("a.3mf", package3mf(model3mf(resources, build, attributes), more));
}

std::string refusalOfModel(const std::string& resources, const std::string& build,
                           const std::string& attributes = "") {
  return refusalOf("a.3mf", package3mf(model3mf(resources, build, attributes)));
}

/// Six times the volume that the faces enclose: negative when they are turned inwards.
double sixVolumes(const InputMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    const glm::dvec3 a = mesh.positions[face[0]], b = mesh.positions[face[1]],
                     c = mesh.positions[face[2]];
    sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
  }
  return sum;
}

TEST(Read3mf, TakesWhatSlicersWrite) {
  for (const char* name :
       {"3mf-with-thumbnail.3mf", "3mf-production-extension.3mf", "3mf-zip64-entries.3mf"}) {
    const auto mesh = readFile(std::string(CHARTFLOOD_CASES) + "/" + name);
    EXPECT_EQ(mesh->faceCount(), 12u) << name;
    EXPECT_EQ(mesh->positions.size(), 8u) << name;
    EXPECT_EQ(mesh->repairs.size(), 0u) << name;
  }
}

TEST(Read3mf, MovesItemsAndComponents) {
  // Rows of a transform: where x, y and z go, then the shift. z goes to x, x to y, y to z.
  const auto mesh = readModel(
      object(1, cubeMesh3mf()) +
          object(2, components("<component objectid=\"1\" transform=\"2 0 0 0 2 0 0 0 2 0 0 0\"/>"
                               "<component objectid=\"1\"/>")),
      "<item objectid=\"2\" transform=\"0 1 0 0 0 1 1 0 0 10 20 30\"/><item objectid=\"1\"/>");
  ASSERT_EQ(mesh->positions.size(), 24u);
  EXPECT_EQ(mesh->faceCount(), 36u);
  EXPECT_EQ(mesh->positions[1], glm::dvec3(10, 22, 30)) << "twice x";
  EXPECT_EQ(mesh->positions[4], glm::dvec3(12, 20, 30)) << "twice z";
  EXPECT_EQ(mesh->positions[9], glm::dvec3(10, 21, 30));
  EXPECT_EQ(mesh->positions[17], glm::dvec3(1, 0, 0));
  EXPECT_DOUBLE_EQ(sixVolumes(*mesh), 6 * (8 + 1 + 1));
}

TEST(Read3mf, TurnsFacesOfMirroredItems) {
  const auto mesh = readModel(object(1, cubeMesh3mf()),
                              "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>");
  EXPECT_DOUBLE_EQ(sixVolumes(*mesh), 6);
}

TEST(Read3mf, FollowsPathsIntoOtherParts) {
  const std::string other = model3mf(object(7, cubeMesh3mf(5)), "", "unit=\"centimeter\"");
  const auto mesh = readModel(
      object(2, components("<component objectid=\"7\" p:path=\"/3D/Objects/one.model\"/>")),
      "<item objectid=\"2\"/><item objectid=\"7\" p:path=\"/3d/objects/ONE.model\"/>",
      "unit=\"millimeter\" requiredextensions=\"p\"", {{"3D/Objects/one.model", other}});
  ASSERT_EQ(mesh->positions.size(), 16u);
  EXPECT_EQ(mesh->positions[0], glm::dvec3(50, 0, 0)) << "in the unit of the main part";
  EXPECT_EQ(mesh->positions[15], glm::dvec3(60, 10, 10));
}

TEST(Read3mf, BuildsWhatIsBuiltAndElseEverything) {
  const std::string two = object(1, cubeMesh3mf()) + object(2, cubeMesh3mf(5));
  EXPECT_EQ(readModel(two, "<item objectid=\"2\"/>")->positions[0], glm::dvec3(5, 0, 0));
  const auto all = readModel(two + object(3, components("<component objectid=\"1\"/>")), "");
  EXPECT_EQ(all->faceCount(), 24u) << "object 1 is part of object 3";
  EXPECT_EQ(countOf(all->repairs, "nothing-built"), 1u);
}

TEST(Read3mf, SaysWhatItDoesNotRead) {
  const std::string beams = "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/"
                            "2017/02\" requiredextensions=\"b\"";
  const std::string lattice =
      "<b:beams><b:beam v1=\"0\" v2=\"1\"/><b:beam v1=\"1\" v2=\"2\"/></b:beams>";
  const auto mesh = readModel(object(1, cubeMesh3mf() + lattice), "<item objectid=\"1\"/>", beams);
  EXPECT_EQ(countOf(mesh->repairs, "other-shapes-left-out"), 2u);
  EXPECT_THAT(
      refusalOfModel(object(1, "<mesh>" + lattice + "</mesh>"), "<item objectid=\"1\"/>", beams),
      HasSubstr("it needs the 3MF extension"));
}

TEST(Read3mf, RefusesWithPartAndLine) {
  const std::string item = "<item objectid=\"1\"/>";
  EXPECT_EQ(
      refusalOfModel(object(1, "<mesh><vertices><vertex x=\"0\" y=\"zero\" z=\"0\"/></vertices>"
                               "</mesh>"),
                     item),
      "\"3d/main.model\" line 3 has \"zero\" where a coordinate is due");
  EXPECT_EQ(
      refusalOfModel(object(1, "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/></vertices>\n"
                               "<triangles><triangle v1=\"0\" v2=\"1\" v3=\"0\"/></triangles>"
                               "</mesh>"),
                     item),
      "\"3d/main.model\" line 4 names vertex 1 but there are 1 (counted from 0)");
  EXPECT_EQ(refusalOfModel("", item),
            "\"3d/main.model\" has no object 1, although it is used; save the file anew");
  EXPECT_EQ(refusalOfModel(object(1, ""), item), "it has no faces");
  EXPECT_THAT(refusalOfModel(object(1, cubeMesh3mf()), "<item objectid=\"1\" transform=\"1 2\"/>"),
              HasSubstr("12 numbers"));
  EXPECT_THAT(refusalOf("a.3mf", package3mf("<model><resources>")), HasSubstr("is no valid XML"));
  EXPECT_THAT(refusalOf("a.3mf", package3mf("<html/>")), HasSubstr("where model is due"));
  EXPECT_THAT(refusalOfModel(object(1, cubeMesh3mf()),
                             "<item objectid=\"1\" p:path=\"/../../etc/passwd\"/>"),
              HasSubstr("is missing"));
}

TEST(Read3mf, RefusesDamagedArchives) {
  const std::string whole =
      package3mf(model3mf(object(1, cubeMesh3mf()), "<item objectid=\"1\"/>"));
  EXPECT_THAT(refusalOf("a.3mf", whole.substr(0, whole.size() / 2)), HasSubstr("no complete ZIP"));
  EXPECT_THAT(refusalOf("a.3mf", zipArchive({{"a.txt", "nothing"}})),
              HasSubstr("without a 3D model"));
  std::string changed = whole;
  const std::size_t packed = changed.find("3D/Main.model") + 100;
  for (std::size_t i = 0; i < 8; ++i) changed[packed + i] = static_cast<char>(~changed[packed + i]);
  EXPECT_THAT(refusalOf("a.3mf", changed), HasSubstr("is damaged"));
}

/// A few bytes that stand for millions of megabytes end in a sentence, and soon.
TEST(Read3mf, RefusesBombs) {
  // Twice in each, forty deep.
  std::string doubling = object(1, cubeMesh3mf());
  for (int id = 2; id <= 41; ++id) {
    const std::string part = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    doubling += object(id, components(part + part));
  }
  EXPECT_THAT(refusalOfModel(doubling, "<item objectid=\"41\"/>"),
              HasSubstr("it repeats its parts"));
  EXPECT_THAT(refusalOfModel(object(1, components("<component objectid=\"2\"/>")) +
                                 object(2, components("<component objectid=\"1\"/>")),
                             "<item objectid=\"1\"/>"),
              HasSubstr("is a component of itself"));
  std::string deep = object(1, cubeMesh3mf());
  for (int id = 2; id <= 5000; ++id) {
    deep += object(id, components("<component objectid=\"" + std::to_string(id - 1) + "\"/>"));
  }
  EXPECT_THAT(refusalOfModel(deep, "<item objectid=\"5000\"/>"), HasSubstr("deep in each other"));
  const std::string laughs = "<!DOCTYPE model [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\">]>";
  EXPECT_THAT(refusalOf("a.3mf", package3mf(laughs + "<model>&b;</model>")),
              HasSubstr("declares a document type"));
  EXPECT_THAT(refusalOfModel(object(1, cubeMesh3mf()), "<item objectid=\"1\" partnumber=\"" +
                                                           std::string(6 << 20, 'x') + "\"/>"),
              HasSubstr("has a tag of more than 4 megabytes"));
  EXPECT_THAT(refusalOf("a.3mf", package3mf(std::string(std::size_t{80} << 20, ' '))),
              HasSubstr("it unpacks to more than 64 megabytes"));
}

TEST(Read3mf, CanBeCancelled) {
  const TemporaryFolder folder;
  const auto file = folder.write(
      "a.3mf", package3mf(model3mf(object(1, cubeMesh3mf()), "<item objectid=\"1\"/>")));
  Progress progress;
  progress.cancel();
  EXPECT_EQ(readMesh(file, &progress), nullptr);
}

}  // namespace
}  // namespace chartflood::test
