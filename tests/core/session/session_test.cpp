// The session drives mesh, stages and steps alike with both workers: core/session/session.

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "core/session/pipeline/pipeline.h"
#include "core/session/session.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

class SessionWith : public testing::TestWithParam<Session::Worker> {
 protected:
  Session session_{GetParam()};

  void openSample(const char* name, std::size_t triangles) {
    session_.openSample(name, triangles);
    session_.waitIdle();
    ASSERT_TRUE(session_.results()->mesh);
  }
  std::shared_ptr<const Results> after(StepUnit unit, std::size_t count = 1) {
    session_.step(unit, count);
    session_.waitIdle();
    return session_.results();
  }
  void set(void (*change)(Document&), bool live = true) {
    Document document = session_.document();
    change(document);
    session_.setDocument(document, live ? Session::Answer::Flood : Session::Answer::Nothing);
    session_.waitIdle();
  }
  bool anyError() {
    bool error = false;
    for (const Notice& n : session_.takeNotices()) error = error || n.kind == Notice::Kind::Error;
    return error;
  }
};
INSTANTIATE_TEST_SUITE_P(Workers, SessionWith,
                         testing::Values(Session::Worker::Threaded, Session::Worker::Background,
                                         Session::Worker::Inline),
                         [](const auto& instance) {
                           if (instance.param == Session::Worker::Inline) return "Inline";
                           const bool plain = instance.param == Session::Worker::Threaded;
                           return plain ? "Threaded" : "Background";
                         });

TEST_P(SessionWith, OpensAndMeasures) {
  openSample("rocket", 4000);
  const auto results = session_.results();
  EXPECT_TRUE(results->gaussArea);
  EXPECT_FALSE(results->segmentation);
  EXPECT_GE(results->timing.gaussArea, 0);
  EXPECT_FALSE(anyError());
}

TEST_P(SessionWith, KeepsTheOldMeshWhenOpeningFails) {
  openSample("cube", 500);
  const auto before = session_.results();
  session_.takeNotices();
  session_.open("/no/such/file.obj");
  session_.waitIdle();
  EXPECT_EQ(session_.results()->mesh, before->mesh);
  EXPECT_TRUE(anyError());
  session_.openSample("no-such-sample");
  session_.waitIdle();
  EXPECT_EQ(session_.results()->mesh, before->mesh);
  EXPECT_TRUE(anyError());
}

TEST_P(SessionWith, GluesTheMeshAnewWhereVerticesAreJoinedInAnotherWay) {
  // Two squares side by side that share no vertex.
  const auto joined = test::meshOf(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}});
  session_.openMesh(joined);
  session_.waitIdle();
  set([](Document& d) { d.parameters.charts = 1; });
  EXPECT_EQ(after(StepUnit::Converged)->segmentation->chartCount, 1u);
  const std::uint64_t version = session_.results()->meshVersion;
  set([](Document& d) { d.parameters.weld = "off"; });
  auto results = session_.results();
  EXPECT_GT(results->meshVersion, version);
  EXPECT_EQ(results->mesh->componentCount(), 2u);
  ASSERT_TRUE(results->segmentation);
  EXPECT_EQ(results->segmentation->chartCount, 2u);
  set([](Document& d) { d.parameters.weld = "auto"; });
  EXPECT_EQ(session_.results()->mesh->componentCount(), 1u);
  EXPECT_FALSE(anyError());
}

TEST_P(SessionWith, StepWithoutMeshIsRefused) {
  after(StepUnit::Flood);
  EXPECT_TRUE(anyError());
}

TEST_P(SessionWith, RunsToTheEnd) {
  openSample("bumps", 6000);
  const auto results = after(StepUnit::Converged);
  ASSERT_TRUE(results->segmentation);
  test::expectValid(*results->mesh, *results->gaussArea, *results->segmentation);
  EXPECT_NE(results->stopReason, StopReason::NotStopped);
  EXPECT_EQ(results->chartStats->charts.size(), 20u);
  EXPECT_EQ(results->record->size(), results->mesh->faceCount());
  EXPECT_FALSE(results->history.empty());
}

TEST_P(SessionWith, StepsEqualOneRun) {
  openSample("bumps", 5000);
  const auto whole = after(StepUnit::Converged);
  Session stepped(GetParam());
  stepped.openSample("bumps", 5000);
  for (int i = 0; i < 40; ++i) {
    stepped.step(StepUnit::Face, 777);
    stepped.step(StepUnit::Iteration);
  }
  stepped.step(StepUnit::Converged);
  stepped.waitIdle();
  EXPECT_EQ(stepped.results()->segmentation->label, whole->segmentation->label);
}

TEST_P(SessionWith, ChangesRecomputeOnlyWhatTheyTouch) {
  openSample("rocket", 5000);
  after(StepUnit::Flood);
  const auto before = session_.results();
  set([](Document& d) { d.parameters.speedEpsilon = 1e-2; });
  const auto epsilon = session_.results();
  EXPECT_EQ(epsilon->gaussArea, before->gaussArea);
  EXPECT_EQ(epsilon->start.seeds, before->start.seeds);
  EXPECT_NE(epsilon->segmentation->label, before->segmentation->label);
  set([](Document& d) { d.parameters.sharpAngle = 20; });
  EXPECT_NE(session_.results()->gaussArea, before->gaussArea);
  EXPECT_GT(session_.results()->gaussVersion, before->gaussVersion);
  EXPECT_EQ(session_.results()->meshVersion, before->meshVersion);
}

TEST_P(SessionWith, MoreChartsKeepTheOldSeeds) {
  openSample("rocket", 5000);
  after(StepUnit::Flood);
  const auto before = session_.results()->start.seeds;
  set([](Document& d) { d.parameters.charts = 23; });
  auto seeds = session_.results()->start.seeds;
  ASSERT_EQ(seeds.size(), 23u);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), seeds.begin()));
  set([](Document& d) { d.parameters.charts = 5; });
  seeds = session_.results()->start.seeds;
  ASSERT_EQ(seeds.size(), 5u);
  EXPECT_TRUE(std::equal(seeds.begin(), seeds.end(), before.begin()));
}

TEST_P(SessionWith, PlacedSeedsAreUsed) {
  openSample("sphere", 3000);
  set([](Document& d) {
    d.seeds = {{5}, {100}, {2000}};
    d.parameters.charts = 3;
  });
  const auto results = after(StepUnit::Flood);
  EXPECT_EQ(results->segmentation->seeds, (std::vector<Index>{5, 100, 2000}));
  session_.openSample("cube", 500);
  session_.waitIdle();
  EXPECT_TRUE(session_.document().seeds.empty()) << "seeds belong to the mesh they were placed on";
}

TEST_P(SessionWith, NotLiveMarksStaleAndKeepsTheOldCharts) {
  openSample("rocket", 4000);
  after(StepUnit::Flood);
  const auto before = session_.results();
  set([](Document& d) { d.parameters.speedPower = 3; }, false);
  EXPECT_TRUE(session_.results()->stale);
  EXPECT_EQ(session_.results()->segmentation, before->segmentation);
  EXPECT_FALSE(after(StepUnit::Flood)->stale);
}

TEST_P(SessionWith, CleanUpSliderTidiesAgain) {
  openSample("bumps", 6000);
  const auto run = after(StepUnit::Converged);
  set([](Document& d) { d.parameters.refine = "none"; });
  const auto raw = session_.results();
  EXPECT_FALSE(raw->segmentation->refined);
  EXPECT_GT(raw->chartStats->seamLength, run->chartStats->seamLength);
  set([](Document& d) { d.parameters.refine = "cuts"; });
  EXPECT_EQ(session_.results()->segmentation->label, run->segmentation->label);
}

TEST_P(SessionWith, WhatOnlyRoundsHeedLeavesFinishedChartsAlone) {
  openSample("bumps", 5000);
  const auto run = after(StepUnit::Converged);
  ASSERT_GT(run->history.size(), 1u);
  set([](Document& d) {
    d.parameters.offsetDamping = 0.7;
    d.parameters.offsets = false;
    d.parameters.maxIterations = 9;
    d.parameters.patience = 2;
    d.parameters.keep = "last";
    d.parameters.detectCycles = false;
    d.parameters.settle = 0;
  });
  const auto same = session_.results();
  EXPECT_EQ(same->segmentation, run->segmentation);
  EXPECT_EQ(same->history.size(), run->history.size());
  EXPECT_TRUE(same->finished);
  EXPECT_EQ(same->parameters.offsetDamping, 0.7);
  EXPECT_TRUE(same->unsettled) << "there is more to run";
  const auto again = after(StepUnit::Converged);  // by the new rules
  EXPECT_FALSE(again->unsettled);
  EXPECT_LE(again->history.size(), 9u);
  Session batch(Session::Worker::Inline);
  batch.setDocument(session_.document(), Session::Answer::Nothing);
  batch.openSample("bumps", 5000);
  batch.step(StepUnit::Converged);
  EXPECT_EQ(again->segmentation->label, batch.results()->segmentation->label);
}

TEST_P(SessionWith, GoesOnFromFinishedCharts) {
  openSample("bumps", 5000);
  for (const char* refine : {"cuts", "moves", "none"}) {
    Document document = session_.document();
    document.parameters.refine = refine;
    session_.setDocument(document, Session::Answer::Nothing);
    const auto run = after(StepUnit::Converged);
    const auto on = after(StepUnit::Flood, 2);
    EXPECT_EQ(on->history.size(), 2u) << refine;
    EXPECT_EQ(on->stopReason, StopReason::NotStopped);
    EXPECT_EQ(on->history[0].seeds, run->history[run->bestIteration].seeds);
  }
}

TEST_P(SessionWith, ResetsAndAdopts) {
  openSample("bumps", 5000);
  const auto first = after(StepUnit::Flood);
  const auto third = after(StepUnit::Flood, 2);
  EXPECT_EQ(third->history.size(), 3u);
  session_.resetFlood();
  session_.waitIdle();
  EXPECT_EQ(session_.results()->record->size(), 0u);
  session_.adoptIteration(2);
  session_.waitIdle();
  EXPECT_EQ(session_.results()->segmentation->label, third->segmentation->label);
  session_.resetSeeds();
  const auto again = after(StepUnit::Flood);
  EXPECT_EQ(again->segmentation->label, first->segmentation->label);
}

TEST_P(SessionWith, SaysWhenChartsAreRaised) {
  InputMesh parts;
  parts.file = "parts";
  for (Index i = 0; i < 30; ++i) {
    const double x = 3.0 * i;
    parts.positions.insert(parts.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
    parts.corners.insert(parts.corners.end(), {3 * i, 3 * i + 1, 3 * i + 2});
  }
  session_.openMesh(test::rebuild(std::move(parts)));
  const auto results = after(StepUnit::Converged);
  EXPECT_EQ(results->segmentation->chartCount, 30u);
  bool said = false;
  for (const Notice& n : session_.takeNotices()) {
    said = said || n.text.find("K was raised to 30") != std::string::npos;
  }
  EXPECT_TRUE(said);
}

TEST(SessionThreaded, StopAnswersAtOnceAndKeepsAValidState) {
  Session session(Session::Worker::Threaded);
  session.openSample("bumps", 300000);
  session.waitIdle();
  session.step(StepUnit::Converged);
  while (!session.results()->record) std::this_thread::yield();
  session.stop();
  session.waitIdle();
  const auto stopped = session.results();
  ASSERT_TRUE(stopped->segmentation);
  // It can go on from there.
  session.step(StepUnit::Flood);
  session.waitIdle();
  EXPECT_TRUE(session.results()->segmentation->complete);
}

TEST(SessionThreaded, ReadersFollowTheGrowingLog) {
  Session session(Session::Worker::Threaded);
  static std::atomic<int> wakes{0};
  session.setWake([] { ++wakes; });
  session.openSample("bumps", 60000);
  session.step(StepUnit::Flood, 3);
  std::size_t seen = 0;
  while (session.status().busy) {
    const auto results = session.results();
    if (!results->record) continue;
    const std::size_t size = results->record->size();
    for (std::size_t i = 0; i < size; ++i) {
      ASSERT_LT((*results->record)[i].face, results->mesh->faceCount());
    }
    seen = std::max(seen, size);
  }
  session.waitIdle();
  EXPECT_EQ(session.results()->record->size(), session.results()->mesh->faceCount());
  EXPECT_GT(wakes.load(), 0);
  session.setWake(nullptr);
}

TEST(SessionThreaded, StoppedAtTheVeryEndLaysNothingFlat) {
  Session session(Session::Worker::Threaded);
  static Session* stopped = nullptr;
  stopped = &session;
  session.setAutoUnwrap(true);
  session.openSample("bumps", 2000);
  session.waitIdle();
  // Called by the worker between the last labels and what would follow them.
  session.setWake([] {
    if (stopped->results()->finished) stopped->stop();
  });
  session.step(StepUnit::Converged);
  session.waitIdle();
  EXPECT_TRUE(session.results()->finished);
  EXPECT_FALSE(session.results()->flat);
  session.setWake(nullptr);
  session.unwrap();
  session.waitIdle();
  EXPECT_TRUE(session.results()->flat);
}

TEST(Pipeline, AStepThatIsStoppedAtOncePlacesNoSeeds) {
  Pipeline pipeline({[](const FloodBegun&) {}, [](Notice) {}});
  Progress go, stopped;
  pipeline.setMesh(test::sampleMesh("bumps", 2000), 0, go);
  stopped.cancel();
  EXPECT_EQ(pipeline.step(StepUnit::Converged, 1, stopped), StepOutcome::Cancelled);
  Results results;
  pipeline.measure();
  pipeline.report(results);
  EXPECT_FALSE(results.segmentation);
  EXPECT_EQ(pipeline.step(StepUnit::Flood, 1, go), StepOutcome::Advanced);
}

TEST(SessionThreaded, NewestChangeWins) {
  Session session(Session::Worker::Threaded);
  session.openSample("bumps", 40000);
  session.step(StepUnit::Flood);
  session.waitIdle();
  Document document = session.document();
  for (int i = 1; i <= 50; ++i) {
    document.parameters.speedPower = 1 + 0.1 * i;
    session.setDocument(document);
  }
  session.waitIdle();
  const auto quick = session.results();
  EXPECT_DOUBLE_EQ(quick->parameters.speedPower, 6);
  ASSERT_TRUE(quick->segmentation->complete);
  test::expectValid(*quick->mesh, *quick->gaussArea, *quick->segmentation);
}

TEST(SessionThreaded, EndsWhileItWorks) {
  for (int i = 0; i < 5; ++i) {
    Session session(Session::Worker::Threaded);
    session.openSample("bumps", 50000);
    session.step(StepUnit::Converged);
    std::this_thread::sleep_for(std::chrono::milliseconds(5 * i));
  }
}

}  // namespace
}  // namespace chartflood
