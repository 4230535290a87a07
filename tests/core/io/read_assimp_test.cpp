// What the import library opens, through the program that runs it.

#include <array>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/base/error.h"
#include "core/io/mesh_formats.h"
#include "core/io/read/read_assimp.h"
#include "core/io/read_mesh.h"
#include "io_support.h"

namespace chartflood::test {
namespace {

using testing::HasSubstr;
using testing::Not;

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
  for (const MeshFormat& format : meshFormats()) {
    const std::string name = std::string("a.") + format.extension;
    const std::string cause = refusalOf(name, "this is no mesh at all, whatever the name says");
    EXPECT_NE(cause, "") << name;
    EXPECT_LE(cause.size(), 230u) << cause;
    EXPECT_THAT(cause, Not(HasSubstr("\n")));
  }
}

TEST(ReadAssimp, SaysWhatTheLibraryFoundAndWhatNext) {
  EXPECT_EQ(
      refusalOf("a.fbx", "; FBX 7.3.0 project file\n}"),
      "the import library refuses it (FBX-DOM no FBXHeaderExtension dictionary found); save it "
      "as glTF or OBJ in the program that made it");
}

/// Over what it cannot do the library breaks down; that costs a sentence here.
TEST(ReadAssimp, SurvivesABreakdownOfTheLibrary) {
  std::string deep = "<?xml version=\"1.0\"?><X3D><Scene>", end;
  for (int i = 0; i < 200000; ++i) {
    deep += "<Group>";
    end += "</Group>";
  }
  const std::string cause = refusalOf("a.x3d", deep + "<Shape/>" + end + "</Scene></X3D>");
  // A sanitizer ends the program in its own way.
  EXPECT_THAT(cause, testing::AnyOf("the import library broke down over it (signal 11); save it as "
                                    "glTF or OBJ in the program that made it",
                                    HasSubstr("the import library gave no mesh")));
}

TEST(ReadAssimp, LimitsTheMemoryOfTheLibrary) {
#if defined(CHARTFLOOD_SHADOW_MEMORY)
  GTEST_SKIP() << "sanitizers reserve more than any limit";
#endif
  EXPECT_EQ(
      refusalOf("a.x", "xof 0303txt 0032\nMesh Body {\n 300000000;\n 0.0;0.0;0.0;,\n}\n"),
      "the import library needs more than 1024 megabytes of memory for it; save it as glTF or "
      "OBJ in the program that made it");
}

TEST(ReadAssimp, NamesBlendersThatAreKnownInPart) {
  const std::string rest = "REND" + std::string(200, '\0');
  EXPECT_EQ(
      refusalOf("a.blend", "BLENDER-v402" + rest),
      "it is of Blender 4.2, whose files the import library knows in part; export glTF or OBJ "
      "from Blender");
  EXPECT_THAT(refusalOf("a.blend", "BLENDER17-01v0500" + rest), HasSubstr("Blender 5.0,"));
  EXPECT_THAT(refusalOf("a.blend", "\x28\xb5\x2f\xfd packed"), HasSubstr("Blender 3.0 or later,"));
  EXPECT_THAT(refusalOf("a.blend", "BLENDER-v249" + rest), Not(HasSubstr("of Blender")));
}

std::string refusalOfFile(const std::filesystem::path& file) {
  try {
    readMesh(file);
  } catch (const ReadError& error) {
    return error.cause();
  }
  return "";
}

/// X3D with another X3D in its place.
std::string inlined(const std::string& url) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><X3D version=\"3.0\"><Scene><Inline url=\"" +
         url +
         "\" load=\"true\"/><Shape><IndexedFaceSet coordIndex='0 1 2 -1'><Coordinate point='0 0 0 "
         "1 "
         "0 0 0 1 0'/></IndexedFaceSet></Shape></Scene></X3D>";
}

TEST(ReadAssimp, OpensNothingOutsideOfTheFolder) {
  const TemporaryFolder folder;
  const auto inside = folder / "inside";
  std::filesystem::create_directories(inside / "below");
  const std::string gltf =
      R"({"asset":{"version":"1.0"},"scene":"s","scenes":{"s":{"nodes":["n"]}},
"nodes":{"n":{"meshes":["m"]}},
"meshes":{"m":{"primitives":[{"attributes":{"POSITION":"a"},"indices":"i","mode":4}]}},
"accessors":{"a":{"bufferView":"v","byteOffset":0,"componentType":5126,"count":3,"type":"VEC3"},
"i":{"bufferView":"w","byteOffset":0,"componentType":5123,"count":3,"type":"SCALAR"}},
"bufferViews":{"v":{"buffer":"b","byteOffset":0,"byteLength":36,"target":34962},
"w":{"buffer":"b","byteOffset":36,"byteLength":6,"target":34963}},
"buffers":{"b":{"byteLength":42,"type":"arraybuffer","uri":"PLACE"}}})";
  std::string buffer;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) buffer += bytesOf(x);
  for (std::uint16_t i = 0; i < 3; ++i) buffer += bytesOf(i);
  for (const char* place : {"inside/a.bin", "inside/below/a.bin", "secret.bin"}) {
    folder.write(place, buffer);
  }
  std::filesystem::create_symlink("../secret.bin", inside / "link.bin");
  std::filesystem::create_symlink("below/a.bin", inside / "good-link.bin");
  ASSERT_EQ(::mkfifo((inside / "pipe.bin").c_str(), 0600), 0);
  std::filesystem::path place = inside;
  const auto reads = [&](const std::string& uri) {
    std::string text = gltf;
    text.replace(text.find("PLACE"), 5, uri);
    const Source source{text, "a.gltf", place};
    try {
      return readAssimp(source, "gltf").faceCount() == 1;
    } catch (const ReadError&) {
      return false;
    }
  };
  for (const char* uri : {"a.bin", "below/a.bin", "good-link.bin"}) EXPECT_TRUE(reads(uri)) << uri;
  for (const std::string& uri :
       {std::string("../secret.bin"), std::string("below/../../secret.bin"),
        std::string("link.bin"), std::string("pipe.bin"), std::string("/dev/zero"),
        (folder / "secret.bin").string()}) {
    EXPECT_FALSE(reads(uri)) << uri;
  }
  place = std::filesystem::relative(inside);
  EXPECT_TRUE(reads("below/a.bin")) << "as users name folders";
  EXPECT_FALSE(reads("../secret.bin"));
}

/// Reading a pipe would never end.
TEST(ReadAssimp, DoesNotWaitForPipes) {
  const TemporaryFolder folder;
  folder.write("other.x3d", inlined(""));
  ASSERT_EQ(::mkfifo((folder / "pipe.x3d").c_str(), 0600), 0);
  EXPECT_EQ(readMesh(folder.write("a.x3d", inlined("other.x3d")))->faceCount(), 2u);
  for (const char* url : {"pipe.x3d", "/dev/zero"}) {
    EXPECT_THAT(refusalOfFile(folder.write("a.x3d", inlined(url))),
                HasSubstr("Failed to open file"))
        << url;
  }
}

/// Bodies of figures, as games keep them; the import library has crashed over such files.
TEST(ReadAssimp, TakesSkinnedFigures) {
  const std::string identity = "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;;";
  const auto mesh =
      readBytes("a.x", "xof 0303txt 0032\nFrame Bone { FrameTransformMatrix { " + identity +
                           " } }\nMesh Body { 4; 0.0;0.0;0.0;, 1.0;0.0;0.0;, 0.0;1.0;0.0;, "
                           "0.0;0.0;1.0;; 4; 3;0,2,1;, 3;0,1,3;, 3;1,2,3;, 3;2,0,3;;\n"
                           "XSkinMeshHeader { 1; 1; 1; } SkinWeights { \"Bone\"; 4; 0,1,2,3; "
                           "1.0,1.0,0.5,0.5; " +
                           identity + " } }\n");
  EXPECT_EQ(mesh->faceCount(), 4u);
  EXPECT_EQ(mesh->positions.size(), 4u);
}

TEST(ReadAssimp, CanBeCancelledAndReadOnManyThreads) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.dae", collada("1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1"));
  Progress progress;
  progress.cancel();
  EXPECT_EQ(readMesh(file, &progress), nullptr);
  std::vector<std::thread> threads;
  std::array<std::size_t, 6> faces{};
  for (std::size_t& count : faces) {
    threads.emplace_back([&count, &file] { count = readMesh(file)->faceCount(); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::size_t count : faces) EXPECT_EQ(count, 2u);
}

}  // namespace
}  // namespace chartflood::test
