// The door to all writers: formats by extension, files complete or not at all.

#include "core/io/write_mesh.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "export_support.h"
#include "io_support.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {
namespace {

TEST(WriteMesh, ChoosesTheFormatByTheExtension) {
  const Charted cube = inPatches(quadCube(), 1);
  EXPECT_EQ(meshBytes("a/b.obj", cube.view()), objText(cube.view()));
  EXPECT_EQ(meshBytes("b.PLY", cube.view()), plyBytes(cube.view()));
  EXPECT_EQ(meshBytes("b.c.Glb", cube.view()), glbBytes(cube.view()));
  for (const char* name : {"b.stl", "obj", "b.", "b.obj.txt"}) {
    EXPECT_FALSE(canWriteMesh(name)) << name;
    EXPECT_THROW(meshBytes(name, cube.view()), UsageError) << name;
  }
  for (const MeshFormat& format : meshFormats()) {
    EXPECT_EQ(canWriteMesh(std::string("b.") + format.extension), format.write != nullptr);
  }
  EXPECT_EQ(writtenExtensions(), (std::vector<std::string>{".obj", ".ply", ".glb"}));
}

TEST(WriteMesh, LeavesTheOldFileWhenItFails) {
  const TemporaryFolder folder;
  const auto huge = meshOf({{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, {{0, 1, 2}});
  const auto file = folder.write("a.glb", "old");
  EXPECT_THROW(writeMesh(file, inPatches(huge, 1).view()), Error);
  EXPECT_EQ(readWholeFile(file), "old");
  const Charted cube = inPatches(quadCube(), 1);
  writeMesh(file, cube.view());
  EXPECT_EQ(readWholeFile(file), glbBytes(cube.view()));
  EXPECT_THROW(writeMesh(folder.path() / "none" / "a.obj", cube.view()), WriteError);
}

}  // namespace
}  // namespace chartflood::test
