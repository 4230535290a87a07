// Sessions on the command line: saved, opened again, changed by options, broken.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SessionsInBatch : public testing::Test {
 protected:
  ProgramRun run(std::vector<std::string> words) {
    words.insert(words.begin(), CHARTFLOOD_PROGRAM);
    return runProgramIn(folder_.path(), words);
  }
  void done(const std::vector<std::string>& words) {
    const ProgramRun result = run(words);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
  }
  std::string file(const std::string& name) const { return readAll(folder_.path() / name); }
  json session(const std::string& name) const { return json::parse(file(name)); }
  void write(const std::string& name, const json& content) {
    writeAll(folder_.path() / name, content.dump());
  }
  /// A mesh file: a strip of squares, folded here and there.
  void writeMesh(std::size_t squares) {
    std::string text;
    for (std::size_t i = 0; i <= squares; ++i) {
      const std::string x = std::to_string(i), z = std::to_string(i % 3);
      text += "v " + x + " 0 " + z + "\nv " + x + " 1 " + z + "\n";
    }
    for (std::size_t i = 0; i < squares; ++i) {
      const auto v = [&](std::size_t k) { return std::to_string(2 * i + k); };
      text += "f " + v(1) + ' ' + v(3) + ' ' + v(4) + ' ' + v(2) + '\n';
    }
    writeAll(folder_.path() / "m.obj", text);
  }

  TemporaryFolder folder_;
};

TEST_F(SessionsInBatch, SavedAndOpenedGiveTheSameLabels) {
  const std::vector<std::vector<std::string>> ways = {{},
                                                      {"--charts=7", "--preset=paper"},
                                                      {"--iterations=3"},
                                                      {"--steps=900"},
                                                      {"--seeds=5,900,1800", "--refine=none"}};
  for (std::vector<std::string> words : ways) {
    words.insert(words.end(), {"--sample=bumps", "--triangles=2000", "--save-session=s.chartflood",
                               "--export-labels=a.txt"});
    done(words);
    done({"s.chartflood", "--export-labels=b.txt", "--save-session=t.chartflood"});
    EXPECT_EQ(file("b.txt"), file("a.txt")) << words[0];
    EXPECT_EQ(file("t.chartflood"), file("s.chartflood")) << "nothing is lost on the way";
  }
}

TEST_F(SessionsInBatch, OfAFileWithItsChecksum) {
  writeMesh(40);
  done({"m.obj", "--charts=5", "--save-session=s.chartflood", "--export-labels=a.txt"});
  EXPECT_EQ(session("s.chartflood")["model"]["relative"], "m.obj");
  const ProgramRun again = run({"s.chartflood", "--export-labels=b.txt"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_EQ(again.errors, "");
  EXPECT_EQ(file("b.txt"), file("a.txt"));
}

TEST_F(SessionsInBatch, OptionsBesideItWin) {
  done({"--sample=bumps", "--triangles=2000", "--charts=9", "--speed-power=2", "--seams=false",
        "--color-by=balance", "--save-session=s.chartflood"});
  done({"s.chartflood", "--charts=4", "--color-by=charts", "--save-session=t.chartflood",
        "--export-labels=t.txt"});
  const json later = session("t.chartflood");
  EXPECT_EQ(later["parameters"]["charts"], 4);
  EXPECT_EQ(later["parameters"]["speed-power"], 2.0);
  EXPECT_EQ(later["charts"]["seeds"].size(), 4u);
  EXPECT_EQ(later["view"]["seams"], false);
  EXPECT_EQ(later["view"]["color-by"], "charts");
  done({"--sample=bumps", "--triangles=2000", "--charts=4", "--speed-power=2",
        "--export-labels=plain.txt"});
  EXPECT_EQ(file("t.txt"), file("plain.txt")) << "as if it had been asked for at once";
}

TEST_F(SessionsInBatch, LockedSeedsHold) {
  done({"--sample=bumps", "--triangles=2000", "--seeds=5,900,1800,60", "--iterations=1",
        "--save-session=s.chartflood"});
  json content = session("s.chartflood");
  ASSERT_EQ(content["seeds"].size(), 4u);
  content["seeds"][1]["locked"] = true;
  content["seeds"][3]["locked"] = true;
  write("s.chartflood", content);
  done({"s.chartflood", "--iterations=6", "--save-session=t.chartflood"});
  EXPECT_EQ(session("t.chartflood")["charts"]["seeds"][1], 900);
  EXPECT_EQ(session("t.chartflood")["charts"]["seeds"][3], 60);
  EXPECT_NE(session("t.chartflood")["charts"]["seeds"][0], 5);
  const ProgramRun fewer = run({"s.chartflood", "--charts=1", "--save-session=u.chartflood"});
  EXPECT_THAT(fewer.errors, HasSubstr("2 seeds are locked, so K was raised to 2."));
  EXPECT_EQ(session("u.chartflood")["charts"]["seeds"], (json{900, 60}));
}

TEST_F(SessionsInBatch, AChangedMeshIsTakenWithOneWarning) {
  writeMesh(40);
  done({"m.obj", "--seeds=3,12,39", "--save-session=s.chartflood"});
  writeMesh(20);
  const ProgramRun again = run({"s.chartflood", "--export-labels=b.txt"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_THAT(again.errors, AllOf(HasSubstr("m.obj was changed since the session was saved"),
                                  HasSubstr("1 seed is no face of this model and was left out.")));
}

TEST_F(SessionsInBatch, FailuresAreOneSentenceAndWriteNothing) {
  writeMesh(40);
  done({"m.obj", "--save-session=s.chartflood"});
  const auto refusal = [&](const std::string& name) {
    const ProgramRun result = run({name, "--export-labels=b.txt"});
    EXPECT_EQ(result.exitCode, 1) << name;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "b.txt")) << name;
    return result.errors;
  };
  EXPECT_THAT(refusal("none.chartflood"), HasSubstr("none.chartflood: there is no such file"));
  json content = session("s.chartflood");
  content["chartflood-session"] = 9;
  write("newer.chartflood", content);
  EXPECT_THAT(refusal("newer.chartflood"), HasSubstr("newer chartflood"));
  writeAll(folder_.path() / "cut.chartflood", file("s.chartflood").substr(0, 300));
  EXPECT_THAT(refusal("cut.chartflood"), HasSubstr("not a whole session file"));
  std::filesystem::remove(folder_.path() / "m.obj");
  EXPECT_THAT(refusal("s.chartflood"), HasSubstr("its model is not there any more"));
  const ProgramRun wrong = run({"--sample=bumps", "--save-session=s.json"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.errors, HasSubstr(".chartflood"));
}

TEST_F(SessionsInBatch, TheViewGoesIntoThePicture) {
  done({"--sample=bumps", "--triangles=2000", "--camera-direction=1,0,0", "--color-by=balance",
        "--resolution=160,120", "--output=a.png", "--save-session=s.chartflood"});
  done({"s.chartflood", "--resolution=160,120", "--output=b.png"});
  EXPECT_EQ(file("b.png"), file("a.png"));
}

TEST_F(SessionsInBatch, NoFileClaimsMoreThanItMay) {
  const std::string cases = CHARTFLOOD_SOURCE_ROOT "/tests/cases/";
  writeMesh(6);
  const auto refused = [&](const std::vector<std::string>& words) {
    const ProgramRun result = run(words);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    return result.errors;
  };
  EXPECT_THAT(refused({"--report=r.json", cases + "session-two-billion-triangles.chartflood"}),
              HasSubstr("give a number from 1 to 50000000"));
  for (const char* bomb : {"bomb-huge.png", "bomb-size.png"}) {
    EXPECT_THAT(refused({"--output=o.png", cases + bomb}), HasSubstr("16384 x 16384 are the most"));
    EXPECT_THAT(refused({"--output=o.png", "--like=" + cases + bomb, "m.obj"}),
                HasSubstr("16384 x 16384 are the most"));
  }
}

TEST_F(SessionsInBatch, APlusBeforeANumberIsReadEverywhere) {
  done({"--sample=bumps", "--triangles=+2000", "--charts=+5", "--rng-seed=+5", "--seeds=+5,900",
        "--sharp-angle=+40", "--save-session=s.chartflood", "--steps=+900"});
  EXPECT_EQ(session("s.chartflood")["parameters"]["rng-seed"], 5);
  for (const char* word : {"--charts=+-5", "--charts=++5", "--charts=+", "--steps=+-5"}) {
    EXPECT_EQ(run({"--sample=bumps", word, "--report=r.json"}).exitCode, 2) << word;
  }
}

}  // namespace
}  // namespace chartflood
