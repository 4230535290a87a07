// The answer of the importing program: what goes in comes out, and nothing broken gets through.

#include <cstring>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/io/read/import_reply.h"

namespace chartflood {
namespace {

std::string bytesOfReply(const ImportReply& reply) {
  std::string bytes;
  writeImportReply(reply, [&](std::span<const std::byte> more) {
    bytes.append(reinterpret_cast<const char*>(more.data()), more.size());
    return true;
  });
  return bytes;
}

bool readBytesOfReply(std::string_view bytes, ImportReply& reply, std::size_t longest = 1 << 20) {
  return readImportReply(reply, longest, [&](std::span<std::byte> to) {
    if (to.size() > bytes.size()) return false;
    if (!to.empty()) std::memcpy(to.data(), bytes.data(), to.size());
    bytes.remove_prefix(to.size());
    return true;
  });
}

ImportReply quadAndTriangle() {
  ImportReply reply;
  reply.outcome = ImportOutcome::Mesh;
  reply.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 1e-300}};
  reply.mesh.corners = {0, 1, 2, 3, 1, 4, 2};
  reply.mesh.faceStart = {0, 4, 7};
  reply.pointsAndLines = 3;
  reply.mesh.repairs = {{"poses-ignored", 2, "Two poses."}, {"", 0, ""}};
  return reply;
}

TEST(ImportReply, ComesOutAsItWentIn) {
  const ImportReply in = quadAndTriangle();
  ImportReply out;
  ASSERT_TRUE(readBytesOfReply(bytesOfReply(in), out));
  EXPECT_EQ(out.outcome, ImportOutcome::Mesh);
  EXPECT_EQ(out.mesh.positions, in.mesh.positions);
  EXPECT_EQ(out.mesh.corners, in.mesh.corners);
  EXPECT_EQ(out.mesh.faceStart, in.mesh.faceStart);
  EXPECT_EQ(out.pointsAndLines, 3u);
  ASSERT_EQ(out.mesh.repairs.size(), 2u);
  EXPECT_EQ(out.mesh.repairs[0].what, "poses-ignored");
  EXPECT_EQ(out.mesh.repairs[0].count, 2u);
  EXPECT_EQ(out.mesh.repairs[0].text, "Two poses.");
  ImportReply refusal;
  refusal.reason = "no such thing";
  ASSERT_TRUE(readBytesOfReply(bytesOfReply(refusal), out));
  EXPECT_EQ(out.outcome, ImportOutcome::Refused);
  EXPECT_EQ(out.reason, "no such thing");
}

TEST(ImportReply, CutShortIsNone) {
  const std::string whole = bytesOfReply(quadAndTriangle());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    ImportReply out;
    EXPECT_FALSE(readBytesOfReply(whole.substr(0, length), out)) << length;
  }
}

TEST(ImportReply, MoreThanAllowedIsNone) {
  ImportReply out;
  EXPECT_FALSE(readBytesOfReply(bytesOfReply(quadAndTriangle()), out, 100));
}

TEST(ImportReply, NumbersThatDoNotFitAreNone) {
  ImportReply out;
  ImportReply corner = quadAndTriangle();
  corner.mesh.corners[5] = 5;
  EXPECT_FALSE(readBytesOfReply(bytesOfReply(corner), out));
  ImportReply order = quadAndTriangle();
  order.mesh.faceStart = {0, 9, 7};
  EXPECT_FALSE(readBytesOfReply(bytesOfReply(order), out));
  ImportReply end = quadAndTriangle();
  end.mesh.faceStart.back() = 6;
  EXPECT_FALSE(readBytesOfReply(bytesOfReply(end), out));
  ImportReply triangles = quadAndTriangle();
  triangles.mesh.faceStart.clear();
  EXPECT_FALSE(readBytesOfReply(bytesOfReply(triangles), out)) << "seven corners are no triangles";
}

/// Every byte of the answer turned over once: refused or a mesh whose numbers fit.
TEST(ImportReply, ChangedBytesNeverGiveABrokenMesh) {
  const std::string whole = bytesOfReply(quadAndTriangle());
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(~changed[at]);
    ImportReply out;
    if (!readBytesOfReply(changed, out)) continue;
    for (const Index corner : out.mesh.corners) EXPECT_LT(corner, out.mesh.positions.size()) << at;
    if (!out.mesh.faceStart.empty()) {
      EXPECT_EQ(out.mesh.faceStart.back(), out.mesh.corners.size()) << at;
    }
  }
}

}  // namespace
}  // namespace chartflood
