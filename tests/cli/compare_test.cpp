// --compare: several methods beside each other.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "render/scene/image.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

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
    const ProgramRun one = runIn(folder, words);
    ASSERT_EQ(one.exitCode, 0) << one.errors;
    json alone = json::parse(one.output)["results"][0], beside = report["results"][i];
    const json& alike = report["comparison"][2 * i];
    const json& left = report["comparison"][2 * i + 1];
    EXPECT_EQ(left["method"], methods[i]);
    EXPECT_EQ(left["borders"], "as-left");
    EXPECT_EQ(alike["borders"], "alike");
    EXPECT_EQ(alike["gauss_std_eq3"], alone["gauss_area"]["std_eq3"]);
    if (methods[i] != "t-flooding") words.push_back("--refine=none");
    const ProgramRun grown = runIn(folder, words);
    ASSERT_EQ(grown.exitCode, 0) << grown.errors;
    EXPECT_EQ(left["gauss_std_eq3"],
              json::parse(grown.output)["results"][0]["gauss_area"]["std_eq3"]);
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

TEST(Compare, PrintsOneTableWhereBordersStayAsGrown) {
  const TemporaryFolder folder;
  const std::vector<std::string> words{"--charts=4", "--layout=square", "--compare=vsa,mcgim",
                                       "--refine=none"};
  const ProgramRun run = runIn(folder, words);
  ASSERT_EQ(run.exitCode, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("Charts as each method leaves them"));
  EXPECT_THAT(run.output, Not(HasSubstr("The same borders for all methods")));
  std::vector<std::string> reported = words;
  reported.push_back("--report=-");
  const json report = json::parse(runIn(folder, reported).output);
  EXPECT_EQ(report["comparison"].size(), 2u);
  EXPECT_EQ(report["results"].size(), 2u);
}

TEST(Compare, DrawsARowForEachMode) {
  const TemporaryFolder folder;
  const std::vector<std::string> same{"--charts=4", "--compare=vsa,mcgim", "--scalar-bar=off"};
  const auto drawn = [&](const char* modes, const char* file, const char* size) {
    std::vector<std::string> words = same;
    words.insert(words.end(), {std::string("--color-by=") + modes, std::string("--output=") + file,
                               std::string("--resolution=") + size});
    const ProgramRun run = runIn(folder, words);
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    return readPng(folder.path() / file);
  };
  const Image both = drawn("charts,checkerboard", "both.png", "400,560");
  // Captions are as high as before, so that the first row is the picture of one mode alone.
  const Image charts = drawn("charts", "charts.png", "400,306");
  const Image squares = drawn("checkerboard", "squares.png", "400,306");
  const int strip = 560 - 2 * (560 - 306);
  const int row = 306 - strip;
  std::size_t different = 0;
  for (int y = 0; y < row; ++y) {
    for (int x = 0; x < 400; ++x) {
      different += both.at(x, y) == charts.at(x, y) ? 0 : 1;
      different += both.at(x, row + y) == squares.at(x, y) ? 0 : 1;
    }
  }
  EXPECT_EQ(different, 0u);
  EXPECT_NE(charts, squares);
}

TEST(Compare, RefusesInOneSentence) {
  const TemporaryFolder folder;
  const ProgramRun unknown = runIn(folder, {"--compare=vsa,mcgin"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("mcgim"));
  const ProgramRun both = runIn(folder, {"--compare=vsa", "--export-mesh=a.obj"});
  EXPECT_EQ(both.exitCode, 2);
  EXPECT_THAT(both.errors, HasSubstr("--compare and --export-mesh exclude each other"));
  const ProgramRun film = runIn(folder, {"--compare=vsa", "--output=a.png", "--turntable=4"});
  EXPECT_EQ(film.exitCode, 2);
  EXPECT_THAT(film.errors, HasSubstr("--compare and --turntable exclude each other"));
  const ProgramRun mode = runIn(folder, {"--compare=vsa", "--color-by=charts,checkers"});
  EXPECT_EQ(mode.exitCode, 2);
  EXPECT_THAT(mode.errors, HasSubstr("checkerboard"));
  const ProgramRun narrow =
      runIn(folder, {"--compare=vsa,mcgim", "--output=a.png", "--resolution=100,100"});
  EXPECT_EQ(narrow.exitCode, 2);
  EXPECT_THAT(narrow.errors, HasSubstr("--resolution is too small"));
}

}  // namespace
}  // namespace chartflood
