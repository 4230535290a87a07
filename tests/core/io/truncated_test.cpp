/// Small files of each format, cut at every byte, and with every byte changed: never a crash, never
/// a face that names a vertex that is not there.

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "io_support.h"

namespace chartflood::test {
namespace {

struct SmallFile {
  const char* name;
  std::string bytes;
  std::size_t faces;
  std::size_t needed;  ///< of so many bytes all are needed; behind them follow blanks and comments
};

std::string tetrahedronPly(bool binary) {
  std::string text =
      "ply\nformat " + std::string(binary ? "binary_little_endian" : "ascii") +
      " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  if (!binary) {
    return text + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  }
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f}) {
    text += bytesOf(x);
  }
  for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    text += '\3';
    for (const int v : face) text += bytesOf(v);
  }
  return text;
}

std::string triangleGlb() {
  std::string text =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36}],"bufferViews":[{"buffer":0,)"
      R"("byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,)"
      R"("type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string data;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) data += bytesOf(x);
  const auto total = static_cast<std::uint32_t>(28 + text.size() + data.size());
  return "glTF" + bytesOf(2u) + bytesOf(total) + bytesOf(static_cast<std::uint32_t>(text.size())) +
         "JSON" + text + bytesOf(36u) + std::string("BIN\0", 4) + data;
}

std::string triangleStl() {
  std::string bytes(80, 'x');
  bytes += bytesOf(1u) + std::string(12, '\0');
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) bytes += bytesOf(x);
  return bytes + std::string(2, '\0');
}

std::vector<SmallFile> smallFiles() {
  const std::string off =
      "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  const std::string ply = tetrahedronPly(false), bply = tetrahedronPly(true);
  const std::string glb = triangleGlb(), bstl = triangleStl();
  return {{"a.off", off, 4, off.size() - 1},     {"a.obj", obj, 4, 0},
          {"text.stl", stl, 1, stl.size() - 12}, {"text.ply", ply, 4, ply.size() - 1},
          {"binary.ply", bply, 4, bply.size()},  {"a.glb", glb, 1, glb.size()},
          {"binary.stl", bstl, 1, bstl.size()}};
}

/// Reads and builds. \returns whether the file was taken; every face then names vertices that exist
bool survives(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
  try {
    const auto input = readMesh(folder.write(name, bytes));
    for (const Index corner : input->corners) {
      if (corner >= input->positions.size()) ADD_FAILURE() << name << " names a missing vertex";
    }
    buildMesh(input);
    return true;
  } catch (const ReadError&) {
    return false;
  }
}

TEST(Truncated, EveryLengthIsTakenOrRefused) {
  const TemporaryFolder folder;
  for (const SmallFile& file : smallFiles()) {
    SCOPED_TRACE(file.name);
    EXPECT_EQ(readBytes(file.name, file.bytes)->faceCount(), file.faces);
    for (std::size_t length = 0; length < file.bytes.size(); ++length) {
      const bool taken = survives(folder, file.name, file.bytes.substr(0, length));
      EXPECT_FALSE(taken && length < file.needed) << "cut after " << length << " bytes";
    }
  }
}

TEST(Truncated, EveryChangedByteIsTakenOrRefused) {
  const TemporaryFolder folder;
  for (const SmallFile& file : smallFiles()) {
    SCOPED_TRACE(file.name);
    std::size_t refused = 0;
    for (std::size_t at = 0; at < file.bytes.size(); ++at) {
      for (const char value : {'\0', '\xff', '-', '9', '\n'}) {
        std::string bytes = file.bytes;
        bytes[at] = value;
        refused += survives(folder, file.name, bytes) ? 0 : 1;
      }
    }
    EXPECT_GT(refused, 0u);
  }
}

}  // namespace
}  // namespace chartflood::test
