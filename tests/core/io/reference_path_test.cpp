// What a file may name: only regular files of its folder or below, links included.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/io/read/reference_path.h"
#include "io_support.h"

namespace chartflood::test {
namespace {

constexpr const char* kOutside =
    "lies outside of the file's folder; put it beside the file or below";

class ReferencePath : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder() / "parts");
    all_.write("secret.bin", "s");
    all_.write("models/a.bin", "a");
    all_.write("models/parts/b.bin", "b");
  }
  std::filesystem::path folder() const { return all_.path() / "models"; }
  std::string refusal(const std::string& name) const {
    return findReference(folder(), name).refusal;
  }
  TemporaryFolder all_;
};

TEST_F(ReferencePath, TakesWhatLiesInTheFolderOrBelow) {
  const auto real = std::filesystem::canonical(folder());
  EXPECT_EQ(findReference(folder(), "a.bin").file, real / "a.bin");
  EXPECT_EQ(findReference(folder(), "./parts/../parts/b.bin").file, real / "parts/b.bin");
  EXPECT_EQ(findReference(folder(), (folder() / "a.bin").string()).file, real / "a.bin");
  std::filesystem::create_symlink("parts/b.bin", folder() / "inside");
  EXPECT_EQ(findReference(folder(), "inside").file, real / "parts/b.bin");
}

TEST_F(ReferencePath, RefusesWhatLiesOutsideWhetherItIsThereOrNot) {
  EXPECT_EQ(refusal("../secret.bin"), kOutside);
  EXPECT_EQ(refusal("../nothing.bin"), kOutside);
  EXPECT_EQ(refusal("parts/../../secret.bin"), kOutside);
  EXPECT_EQ(refusal("/etc/passwd"), kOutside);
  EXPECT_EQ(refusal("/dev/zero"), kOutside);
  EXPECT_EQ(refusal(".."), kOutside);
  // A neighbour whose name only begins like the folder's.
  all_.write("models-2/c.bin", "c");
  EXPECT_EQ(refusal("../models-2/c.bin"), kOutside);
}

TEST_F(ReferencePath, FollowsLinksBeforeItJudges) {
  std::filesystem::create_symlink("../secret.bin", folder() / "harmless.bin");
  EXPECT_EQ(refusal("harmless.bin"), kOutside);
  std::filesystem::create_directory_symlink("..", folder() / "up");
  EXPECT_EQ(refusal("up/secret.bin"), kOutside);
  std::filesystem::create_symlink("circle", folder() / "circle");
  EXPECT_NE(refusal("circle"), "");
}

TEST_F(ReferencePath, RefusesWhatIsNoFile) {
  EXPECT_EQ(refusal("parts"), "is a folder");
  EXPECT_EQ(refusal("c.bin"), "is not in the file's folder");
  EXPECT_EQ(refusal(""), "is not there");
  EXPECT_EQ(refusal(std::string("a.bin\0.png", 10)), "is not there");
  ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal("pipe"), "is a pipe; only files can be read");
}

}  // namespace
}  // namespace chartflood::test
