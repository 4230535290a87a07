#include "core/io/write/file_output.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/io/write/write_labels.h"
#include "core/model/build_mesh.h"
#include "io_support.h"

namespace chartflood::test {
namespace {

std::string refusal(const std::filesystem::path& file) {
  try {
    writeFileAtomically(file, "new");
  } catch (const WriteError& e) {
    return e.what();
  }
  return "";
}

std::size_t filesIn(const TemporaryFolder& folder) {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++count;
  }
  return count;
}

TEST(WriteFileAtomically, CreatesAndReplaces) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  writeFileAtomically(file, "one");
  EXPECT_EQ(readWholeFile(file), "one");
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  writeFileAtomically(file, "two");
  EXPECT_EQ(readWholeFile(file), "two");
  EXPECT_EQ(filesIn(folder), 1u);
  struct stat status = {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(WriteFileAtomically, WritesBelowThePresentFolder) {
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  writeFileAtomically("plain.txt", "here");
  std::filesystem::current_path(before);
  EXPECT_EQ(readWholeFile(folder.path() / "plain.txt"), "here");
}

TEST(WriteFileAtomically, KeepsLinks) {
  const TemporaryFolder folder;
  const auto file = folder.write("real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder.path() / "link.txt");
  writeFileAtomically(folder.path() / "link.txt", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.txt"));
  EXPECT_EQ(readWholeFile(file), "new");
}

TEST(WriteFileAtomically, RefusesWhatCannotBeReplaced) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  EXPECT_NE(refusal(folder.path() / "sub").find("it is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder.path() / "none" / "a.txt").find("its folder does not exist"),
            std::string::npos);
  EXPECT_NE(refusal("/dev/null").find("it is no regular file"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_EQ(filesIn(folder), 1u);
}

TEST(WriteFileAtomically, RefusesProtectedFiles) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0400), 0);
  EXPECT_NE(refusal(file).find("it is write-protected"), std::string::npos);
  EXPECT_EQ(readWholeFile(file), "old");
}

TEST(StagedFile, LeavesTheOldFileUntilCommitted) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", "old");
  {
    const StagedFile abandoned(file, "new");
    EXPECT_EQ(readWholeFile(file), "old");
  }
  EXPECT_EQ(readWholeFile(file), "old");
  EXPECT_EQ(filesIn(folder), 1u);
  std::vector<StagedFile> staged;
  staged.emplace_back(file, "first");
  staged.emplace_back(folder.path() / "b.txt", "second");
  for (StagedFile& s : staged) s.commit();
  EXPECT_EQ(readWholeFile(file), "first");
  EXPECT_EQ(readWholeFile(folder.path() / "b.txt"), "second");
}

TEST(FileOutput, ALinkToAFileThatIsNotThereStaysALink) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  std::filesystem::create_symlink("sub/second", folder / "first");
  std::filesystem::create_symlink("real.txt", folder / "sub/second");
  writeFileAtomically(folder / "first", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "first"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "sub/second"));
  EXPECT_EQ(readWholeFile(folder / "sub/real.txt"), "new");
  std::filesystem::create_symlink("no-such-folder/a.txt", folder / "lost");
  EXPECT_THROW(writeFileAtomically(folder / "lost", "new"), WriteError);
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "lost"));
  std::filesystem::create_symlink("circle", folder / "circle");
  EXPECT_THROW(writeFileAtomically(folder / "circle", "new"), WriteError);
}

TEST(WriteLabels, GivesOneLineAnInputFaceInItsOrder) {
  const auto mesh = buildBytes("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                        "f 1 2\nf 1 2 3 4\nf 2 5 6\nf 2 2 3\nf 2 6 3\n");
  ASSERT_EQ(mesh->faceCount(), 3u);
  const std::vector<Index> label = {4, kNone, 12};
  EXPECT_EQ(labelsText(*mesh, label), "-1\n4\n-1\n-1\n12\n");
  const TemporaryFolder folder;
  writeLabels(folder.path() / "labels.txt", *mesh, label);
  EXPECT_EQ(readWholeFile(folder.path() / "labels.txt"), labelsText(*mesh, label));
}

}  // namespace
}  // namespace chartflood::test
