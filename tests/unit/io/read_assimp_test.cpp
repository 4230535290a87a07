#include <gtest/gtest.h>

#include "io_support.h"

namespace chartflood::test {
namespace {

/// A Collada file with a quad and a triangle below a node that moves them.
std::string collada(const std::string& matrix) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="15">0 0 0 1 0 0 1 1 0 0 1 0 2 0 0</float_array>
<technique_common><accessor source="#pa" count="5" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="2"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 3</vcount>
<p>0 1 2 3 1 4 2</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><matrix>)" +
         matrix + R"(</matrix>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST(ReadAssimp, KeepsPolygonsAndAppliesTransforms) {
  const auto mesh = readBytes("a.dae", collada("1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1"));
  EXPECT_EQ(facesOf(*mesh), (std::vector<std::vector<Index>>{{0, 1, 2, 3}, {1, 4, 2}}));
  ASSERT_EQ(mesh->positions.size(), 5u);
  EXPECT_EQ(mesh->positions[4], glm::dvec3(12, 0, 0));
}

TEST(ReadAssimp, TurnsFacesOfMirroredNodes) {
  const auto mesh = readBytes("a.dae", collada("-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"));
  ASSERT_EQ(mesh->faceCount(), 2u);
  const auto face = mesh->face(0);
  const auto at = [&](std::size_t i) { return mesh->positions[face[i]]; };
  const double area =
      (at(1).x - at(0).x) * (at(2).y - at(0).y) - (at(1).y - at(0).y) * (at(2).x - at(0).x);
  EXPECT_GT(area, 0);
}

TEST(ReadAssimp, RefusesBrokenFiles) {
  for (const char* name : {"a.dae", "a.fbx", "a.3ds", "a.blend", "a.3mf", "a.x", "a.lwo"}) {
    EXPECT_NE(refusalOf(name, "this is no mesh at all, whatever the name says"), "") << name;
  }
}

}  // namespace
}  // namespace chartflood::test
