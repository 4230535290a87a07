// Several runs beside each other: --best-of, the search for the number of charts, hints.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/session/pipeline/run_set.h"
#include "core/session/session.h"
#include "tests/support/part_models.h"

namespace chartflood {
namespace {

class Runs : public testing::Test {
 protected:
  ~Runs() override { setThreadCount(0); }
  void open(const std::string& sample, std::size_t triangles, Document document = {}) {
    session_.setDocument(document, Session::Answer::Nothing);
    session_.openSample(sample, triangles);
  }
  static Document withSeeds(int bestOf) {
    Document document;
    document.parameters.charts = 8;
    document.parameters.bestOf = bestOf;
    return document;
  }
  Session session_{Session::Worker::Inline};
};

TEST_F(Runs, TheBestSeedIsWhatItGivesAlone) {
  open("bumps", 2000, withSeeds(3));
  session_.step(StepUnit::Converged);
  const auto best = session_.results();
  ASSERT_TRUE(best->seedRuns);
  ASSERT_EQ(best->seedRuns->runs.size(), 3u);
  EXPECT_TRUE(best->finished);
  const chartflood::Run& chosen = best->seedRuns->runs[best->seedRuns->chosen];
  EXPECT_EQ(chosen.results->segmentation->label, best->segmentation->label);
  for (const chartflood::Run& run : best->seedRuns->runs) {
    if (run.spread.value_or(0) <= 0.02) {
      EXPECT_LE(chosen.seams, run.seams);
    }
  }
  Document alone = withSeeds(1);
  alone.parameters.rngSeed = chosen.parameters.rngSeed;
  Session other(Session::Worker::Inline);
  other.setDocument(alone, Session::Answer::Nothing);
  other.openSample("bumps", 2000);
  other.step(StepUnit::Converged);
  EXPECT_EQ(other.results()->segmentation->label, best->segmentation->label);
  EXPECT_FALSE(other.results()->seedRuns);
}

TEST_F(Runs, TheBestSeedIsTheSameForAnyNumberOfThreadsAndComesBack) {
  setThreadCount(1);
  open("gear", 2000, withSeeds(3));  // charts from creases
  session_.step(StepUnit::Converged);
  const auto one = session_.results();
  setThreadCount(4);
  Session other(Session::Worker::Inline);
  other.setDocument(withSeeds(3), Session::Answer::Nothing);
  other.openSample("gear", 2000);
  other.step(StepUnit::Converged);
  EXPECT_EQ(other.results()->segmentation->label, one->segmentation->label);
  const FloodMoment moment = momentOf(*one);
  EXPECT_TRUE(moment.start.creases.has_value());
  session_.resetSeeds();
  session_.restore(withSeeds(3), moment);
  EXPECT_EQ(session_.results()->segmentation->label, one->segmentation->label);
  EXPECT_EQ(momentOf(*session_.results()), moment);
}

TEST_F(Runs, WithoutReliefCutsTheFewestChartsKeepTheLimit) {
  Document document;
  document.parameters.maxStretch = 1.05;
  document.parameters.reliefStretch = 0;
  open("sphere", 1500, document);
  session_.findChartCount();
  const auto set = session_.results()->chartRuns;
  ASSERT_TRUE(set);
  const chartflood::Run& chosen = set->runs[set->chosen];
  EXPECT_TRUE(chosen.keeps(1.05));
  EXPECT_GT(chosen.charts, 1u);
  for (const chartflood::Run& run : set->runs) {
    if (run.charts < chosen.charts) {
      EXPECT_GT(run.worst, 1.05);
    }
  }
  EXPECT_TRUE(std::is_sorted(set->runs.begin(), set->runs.end(),
                             [](const auto& a, const auto& b) { return a.charts < b.charts; }));
  EXPECT_FALSE(session_.results()->segmentation) << "the charts stay as they were";
}

TEST_F(Runs, TheShortestSeamsKeepTheLimitInEveryChart) {
  Document document;
  document.parameters.maxStretch = 1.1;
  for (const char* sample : {"sphere", "bumps", "double-torus"}) {
    open(sample, 1500, document);
    session_.findChartCount();
    const auto set = session_.results()->chartRuns;
    const chartflood::Run chosen = set->runs[set->chosen];
    EXPECT_TRUE(chosen.keeps(1.1)) << sample;
    EXPECT_EQ(chosen.parameters.reliefStretch, 1.1);
    for (const chartflood::Run& run : set->runs) {
      EXPECT_EQ(run.stretch.has_value(), run.worst.has_value());
      if (run.keeps(1.1)) {
        EXPECT_GE(run.seams, chosen.seams);
      }
      if (!run.stretch) {
        EXPECT_GE(run.seams, chosen.seams) << "only what is too long already is not laid flat";
      }
    }
    // The same values give the same charts, and those of the search are there at once.
    document.parameters = chosen.parameters;
    session_.restore(document, chosen.moment);
    const auto found = session_.results();
    Session other(Session::Worker::Inline);
    other.setDocument(document, Session::Answer::Nothing);
    other.openSample(sample, 1500);
    other.step(StepUnit::Converged);
    other.unwrap();
    session_.unwrap();
    EXPECT_EQ(found->segmentation->label, other.results()->segmentation->label);
    for (std::size_t c = 0; c < chosen.charts; ++c) {
      EXPECT_EQ(session_.results()->unwrap->charts[c].uv, other.results()->unwrap->charts[c].uv);
      EXPECT_LE(other.results()->unwrap->charts[c].distortion.l2, 1.1);
    }
    document = {};
    document.parameters.maxStretch = 1.1;
  }
}

TEST_F(Runs, TheSearchIsTheSameForAnyNumberOfThreads) {
  std::vector<std::vector<Index>> labels;
  std::vector<double> seams;
  for (const unsigned threads : {1u, 4u}) {
    setThreadCount(threads);
    Session session(Session::Worker::Inline);
    session.openSample("double-torus", 2000);
    session.findChartCount();
    const auto set = session.results()->chartRuns;
    session.restore(Document{set->runs[set->chosen].parameters, {}, {}},
                    set->runs[set->chosen].moment);
    labels.push_back(session.results()->segmentation->label);
    for (const chartflood::Run& run : set->runs) seams.push_back(run.seams);
  }
  EXPECT_EQ(labels[0], labels[1]);
  ASSERT_EQ(seams.size() % 2, 0u);
  for (std::size_t i = 0; i < seams.size() / 2; ++i)
    EXPECT_EQ(seams[i], seams[i + seams.size() / 2]);
}

TEST_F(Runs, CrumbsAreNoChartsThatAreTried) {
  test::PartModel model;
  model.addBall({0, 0, 0}, 1, 24);
  for (int i = 0; i < 30; ++i) model.addTetrahedron({2, 0.1 * i, 0}, 0.01);
  session_.openMesh(model.mesh());
  session_.findChartCount();
  const auto runs = session_.results()->chartRuns;
  ASSERT_TRUE(runs);
  EXPECT_EQ(runs->runs.front().parameters.charts, 1);
  EXPECT_EQ(runs->runs.front().charts, 31u);
  for (const chartflood::Run& run : runs->runs) {
    EXPECT_EQ(run.charts, 30u + static_cast<std::size_t>(run.parameters.charts));
  }
}

TEST_F(Runs, OneChartIsEnoughForAPlane) {
  open("plane", 500);
  session_.findChartCount();
  const auto set = session_.results()->chartRuns;
  EXPECT_EQ(set->runs[set->chosen].charts, 1u);
}

/// Length of the borders of charts along edges with a hint of this kind, as a number of edges.
std::size_t bordersOn(const Results& results, const EdgeHints& hints) {
  const Mesh& mesh = *results.mesh;
  std::size_t count = 0;
  for (Index s = 0; s < mesh.opposite().size(); ++s) {
    const Index other = mesh.opposite()[s];
    if (other == kNone || other < s) continue;
    const auto& label = results.segmentation->label;
    if (label[mesh.faceOf(s / 3)] == label[mesh.faceOf(other / 3)]) continue;
    const Index a = mesh.inputVertex(mesh.sideStart(s)), b = mesh.inputVertex(mesh.sideEnd(s));
    count += std::any_of(hints.begin(), hints.end(), [&](const EdgeHint& hint) {
      return hint.a == std::min(a, b) && hint.b == std::max(a, b);
    });
  }
  return count;
}

class HintsWith : public Runs, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, HintsWith, testing::Values("t-flooding", "vsa", "mcgim"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(HintsWith, SeamsLeaveEdgesWhereNoneIsToBe) {
  Document document;
  document.parameters.method = GetParam();
  document.parameters.charts = 6;
  open("bumps", 2000, document);
  session_.step(StepUnit::Converged);
  const auto before = session_.results();
  const Mesh& mesh = *before->mesh;
  for (Index s = 0; s < mesh.opposite().size(); ++s) {  // the borders themselves
    const Index other = mesh.opposite()[s];
    const auto& label = before->segmentation->label;
    if (other == kNone || label[s / 3] == label[other / 3]) continue;
    addHint(document.hints, mesh.inputVertex(mesh.sideStart(s)), mesh.inputVertex(mesh.sideEnd(s)),
            HintKind::Never);
  }
  const std::size_t then = bordersOn(*before, document.hints);
  ASSERT_GT(then, 20u);
  session_.setDocument(document);
  EXPECT_LT(bordersOn(*session_.results(), document.hints), then / 4);
  document.hints.clear();
  session_.setDocument(document);
  EXPECT_EQ(session_.results()->segmentation->label, before->segmentation->label);
}

TEST_F(Runs, SeamsFollowEdgesWhereTheyAreWelcome) {
  Document document;
  document.parameters.charts = 2;
  document.parameters.balanceWeight = 10;
  open("sphere", 1500, document);
  session_.step(StepUnit::Converged);
  const Mesh& mesh = *session_.results()->mesh;
  EdgeHints ring;  // edges across a plane beside the middle, as near as the mesh has it
  for (Index s = 0; s < mesh.opposite().size(); ++s) {
    const Index other = mesh.opposite()[s];
    const auto above = [&](Index triangle) {
      double y = 0;
      for (const Index v : mesh.triangles()[triangle]) y += mesh.positions()[v].y / 3;
      return y > 0.05;
    };
    if (other == kNone || above(s / 3) == above(other / 3)) continue;
    addHint(ring, mesh.inputVertex(mesh.sideStart(s)), mesh.inputVertex(mesh.sideEnd(s)),
            HintKind::Cut);
  }
  const std::size_t before = bordersOn(*session_.results(), ring);
  document.hints = ring;
  session_.setDocument(document);
  EXPECT_GT(bordersOn(*session_.results(), ring), before);
}

}  // namespace
}  // namespace chartflood
