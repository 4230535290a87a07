// --compare: several methods beside each other.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "render/image.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;
using testing::HasSubstr;

ProgramRun runIn(const TemporaryFolder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {CHARTFLOOD_PROGRAM, "--sample=bumps", "--triangles=1500"});
  return runProgramIn(folder.path(), words);
}

TEST(Compare, EveryMethodIsWhatItIsAlone) {
  const TemporaryFolder folder;
  const ProgramRun all =
      runIn(folder, {"--charts=6", "--layout=square", "--compare=vsa,t-flooding,mcgim",
                     "--report=-", "--output=all.png", "--resolution=600,400"});
  ASSERT_EQ(all.exitCode, 0) << all.errors;
  const json report = json::parse(all.output);
  ASSERT_EQ(report["results"].size(), 3u);
  ASSERT_EQ(report["comparison"].size(), 6u);
  const std::vector<std::string> methods{"vsa", "t-flooding", "mcgim"};
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<std::string> words{"--charts=6", "--method=" + methods[i], "--report=-",
                                   "--layout=square"};
    if (methods[i] != "t-flooding") words.push_back("--refine=none");
    const ProgramRun one = runIn(folder, words);
    ASSERT_EQ(one.exitCode, 0) << one.errors;
    json alone = json::parse(one.output)["results"][0], beside = report["results"][i];
    const json& left = report["comparison"][2 * i];
    const json& alike = report["comparison"][2 * i + 1];
    EXPECT_EQ(left["method"], methods[i]);
    EXPECT_EQ(left["borders"], "as-left");
    EXPECT_EQ(alike["borders"], "alike");
    EXPECT_EQ(left["gauss_std_eq3"], alone["gauss_area"]["std_eq3"]);
    EXPECT_LE(alike["seam_length_over_sqrt_area"], left["seam_length_over_sqrt_area"]);
    for (json* result : {&alone, &beside}) result->erase("timing_ms");
    EXPECT_EQ(beside, alone);
  }
  const Image picture = readPng(folder.path() / "all.png");
  EXPECT_EQ(picture.width(), 600);
  EXPECT_EQ(picture.height(), 400);
}

TEST(Compare, PrintsATable) {
  const TemporaryFolder folder;
  const ProgramRun run =
      runIn(folder, {"--charts=4", "--layout=square", "--compare=vsa,mcgim", "--refine=moves"});
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("Charts as each method leaves them"));
  EXPECT_THAT(run.output, HasSubstr("The same borders for all methods"));
}

TEST(Compare, RefusesInOneSentence) {
  const TemporaryFolder folder;
  const ProgramRun unknown = runIn(folder, {"--compare=vsa,mcgin"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("mcgim"));
  const ProgramRun both = runIn(folder, {"--compare=vsa", "--export-mesh=a.obj"});
  EXPECT_EQ(both.exitCode, 2);
  EXPECT_THAT(both.errors, HasSubstr("--compare and --export-mesh exclude each other"));
  const ProgramRun narrow =
      runIn(folder, {"--compare=vsa,mcgim", "--output=a.png", "--resolution=100,100"});
  EXPECT_EQ(narrow.exitCode, 2);
  EXPECT_THAT(narrow.errors, HasSubstr("--resolution is too small"));
}

}  // namespace
}  // namespace chartflood
