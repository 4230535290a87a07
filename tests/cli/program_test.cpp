// The program itself: exit codes, messages, files it writes and files it leaves alone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "render/scene/image.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// A unit cube of six quads.
const char* const kCube = R"(v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";

class Program : public testing::Test {
 protected:
  ProgramRun run(std::vector<std::string> words, int interruptAfter = -1) {
    words.insert(words.begin(), CHARTFLOOD_PROGRAM);
    return runProgramIn(folder_.path(), words, interruptAfter);
  }
  std::string file(const std::string& name) const { return readAll(folder_.path() / name); }
  std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  static std::vector<long> numbers(const std::string& text) {
    std::istringstream stream(text);
    std::vector<long> values;
    for (long value; stream >> value;) values.push_back(value);
    return values;
  }
  /// The report without what differs from run to run.
  static json steady(const std::string& text) {
    json report = json::parse(text);
    report.erase("peak_memory_bytes");
    for (json& result : report["results"]) result.erase("timing_ms");
    return report;
  }

  TemporaryFolder folder_;
};

/// The importing program is found beside this one and where installations keep it.
TEST_F(Program, SaysWhenTheImportingProgramIsMissing) {
  namespace fs = std::filesystem;
  const fs::path program = fs::path(CHARTFLOOD_PROGRAM), root = folder_.path();
  fs::create_directories(root / "bin");
  fs::create_directories(root / "libexec" / "chartflood");
  fs::copy_file(program, root / "bin" / "chartflood");
  folder_.write("a.ac",
                "AC3Db\nMATERIAL \"\" rgb 1 1 1  amb 1 1 1  emis 0 0 0  spec 0 0 0  shi 9  "
                "trans 0\nOBJECT world\nkids 1\nOBJECT poly\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\n"
                "numsurf 1\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 1 0\n2 1 1\nkids 0\n");
  const std::vector<std::string> words{(root / "bin" / "chartflood").string(), "a.ac", "--info"};
  const ProgramRun missing = runProgramIn(root, words);
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_EQ(missing.errors, "chartflood: Could not read a.ac: the program chartflood-import, which "
                            "reads .ac, is not beside this one; install chartflood anew.\n");
  fs::copy_file(program.parent_path() / "chartflood-import",
                root / "libexec" / "chartflood" / "chartflood-import");
  const ProgramRun installed = runProgramIn(root, words);
  EXPECT_EQ(installed.exitCode, 0) << installed.errors;
  EXPECT_THAT(installed.output, HasSubstr("faces           1"));
}

TEST_F(Program, SaysItsVersionAndHelp) {
  const ProgramRun version = run({"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_EQ(version.output, "chartflood " CHARTFLOOD_VERSION "\n");
  EXPECT_EQ(version.errors, "");
  const ProgramRun help = run({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.output, StartsWith("Usage: chartflood [options] [mesh or session]"));
  EXPECT_EQ(help.errors, "");
}

TEST_F(Program, ListsWhatOptionsTake) {
  EXPECT_THAT(run({"--list-samples"}).output, HasSubstr("rocket"));
  EXPECT_THAT(run({"--list-colormaps"}).output, HasSubstr("viridis"));
  EXPECT_THAT(run({"--list-bindings"}).output, HasSubstr("Space"));
}

TEST_F(Program, EveryListedSampleCanBeOpened) {
  std::istringstream lines(run({"--list-samples"}).output);
  std::size_t samples = 0;
  for (std::string line; std::getline(lines, line); ++samples) {
    const std::string name = line.substr(0, line.find(' '));
    const ProgramRun info = run({"--sample=" + name, "--triangles=2000", "--info"});
    EXPECT_EQ(info.exitCode, 0) << name << ": " << info.errors;
    EXPECT_THAT(info.output, HasSubstr("components      1\n")) << name;
  }
  EXPECT_GE(samples, 8u);
}

TEST_F(Program, WrongUsageLeavesWithTwoAndOneSentence) {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--chart=3"},
           {"--charts=0"},
           {"--charts=auto", "--steps=4", "--report=-"},
           {"--export-mesh=a.fbx"},
           {"a.obj", "b.obj"},
           {"--sample=rokcet", "--report=-"},
           {"--sample=cube", "--seeds=99999999", "--report=-"},
           {"--sample=cube", "--seeds=1,2,3", "--charts=2", "--report=-"}}) {
    const ProgramRun wrong = run(words);
    EXPECT_EQ(wrong.exitCode, 2) << testing::PrintToString(words);
    EXPECT_EQ(wrong.output, "");
    EXPECT_THAT(wrong.errors, StartsWith("chartflood: "));
    EXPECT_EQ(std::count(wrong.errors.begin(), wrong.errors.end(), '\n'), 1) << wrong.errors;
  }
  EXPECT_THAT(run({"--sample=rokcet", "--report=-"}).errors, HasSubstr("did you mean rocket?"));
  EXPECT_TRUE(listing().empty());
}

TEST_F(Program, WithoutADisplayTheWindowIsRefusedWithASentence) {
  const ProgramRun window = run({"--sample=cube"});
  EXPECT_EQ(window.exitCode, 1);
  EXPECT_THAT(window.errors, HasSubstr("--output"));
  EXPECT_EQ(std::count(window.errors.begin(), window.errors.end(), '\n'), 1) << window.errors;
}

TEST_F(Program, FilesThatCannotBeReadLeaveWithOneAndNoOutput) {
  writeAll(folder_.path() / "broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  writeAll(folder_.path() / "empty.ply", "");
  writeAll(folder_.path() / "old.txt", "as it was");
  const std::vector<std::string> before = listing();
  for (const char* name : {"broken.obj", "empty.ply", "missing.obj", "."}) {
    const ProgramRun failed =
        run({name, "--export-labels=old.txt", "--report=new.json", "--output=new.png"});
    EXPECT_EQ(failed.exitCode, 1) << name;
    EXPECT_THAT(failed.errors, StartsWith("chartflood: Could not read ")) << name;
    EXPECT_THAT(failed.errors, HasSubstr(name));
    EXPECT_EQ(std::count(failed.errors.begin(), failed.errors.end(), '\n'), 1) << failed.errors;
    EXPECT_EQ(failed.output, "");
    EXPECT_EQ(listing(), before) << name;
    EXPECT_EQ(file("old.txt"), "as it was");
  }
}

TEST_F(Program, OutputsThatCannotBeWrittenLeaveAllOthersAlone) {
  writeAll(folder_.path() / "labels.txt", "as it was");
  const ProgramRun failed =
      run({"--sample=cube", "--export-labels=labels.txt", "--report=no/such/folder/report.json"});
  EXPECT_EQ(failed.exitCode, 1);
  EXPECT_THAT(failed.errors, StartsWith("chartflood: Could not write no/such/folder/report.json"));
  EXPECT_EQ(file("labels.txt"), "as it was");
  EXPECT_EQ(listing(), std::vector<std::string>{"labels.txt"});
}

TEST_F(Program, LabelsGiveOneChartToEachFaceOfTheFile) {
  writeAll(folder_.path() / "-cube.obj", kCube);
  const ProgramRun done = run({"--charts=3", "--export-labels=labels.txt", "--", "-cube.obj"});
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_EQ(done.output, "");
  const std::vector<long> labels = numbers(file("labels.txt"));
  EXPECT_EQ(labels.size(), 6u) << "a quad is one face";
  EXPECT_EQ(std::set<long>(labels.begin(), labels.end()), (std::set<long>{0, 1, 2}));
}

TEST_F(Program, MoreChartsThanFacesBecomeOneAFaceWithAWarning) {
  writeAll(folder_.path() / "cube.obj", kCube);
  const ProgramRun done = run({"cube.obj", "--charts=9", "--export-labels=labels.txt"});
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const std::vector<long> labels = numbers(file("labels.txt"));
  EXPECT_EQ(std::set<long>(labels.begin(), labels.end()).size(), 6u);
  EXPECT_EQ(done.errors, "Only 6 faces: K was set to 6.\n");
  const ProgramRun quiet =
      run({"cube.obj", "--charts=9", "--export-labels=labels.txt", "--verbose=quiet"});
  EXPECT_EQ(quiet.errors, "");
}

TEST_F(Program, EqualCallsGiveEqualBytesForAnyNumberOfThreads) {
  const auto call = [&](const std::string& name, const std::string& threads) {
    const ProgramRun done =
        run({"--sample=rocket", "--triangles=6000", "--charts=9", "--threads=" + threads,
             "--resolution=320,240", "--output=" + name + ".png",
             "--export-labels=" + name + ".txt", "--report=" + name + ".json"});
    EXPECT_EQ(done.exitCode, 0) << done.errors;
  };
  call("a", "1");
  call("b", "1");
  call("c", "2");
  call("d", "7");
  ASSERT_GT(file("a.png").size(), 1000u);
  for (const char* other : {"b", "c", "d"}) {
    EXPECT_TRUE(file("a.png") == file(std::string(other) + ".png")) << other;
    EXPECT_TRUE(file("a.txt") == file(std::string(other) + ".txt")) << other;
    EXPECT_EQ(steady(file("a.json")), steady(file(std::string(other) + ".json"))) << other;
  }
}

TEST_F(Program, TheGeneratorSeedMatters) {
  const auto labels = [&](const std::string& seed) {
    EXPECT_EQ(run({"--sample=bumps", "--rng-seed=" + seed, "--export-labels=labels.txt"}).exitCode,
              0);
    return file("labels.txt");
  };
  EXPECT_TRUE(labels("1") != labels("2"));
}

TEST_F(Program, PlacedSeedsBeginTheCharts) {
  const ProgramRun done = run(
      {"--sample=sphere", "--triangles=1200", "--seeds=5,600,900", "--iterations=1", "--report=-"});
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const json report = json::parse(done.output);
  EXPECT_EQ(report["parameters"]["charts"], 3);
  EXPECT_EQ(report["parameters"]["seeds"], (std::vector<int>{5, 600, 900}));
  std::vector<int> seeds;
  for (const json& chart : report["results"][0]["per_chart"]) seeds.push_back(chart["seed_face"]);
  EXPECT_EQ(seeds, (std::vector<int>{5, 600, 900}));
}

TEST_F(Program, StepsStopTheFloodEarly) {
  const ProgramRun done =
      run({"--sample=sphere", "--triangles=1200", "--steps=100", "--export-labels=labels.txt"});
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const std::vector<long> labels = numbers(file("labels.txt"));
  EXPECT_EQ(std::count_if(labels.begin(), labels.end(), [](long label) { return label >= 0; }),
            100);
}

TEST_F(Program, IterationsStopAfterSoManyRounds) {
  const ProgramRun done = run({"--sample=bumps", "--iterations=3", "--report=-"});
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const json result = json::parse(done.output)["results"][0];
  EXPECT_EQ(result["iterations"], 3);
  EXPECT_EQ(result["history"].size(), 3u);
}

TEST_F(Program, ParametersChangeTheResult) {
  const auto labels = [&](const std::string& option, const std::string& other = "--charts=20") {
    const ProgramRun done =
        run({"--sample=knot", "--triangles=8000", other, option, "--export-labels=labels.txt"});
    EXPECT_EQ(done.exitCode, 0) << done.errors;
    return file("labels.txt");
  };
  const std::string usual = labels("--rng-seed=1");
  EXPECT_TRUE(labels("--clean-up=10", "--refine=moves") != labels("--refine=moves"));
  EXPECT_TRUE(labels("--rng-seed=1", "--charts=8") != usual);
  for (const char* option :
       {"--sharp-angle=10", "--speed-power=4", "--speed-epsilon=1e-5", "--offsets=off",
        "--offset-damping=0.9", "--lookahead=off", "--area-share=0.05", "--max-iterations=2",
        "--patience=1", "--settle=0", "--refine=none", "--balance-weight=10",
        "--seeding=one-by-one", "--preset=paper"}) {
    EXPECT_TRUE(labels(option) != usual) << option << " changes nothing";
  }
  const std::string vsa = labels("--method=vsa");
  EXPECT_TRUE(labels("--even=error", "--method=vsa") != vsa);
  EXPECT_TRUE(labels("--even=area", "--method=vsa") != labels("--even=error", "--method=vsa"));
  EXPECT_TRUE(labels("--even=off", "--method=vsa") == vsa);
  for (const char* option : {"--search=literal", "--start=flood", "--method=t-flooding"}) {
    EXPECT_TRUE(labels(option) == usual) << option << " changes something";
  }
}

TEST_F(Program, SaysWhereEvenOutSaysNothing) {
  const std::string sentence = "T-flooding evens out Gauss area";
  for (const char* even : {"area", "off", "error", "auto"}) {
    const ProgramRun done = run({"--sample=bumps", "--triangles=500", "--even=" + std::string(even),
                                 "--export-labels=labels.txt"});
    ASSERT_EQ(done.exitCode, 0) << done.errors;
    const bool own = even == std::string("error") || even == std::string("auto");
    EXPECT_EQ(done.errors.find(sentence) == std::string::npos, own) << even;
  }
}

TEST_F(Program, PicturesHaveTheSizeAndGroundAskedFor) {
  const ProgramRun done = run({"--sample=sphere", "--output=a.png", "--resolution=200,100",
                               "--background=transparent", "--supersampling=1"});
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  const Image image = readPng(folder_.path() / "a.png");
  EXPECT_EQ(image.width(), 200);
  EXPECT_EQ(image.height(), 100);
  EXPECT_EQ(image.at(0, 0)[3], 0) << "the ground";
  EXPECT_EQ(image.at(100, 50)[3], 255) << "the sphere";
}

TEST_F(Program, TurntableAndFloodFilmWriteNumberedPictures) {
  const std::vector<std::string> how{"--sample=rocket", "--triangles=300", "--resolution=64,48",
                                     "--supersampling=1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), how.begin(), how.end());
    return run(more);
  };
  ASSERT_EQ(with({"--output=turn.png", "--turntable=3"}).exitCode, 0);
  EXPECT_THAT(listing(), testing::ElementsAre("turn_001.png", "turn_002.png", "turn_003.png"));
  EXPECT_NE(readPng(folder_.path() / "turn_001.png"), readPng(folder_.path() / "turn_002.png"));
  ASSERT_EQ(with({"--output=flood.png", "--flood-film=4"}).exitCode, 0);
  ASSERT_EQ(with({"--output=last.png"}).exitCode, 0);
  EXPECT_EQ(file("flood_004.png"), file("last.png")) << "the finished charts";
  EXPECT_NE(file("flood_003.png"), file("last.png"));
  EXPECT_EQ(with({"--turntable=3"}).exitCode, 2) << "nowhere to write to";
  EXPECT_EQ(with({"--output=a.png", "--turntable=3", "--flood-film=3"}).exitCode, 2);
}

TEST_F(Program, PictureOptionsChangeThePicture) {
  // Few triangles: edges that are too dense are not drawn.
  const auto picture = [&](const std::string& option) {
    const ProgramRun done = run({"--sample=rocket", "--triangles=2500", "--charts=6",
                                 "--iterations=1", "--layout=square", "--supersampling=1",
                                 "--resolution=300,400", "--output=a.png", option});
    EXPECT_EQ(done.exitCode, 0) << option << ": " << done.errors;
    return file("a.png");
  };
  const std::string usual = picture("--color-by=charts");
  std::set<std::string> seen{usual};
  for (const char* option : {"--color-by=shaded",
                             "--color-by=gauss-vertex",
                             "--color-by=gauss-edge",
                             "--color-by=gauss-face",
                             "--color-by=gauss",
                             "--color-by=balance",
                             "--color-by=flood-time",
                             "--color-by=flood-order",
                             "--background=white",
                             "--seams=off",
                             "--edges",
                             "--seed-marks=off",
                             "--numbers",
                             "--camera-direction=0,-1,0",
                             "--camera-orthographic",
                             "--camera-azimuth-angle=40",
                             "--camera-elevation-angle=20",
                             "--camera-zoom-factor=1.5",
                             "--camera-view-angle=60",
                             "--camera-position=9,9,9",
                             "--camera-view-up=1,0,0",
                             "--up=+Z"}) {
    EXPECT_TRUE(seen.insert(picture(option)).second) << option << " changes nothing";
  }
}

TEST_F(Program, ColorMapRangeAndBarChangeAPictureOfValues) {
  const auto picture = [&](const std::string& option) {
    const ProgramRun done =
        run({"--sample=bumps", "--iterations=1", "--layout=square", "--supersampling=1",
             "--resolution=240,200", "--output=a.png", "--color-by=gauss-face", option});
    EXPECT_EQ(done.exitCode, 0) << option << ": " << done.errors;
    return file("a.png");
  };
  const std::string usual = picture("--seams");
  for (const char* option : {"--colormap=viridis", "--range=0,1", "--scalar-bar=off"}) {
    EXPECT_TRUE(picture(option) != usual) << option << " changes nothing";
  }
}

TEST_F(Program, InfoSaysWhatTheFileHolds) {
  writeAll(folder_.path() / "cube.obj", std::string(kCube) + "f 1 1 2\n");
  const ProgramRun info = run({"cube.obj", "--info"});
  ASSERT_EQ(info.exitCode, 0) << info.errors;
  EXPECT_THAT(info.output, StartsWith("cube.obj\n"));
  for (const char* line :
       {"  faces           7\n", "  triangles       12\n", "  vertices        8\n",
        "  components      1\n", "  boundary loops  0\n", "  genus           0\n",
        "  size            1 x 1 x 1, diagonal 1.73205\n", "  Gauss area      12.566371 sr",
        "    vertices      12.566371 sr on 8 corners\n",
        "    signed total  12.566371 sr, 1.000000 times 4 pi\n", "  repairs\n"}) {
    EXPECT_THAT(info.output, HasSubstr(line));
  }
}

TEST_F(Program, InterruptedItLeavesNothingBehind) {
  // Long enough to be interrupted on any machine: a big mesh and rounds without end.
  const ProgramRun stopped =
      run({"--sample=rocket", "--triangles=3000000", "--max-iterations=10000", "--patience=1000",
           "--export-labels=labels.txt", "--output=a.png"},
          1500);
  EXPECT_EQ(stopped.exitCode, 130);
  EXPECT_THAT(stopped.errors, HasSubstr("Interrupted"));
  EXPECT_TRUE(listing().empty()) << testing::PrintToString(listing());
}

TEST_F(Program, InterruptedWhileAPictureIsDrawnItLeavesNothingBehind) {
  // Minutes of drawing: it would not be through by then.
  const ProgramRun stopped =
      run({"--sample=cube", "--charts=6", "--resolution=16384,16384", "--supersampling=4",
           "--output=a.png", "--export-labels=labels.txt"},
          3000);
  EXPECT_EQ(stopped.exitCode, 130);
  EXPECT_THAT(stopped.errors, HasSubstr("Interrupted"));
  EXPECT_TRUE(listing().empty()) << testing::PrintToString(listing());
}

TEST_F(Program, ResultsNeverReplaceWhatTheyAreMadeFrom) {
  const auto made = run({"--sample=cube", "--export-mesh=model.obj"});
  ASSERT_EQ(made.exitCode, 0) << made.errors;
  const std::string before = readAll(folder_.path() / "model.obj");
  std::filesystem::create_symlink("model.obj", folder_.path() / "link.obj");
  for (const char* target : {"model.obj", "./model.obj", "link.obj"}) {
    for (const char* option : {"--export-mesh=", "--export-seams="}) {
      const ProgramRun refused = run({"model.obj", "--charts=3", std::string(option) + target});
      EXPECT_EQ(refused.exitCode, 2) << option << target;
      EXPECT_THAT(refused.errors, HasSubstr("--overwrite"));
      EXPECT_EQ(readAll(folder_.path() / "model.obj"), before);
    }
  }
  EXPECT_EQ(run({"model.obj", "--charts=3", "--export-mesh=other.obj"}).exitCode, 0);
  EXPECT_EQ(run({"model.obj", "--charts=3", "--export-mesh=link.obj", "--overwrite"}).exitCode, 0);
  EXPECT_NE(readAll(folder_.path() / "model.obj"), before);
  EXPECT_TRUE(std::filesystem::is_symlink(folder_.path() / "link.obj"));
}

TEST_F(Program, ProblemsOfAFaceOfThousandsOfCornersAreFound) {
  constexpr int kCorners = 5000;
  std::string text, face = "f";
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / kCorners;
    text += "v " + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + " 0\n";
    face += ' ' + std::to_string(i + 1);
  }
  writeAll(folder_.path() / "disk.obj", text + face + '\n');
  const ProgramRun done =
      run({"disk.obj", "--problems", "--output=a.png", "--resolution=64,64", "--supersampling=1"});
  EXPECT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "a.png"));
}

TEST_F(Program, StandardOutputCarriesNothingButTheReport) {
  const ProgramRun done = run({"--sample=cube", "--report=-", "--verbose=debug"});
  ASSERT_EQ(done.exitCode, 0) << done.errors;
  EXPECT_NO_THROW(json::parse(done.output));
  EXPECT_EQ(done.errors.find('\r'), std::string::npos) << "progress without a terminal";
}

TEST_F(Program, RunsTheCommandsOfTheReadme) {
  std::istringstream lines(readAll(std::filesystem::path(CHARTFLOOD_SOURCE_ROOT) / "README.md"));
  const std::string start = "build/release/chartflood ";
  std::size_t commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(start)) continue;
    std::istringstream stream(line.substr(start.size()));
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    const ProgramRun done = run(words);
    EXPECT_EQ(done.exitCode, 0) << line << "\n" << done.errors;
    ++commands;
  }
  EXPECT_GE(commands, 4u);
  EXPECT_EQ(listing(), (std::vector<std::string>{"flood.png", "rocket-uv.png", "rocket.obj",
                                                 "rocket.png", "rocket.txt"}));
}

}  // namespace
}  // namespace chartflood
