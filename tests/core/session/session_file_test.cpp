// Session files: what is written comes back, and nothing broken gets through:
// core/session/session_io.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/read/file_checksum.h"
#include "core/session/files/session_io.h"
#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const char* const kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

class SessionFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_.path() / "work");
    writeAll(mesh(), kSquare);
  }
  std::filesystem::path mesh() const { return folder_.path() / "work" / "square.obj"; }
  std::filesystem::path target() const { return folder_.path() / "work" / "s.chartflood"; }

  SessionFile example() const {
    SessionFile session;
    session.model = {mesh(), fileChecksum(mesh()), "", 0};
    session.parameters.charts = 2;
    session.parameters.speedEpsilon = 0.1 + 0.2;  // needs all its digits
    session.parameters.refine = "none";
    session.parameters.offsets = false;
    session.seeds = {{1, true}, {0, false}};
    session.charts = {{{1, 0}, {0.25, 1.0 / 3}, {{0, 0, 1}, {0.6, 0, -0.8}}, {}, {}}, 2, true};
    session.view = {{"seams", false},
                    {"colormap", std::string("magma")},
                    {"camera", std::vector<double>{1, 0.5}}};
    return session;
  }
  void write(const std::string& text) const { writeAll(target(), text); }
  std::string refusal(const std::string& text) const {
    write(text);
    try {
      readSession(target());
    } catch (const ReadError& error) {
      return error.what();
    }
    ADD_FAILURE() << "was taken: " << text.substr(0, 200);
    return "";
  }
  /// The example with a change of its JSON, read again.
  SessionFile changed(const std::function<void(json&)>& change) const {
    json text = json::parse(sessionText(example(), target()));
    change(text);
    write(text.dump());
    return readSession(target());
  }

  TemporaryFolder folder_;
};

TEST_F(SessionFiles, RoundTrip) {
  const SessionFile session = example();
  write(sessionText(session, target()));
  const SessionFile again = readSession(target());
  EXPECT_EQ(again.model, session.model);
  EXPECT_EQ(again.parameters, session.parameters);
  EXPECT_EQ(again.seeds, session.seeds);
  EXPECT_EQ(again.charts, session.charts);
  EXPECT_EQ(again.view, session.view);
  EXPECT_TRUE(again.warnings.empty());
  EXPECT_EQ(sessionText(again, target()), sessionText(session, target()));
}

TEST_F(SessionFiles, EveryParameterComesBack) {
  for (const ParameterInfo& info : parameterTable()) {
    SessionFile session = example();
    ParameterValue value = parameterValue(session.parameters, info);
    if (bool* on = std::get_if<bool>(&value)) *on = !*on;
    if (int* whole = std::get_if<int>(&value)) *whole += 1;
    if (double* number = std::get_if<double>(&value)) *number = std::max(*number / 3, info.hardMin);
    setParameter(session.parameters, info, value);
    write(sessionText(session, target()));
    const SessionFile again = readSession(target());
    EXPECT_EQ(again.parameters, session.parameters) << info.id;
    EXPECT_TRUE(again.warnings.empty()) << info.id;
  }
}

TEST_F(SessionFiles, WhetherANumberOfChartsWasAskedForComesBack) {
  for (const bool asked : {false, true}) {
    SessionFile session = example();
    session.parameters.charts = 20;
    session.parameters.chartsAsked = asked;
    write(sessionText(session, target()));
    const SessionFile again = readSession(target());
    EXPECT_EQ(again.parameters, session.parameters);
    EXPECT_EQ(again.unknown, "");
  }
}

TEST_F(SessionFiles, EveryTruncationIsOneSentence) {
  const std::string whole = sessionText(example(), target());
  for (std::size_t length = 0; length + 2 <= whole.size(); ++length) {
    EXPECT_THAT(refusal(whole.substr(0, length)),
                AllOf(StartsWith("Could not read "), HasSubstr("s.chartflood: ")))
        << length;
  }
}

TEST_F(SessionFiles, ChangedBytesAreReadOrRefused) {
  const std::string whole = sessionText(example(), target());
  for (const char byte : {'"', '}', '9', '\xff'}) {
    for (std::size_t i = 0; i < whole.size(); i += 2) {
      std::string text = whole;
      text[i] = byte;
      write(text);
      try {
        const SessionFile session = readSession(target());
        // Whatever was taken can be written and read again.
        const std::string again = sessionText(session, target());
        write(again);
        EXPECT_EQ(readSession(target()).parameters, session.parameters);
      } catch (const ReadError& error) {
        EXPECT_THAT(error.what(), StartsWith("Could not read "));
      }
    }
  }
}

TEST_F(SessionFiles, WhatIsNoSessionIsRefused) {
  EXPECT_THAT(refusal(""), HasSubstr("not a whole session file"));
  EXPECT_THAT(refusal("solid cube"), HasSubstr("not a whole session file"));
  for (const char* text : {"[]", "3", "\"text\"", "null", "{}", "{\"version\": 1}"}) {
    EXPECT_THAT(refusal(text), HasSubstr("it is not a session file of chartflood")) << text;
  }
  EXPECT_THAT(refusal("{\"chartflood-session\": \"one\"}"), HasSubstr("its version is not"));
  EXPECT_THAT(refusal("{\"chartflood-session\": 0}"), HasSubstr("its version is not"));
  EXPECT_THAT(refusal("{\"chartflood-session\": 1}"), HasSubstr("which model"));
  EXPECT_THAT(refusal(std::string(1'000'000, '[')), StartsWith("Could not read "));
  EXPECT_THAT(refusal("{\"chartflood-session\": 1, \"deep\": " + std::string(10000, '[') +
                      std::string(10000, ']') + "}"),
              StartsWith("Could not read "));
  EXPECT_THROW(readSession(folder_.path() / "none.chartflood"), ReadError);
  EXPECT_THROW(readSession(folder_.path()), ReadError);
}

TEST_F(SessionFiles, ANewerVersionIsRefused) {
  json text = json::parse(sessionText(example(), target()));
  text["chartflood-session"] = 2;
  EXPECT_THAT(refusal(text.dump()), HasSubstr("was written by a newer chartflood (session "
                                              "version 2, this one reads 1)"));
}

TEST_F(SessionFiles, AMissingMeshAndSampleAreNamed) {
  const std::string text = sessionText(example(), target());
  std::filesystem::remove(mesh());
  EXPECT_THAT(refusal(text), AllOf(HasSubstr("is not there any more"), HasSubstr("square.obj")));
  json other = json::parse(text);
  other["model"] = {{"sample", "teapot"}};
  EXPECT_THAT(refusal(other.dump()), HasSubstr("'teapot' is not known"));
}

TEST_F(SessionFiles, AMovedFolderKeepsItsMesh) {
  write(sessionText(example(), target()));
  std::filesystem::rename(folder_.path() / "work", folder_.path() / "moved");
  const SessionFile session = readSession(folder_.path() / "moved" / "s.chartflood");
  EXPECT_EQ(session.model.file, folder_.path() / "moved" / "square.obj");
}

TEST_F(SessionFiles, AMovedSessionFindsItsMeshByTheWholePath) {
  write(sessionText(example(), target()));
  std::filesystem::create_directories(folder_.path() / "a" / "b");
  const auto moved = folder_.path() / "a" / "b" / "s.chartflood";
  std::filesystem::rename(target(), moved);
  EXPECT_EQ(readSession(moved).model.file, mesh());
}

TEST_F(SessionFiles, UnusableValuesAreNamedAndLeftOut) {
  const auto session = changed([](json& text) {
    text["parameters"]["charts"] = "many";
    text["parameters"]["speed-power"] = 1e9;
    text["parameters"]["patience"] = 4294967297;
    text["parameters"]["method"] = "magic";
    text["seeds"] = {1, {{"face", -1}}, {{"face", 1}}};
    text["charts"]["offsets"] = {1};
    text["view"]["odd"] = nullptr;
  });
  EXPECT_EQ(session.parameters.charts, Parameters{}.charts);
  EXPECT_EQ(session.parameters.speedPower, Parameters{}.speedPower);
  EXPECT_EQ(session.parameters.patience, Parameters{}.patience);
  EXPECT_EQ(session.parameters.method, Parameters{}.method);
  EXPECT_EQ(session.parameters.refine, "none") << "the others are taken";
  EXPECT_EQ(session.seeds, (std::vector<PlacedSeed>{{1, false}}));
  EXPECT_EQ(session.charts, FloodMoment{});
  for (const char* name :
       {"'parameters/charts'", "'parameters/speed-power'", "'seeds'", "'parameters/patience'",
        "'parameters/method'", "'charts'", "'view/odd'"}) {
    EXPECT_THAT(session.warnings, testing::Contains(HasSubstr(name)));
  }
}

TEST_F(SessionFiles, WhatIsNotKnownIsKept) {
  const auto session = changed([](json& text) {
    text["future"] = {{"a", 1}};
    text["parameters"]["new-slider"] = 5;
    text["model"]["units"] = "mm";
  });
  EXPECT_THAT(session.warnings,
              ElementsAre(AllOf(HasSubstr("'future'"), HasSubstr("'parameters/new-slider'"),
                                HasSubstr("'model/units'"), HasSubstr("is kept"))));
  const json again = json::parse(sessionText(session, target()));
  EXPECT_EQ(again["future"]["a"], 1);
  EXPECT_EQ(again["parameters"]["new-slider"], 5);
  EXPECT_EQ(again["parameters"]["charts"], 2);
  EXPECT_EQ(again["model"]["units"], "mm");
}

TEST_F(SessionFiles, AnotherMeshIsTakenWithAWarning) {
  Session session(Session::Worker::Inline);
  session.open(mesh());
  const auto results = session.results();
  ASSERT_TRUE(results->mesh);
  EXPECT_EQ(results->checksum, fileChecksum(mesh()));
  SessionFile file = example();
  SessionContent content = sessionContent(file, *results->mesh, results->checksum);
  EXPECT_TRUE(content.warnings.empty());
  EXPECT_EQ(content.document.seeds, file.seeds);
  EXPECT_EQ(content.moment, file.charts);

  content = sessionContent(file, *results->mesh, "0123456789abcdef");
  EXPECT_THAT(content.warnings, ElementsAre(HasSubstr("was changed since")));
  EXPECT_EQ(content.document.seeds, file.seeds);
  EXPECT_EQ(content.moment, FloodMoment{});

  file.seeds = {{0}, {7}, {0}, {1}};
  content = sessionContent(file, *results->mesh, results->checksum);
  EXPECT_EQ(content.document.seeds, (std::vector<PlacedSeed>{{0}, {1}}));
  EXPECT_THAT(content.warnings, ElementsAre("2 seeds are no faces of this model and were left "
                                            "out."));
}

TEST_F(SessionFiles, TheWorkComesBackWithTheSameLabels) {
  Session work(Session::Worker::Inline);
  work.openSample("bumps", 4000);
  work.step(StepUnit::Flood, 3);
  const SessionModel model{"", "", "bumps", 4000};
  for (const StepUnit unit : {StepUnit::Face, StepUnit::Flood, StepUnit::Converged}) {
    work.step(unit, 100);
    write(sessionText(sessionOf(model, work.document(), *work.results()), target()));
    const SessionFile file = readSession(target());
    Session later(Session::Worker::Inline);
    later.openSample(file.model.sample, file.model.triangles);
    const SessionContent content = sessionContent(file, *later.results()->mesh, "");
    later.restore(content.document, content.moment);
    EXPECT_EQ(later.results()->segmentation->label, work.results()->segmentation->label);
  }
}

TEST_F(SessionFiles, ChecksumsTellFilesApart) {
  const auto sum = [&](const std::string& text) {
    writeAll(folder_.path() / "x", text);
    return fileChecksum(folder_.path() / "x");
  };
  const std::string large(3'000'000, 'a');
  EXPECT_EQ(sum(large), sum(large));
  EXPECT_EQ(sum("").size(), 16u);
  EXPECT_NE(sum(""), sum(std::string(1, '\0')));
  EXPECT_NE(sum("ab"), sum("ba"));
  EXPECT_NE(sum(large), sum(large + 'a'));
  std::string other = large;
  other[2'999'999] = 'b';
  EXPECT_NE(sum(large), sum(other));
  EXPECT_EQ(fileChecksum(folder_.path() / "none"), "");
}

TEST_F(SessionFiles, ASampleHasTheLimitsOfTheCommandLine) {
  const std::filesystem::path file =
      std::filesystem::path(CHARTFLOOD_CASES) / "session-two-billion-triangles.chartflood";
  try {
    readSession(file);
    ADD_FAILURE() << "was taken";
  } catch (const ReadError& error) {
    EXPECT_EQ(error.cause(), "its sample is to have 2000000000 triangles; give a number from 1 to "
                             "50000000");
  }
  write(R"({"chartflood-session": 1, "model": {"sample": "bumps", "triangles": 50000000}})");
  EXPECT_EQ(readSession(target()).model.triangles, 50'000'000u);
}

TEST_F(SessionFiles, DeepNestingIsRefused) {
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  EXPECT_THAT(refusal(R"({"chartflood-session": 1, "extra": )" + deep + "}"),
              HasSubstr("it is not a session file"));
  EXPECT_THAT(refusal(deep), HasSubstr("it is not a session file"));
  EXPECT_THAT(refusal(std::string(200'000, '[')), HasSubstr("it is not"));
}

TEST_F(SessionFiles, OnlyRegularFilesAreOpened) {
  ASSERT_EQ(::mkfifo((folder_.path() / "pipe.chartflood").c_str(), 0600), 0);
  for (const std::filesystem::path& file :
       {folder_.path() / "pipe.chartflood", std::filesystem::path("/dev/zero"), folder_.path()}) {
    EXPECT_THROW(readSession(file), ReadError) << file;
    EXPECT_EQ(fileChecksum(file), "");
  }
}

}  // namespace
}  // namespace chartflood
