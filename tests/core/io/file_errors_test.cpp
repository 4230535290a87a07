/// What is no readable file: one sentence each, and nothing hangs.

#include <filesystem>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/io/mesh_formats.h"
#include "core/io/read_mesh.h"
#include "io_support.h"

namespace chartflood::test {
namespace {

std::string causeOf(const std::filesystem::path& file) {
  try {
    readMesh(file);
  } catch (const ReadError& e) {
    EXPECT_NE(std::string(e.what()).find(file.filename().string()), std::string::npos);
    return e.cause();
  }
  return "";
}

TEST(FileErrors, MissingFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(causeOf(folder.path() / "none.obj"), "there is no such file");
}

TEST(FileErrors, ALongNameIsToldByItsEnd) {
  const std::string folders = std::string(2000, 'a') + "/\xc3\xa4";
  const std::string text = ReadError(folders + std::string(297, 'b') + ".x", "it is empty").what();
  EXPECT_EQ(text, "Could not read .." + std::string(297, 'b') + ".x: it is empty.");
}

TEST(FileErrors, FileBelowAFile) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.obj", "v 0 0 0\n");
  EXPECT_EQ(causeOf(file / "b.obj"), "a part of its path is not a folder");
}

TEST(FileErrors, Folder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "a.obj");
  EXPECT_EQ(causeOf(folder.path() / "a.obj"), "it is a folder; name a file in it");
}

TEST(FileErrors, LinkThatLeadsNowhere) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("gone.obj", folder.path() / "a.obj");
  EXPECT_EQ(causeOf(folder.path() / "a.obj"),
            "it is a symbolic link to a file that does not exist");
}

TEST(FileErrors, LinkThatLeadsToItself) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b.obj", folder.path() / "a.obj");
  std::filesystem::create_symlink("a.obj", folder.path() / "b.obj");
  EXPECT_EQ(causeOf(folder.path() / "a.obj"), "it is a symbolic link that leads back to itself");
}

TEST(FileErrors, PipeIsNotWaitedFor) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.obj";
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  EXPECT_EQ(causeOf(file), "it is a pipe; only files can be read");
}

TEST(FileErrors, Device) {
  EXPECT_EQ(causeOf("/dev/null"), "it is a device or socket; only files can be read");
}

TEST(FileErrors, NoPermission) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  const auto file = folder.write("a.obj", "v 0 0 0\n");
  ASSERT_EQ(::chmod(file.c_str(), 0), 0);
  EXPECT_EQ(causeOf(file), "you have no permission to read it");
}

TEST(FileErrors, LargerThanItsKindMayBe) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", std::string(3000, 'x'));
  EXPECT_EQ(FileBytes(file, {3000, "a list"}).view().size(), 3000u);
  std::filesystem::resize_file(file, 3'000'000'000);  // takes no room on the disk
  try {
    FileBytes(file, {2'000'000, "a list"});
    ADD_FAILURE() << "was read";
  } catch (const ReadError& e) {
    EXPECT_EQ(e.cause(), "it is too large for a list: it has 3000 MB, and 2 MB is the most");
  }
}

TEST(FileErrors, CausesAreShort) {
  EXPECT_EQ(ReadError("a", std::string(300, 'x')).cause().size(), 300u);
  EXPECT_EQ(ReadError("a", std::string(301, 'x')).cause(), std::string(298, 'x') + "..");
  std::string umlauts;
  while (umlauts.size() < 400) umlauts += "\xc3\xa4";
  const std::string cut = ReadError("a", umlauts).cause();
  EXPECT_EQ(cut, umlauts.substr(0, cut.size() - 2) + "..");
  EXPECT_EQ(cut.size() % 2, 0u);
  EXPECT_LE(cut.size(), 300u);
}

TEST(FileErrors, NameTooLong) {
  const TemporaryFolder folder;
  EXPECT_EQ(causeOf(folder.path() / std::string(300, 'x')), "its name is too long");
}

TEST(FileErrors, UnknownFormatNamesTheKnownOnes) {
  EXPECT_EQ(refusalOf("points.xyz", "0 0 0\n"),
            "its format is not known; supported are " + extensionList(FormatReader::Own) +
                ", and tried " + extensionList(FormatReader::Library));
}

TEST(Formats, FollowFromTheContentWithoutAnExtension) {
  const char* const obj = "# made by hand\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(readBytes("mesh", obj)->faceCount(), 1u);
  EXPECT_EQ(readBytes("mesh.txt", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")->faceCount(), 1u);
  EXPECT_EQ(readBytes("MESH.ObJ", obj)->faceCount(), 1u);
}

/// Editors write a mark before UTF-8; it belongs to no format.
TEST(Formats, MarksOfUtf8AreNoContent) {
  const std::string mark = "\xef\xbb\xbf";
  const std::pair<const char*, const char*> files[] = {
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                "endloop\nendfacet\nendsolid\n"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}};
  for (const auto& [name, text] : files) {
    EXPECT_EQ(readBytes(name, mark + text)->faceCount(), 1u) << name;
    EXPECT_EQ(readBytes("no-extension", mark + text)->faceCount(), 1u) << name;
  }
}

TEST(Formats, ContentOfAnotherFormatIsNamed) {
  EXPECT_EQ(refusalOf("a.obj", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "its content is of the format .off although its name ends in .obj; rename it to end in "
            ".off");
}

TEST(Reading, CancelledGivesNoMesh) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Progress progress;
  progress.cancel();
  EXPECT_EQ(readMesh(file, &progress), nullptr);
}

TEST(Reading, ReportsAPhaseAndItsEnd) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Progress progress;
  EXPECT_EQ(readMesh(file, &progress)->file, file.string());
  EXPECT_STREQ(progress.phase(), "Reading");
  EXPECT_EQ(progress.fraction(), 1.0f);
}

}  // namespace
}  // namespace chartflood::test
