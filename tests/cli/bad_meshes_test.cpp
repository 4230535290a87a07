// Over a folder of broken and unusual files: the program answers each with charts or with one
// sentence, and never crashes, hangs or leaves half a result.

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::filesystem::path> badFiles() {
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(CHARTFLOOD_BAD_MESHES, missing)) {
    if (entry.path().filename() != "README.md") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(BadMeshes, EachEndsWithChartsOrOneSentence) {
  const auto files = badFiles();
  if (files.empty()) GTEST_SKIP() << "the folder of broken meshes is absent";
  std::size_t number = 0;
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    // Searching for the closest places takes most of the time; every fourth file is enough for it.
    const char* layout = number++ % 4 == 0 ? "--layout=packed" : "--layout=square";
    const TemporaryFolder folder;
    const ProgramRun run =
        runProgramIn(folder.path(), {"/usr/bin/timeout", "60", CHARTFLOOD_PROGRAM, "--charts=20",
                                     "--export-labels=labels.txt", "--report=report.json",
                                     "--max-iterations=4", layout, "--", file.string()});
    ASSERT_TRUE(run.exitCode == 0 || run.exitCode == 1) << run.exitCode << ": " << run.errors;
    const bool wrote = std::filesystem::exists(folder.path() / "labels.txt");
    EXPECT_EQ(wrote, run.exitCode == 0);
    EXPECT_EQ(std::filesystem::exists(folder.path() / "report.json"), wrote);
    if (!wrote) {
      EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
      EXPECT_THAT(run.errors, HasSubstr(file.filename().string()));
      continue;
    }
    std::istringstream labels(readAll(folder.path() / "labels.txt"));
    for (long label = 0; labels >> label;) ASSERT_GE(label, -1);
    const std::string report = readAll(folder.path() / "report.json");
    EXPECT_THAT(report, Not(HasSubstr(": nan")));
    EXPECT_THAT(report, Not(HasSubstr(": inf")));
  }
}

}  // namespace
}  // namespace chartflood
