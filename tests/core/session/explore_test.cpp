// Values are answered with finished charts, those of a batch run: core/session, Answer::Sketch and
// Answer::Finished.

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/segment/registry.h"
#include "core/session/pipeline/kept_runs.h"
#include "core/session/session.h"
#include "tests/support/segment_inputs.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

using Answer = Session::Answer;

/// What a batch run with a document gives.
std::shared_ptr<const Results> batch(const std::shared_ptr<const Mesh>& mesh,
                                     const Document& document) {
  Session session(Session::Worker::Inline);
  session.setDocument(document, Answer::Nothing);
  session.openMesh(mesh);
  session.setDocument(document, Answer::Nothing);  // opening forgets seeds
  session.step(StepUnit::Converged);
  session.unwrap();
  return session.results();
}

void expectSame(const Results& settled, const Results& made, const std::string& what) {
  ASSERT_TRUE(settled.segmentation && settled.atlas && made.atlas) << what;
  EXPECT_TRUE(settled.finished && settled.flat && !settled.sketch && !settled.stale) << what;
  EXPECT_EQ(settled.segmentation->label, made.segmentation->label) << what;
  EXPECT_EQ(settled.history.size(), made.history.size()) << what;
  EXPECT_EQ(settled.bestIteration, made.bestIteration) << what;
  EXPECT_EQ(settled.stopReason, made.stopReason) << what;
  ASSERT_EQ(settled.unwrap->charts.size(), made.unwrap->charts.size()) << what;
  for (std::size_t c = 0; c < made.unwrap->charts.size(); ++c) {
    EXPECT_EQ(settled.unwrap->charts[c].uv, made.unwrap->charts[c].uv) << what << ", chart " << c;
  }
  ASSERT_EQ(settled.atlas->placement.size(), made.atlas->placement.size()) << what;
  for (std::size_t c = 0; c < made.atlas->placement.size(); ++c) {
    EXPECT_EQ(settled.atlas->placement[c].offset, made.atlas->placement[c].offset) << what;
  }
}

class Explore : public testing::TestWithParam<Session::Worker> {
 protected:
  void open(const char* sample, std::size_t triangles) {
    session_.setAutoUnwrap(true);
    mesh_ = test::sampleMesh(sample, triangles);
    session_.openMesh(mesh_);
    session_.waitIdle();
  }
  std::shared_ptr<const Results> answer(const Document& document, Answer answer) {
    session_.setDocument(document, answer);
    session_.waitIdle();
    return session_.results();
  }

  Session session_{GetParam()};
  std::shared_ptr<const Mesh> mesh_;
};
INSTANTIATE_TEST_SUITE_P(Workers, Explore,
                         testing::Values(Session::Worker::Threaded, Session::Worker::Inline),
                         [](const auto& instance) {
                           const bool own = instance.param == Session::Worker::Inline;
                           return std::string(own ? "Inline" : "Threaded");
                         });

TEST_P(Explore, FinishedChartsAreABatchRuns) {
  if (GetParam() == Session::Worker::Threaded) GTEST_SKIP() << "the walk has both workers";
  open("rocket", 1500);
  Document document = session_.document();
  askCharts(document.parameters, 9);
  expectSame(*answer(document, Answer::Finished), *batch(mesh_, document), "as opened");
  for (const ParameterInfo& info : parameterTable()) {
    if (info.stage == Stage::Request || info.stage == Stage::Mesh) continue;
    Document changed = document;
    const ParameterValue value = parameterValue(changed.parameters, info);
    if (std::holds_alternative<bool>(value)) {
      setParameter(changed.parameters, info, !std::get<bool>(value));
    } else if (const std::string* word = std::get_if<std::string>(&value)) {
      for (const ParameterChoice& choice : info.choices) {
        if (choice.id != *word) setParameterFromText(changed.parameters, info, choice.id);
      }
    } else {
      const double ends = info.sliderMin + 0.4 * (info.sliderMax - info.sliderMin);
      std::string text = std::to_string(ends);
      if (std::holds_alternative<int>(value)) text = std::to_string(static_cast<int>(ends));
      setParameterFromText(changed.parameters, info, text);
    }
    // The way through a sketch and back leaves no trace.
    answer(changed, Answer::Sketch);
    expectSame(*answer(changed, Answer::Finished), *batch(mesh_, changed), info.id);
    expectSame(*answer(document, Answer::Finished), *batch(mesh_, document),
               std::string("back from ") + info.id);
  }
}

TEST_P(Explore, AnyWalkEndsWithABatchRunsCharts) {
  open("bumps", 1500);
  const std::vector<std::string> methods = {"t-flooding", "t-flooding", "vsa", "mcgim"};
  std::mt19937 random(7);
  const auto upTo = [&](std::size_t n) { return random() % n; };
  std::vector<std::pair<Document, FloodMoment>> past;
  for (int i = 0; i < 30; ++i) {
    Document document = session_.document();
    Parameters& p = document.parameters;
    switch (upTo(8)) {
    case 0:
      p.speedPower = 0.5 + 0.25 * static_cast<double>(upTo(10));
      break;
    case 1:
      p.offsetDamping = 0.1 * static_cast<double>(1 + upTo(9));
      break;
    case 2:
      askCharts(p, static_cast<int>(2 + upTo(30)));
      break;
    case 3:
      p.method = methods[upTo(methods.size())];
      break;
    case 4:
      document.seeds = {{static_cast<Index>(upTo(1500))}, {5, true}};
      break;
    case 5:
      document.seeds.clear();
      break;
    case 6:
      p.creaseWeight = 0.1 * static_cast<double>(1 + upTo(9));
      break;
    default:
      p.margin = static_cast<int>(upTo(8));
      break;
    }
    past.emplace_back(session_.document(), momentOf(*session_.results()));
    for (std::size_t drags = upTo(3); drags > 0; --drags) {
      session_.setDocument(document, Answer::Sketch);
      if (upTo(2) == 0) session_.waitIdle();
    }
    if (upTo(4) == 0) {  // undo in the middle of it
      const auto& [then, moment] = past[upTo(past.size())];
      document = then;
      session_.restore(then, moment, Answer::Finished);
    }
    const auto settled = answer(document, Answer::Finished);
    expectSame(*settled, *batch(mesh_, document), "step " + std::to_string(i));
  }
}

TEST_P(Explore, ASketchIsFinishedButNoBatchRun) {
  open("bumps", 8000);
  Document document = session_.document();
  const auto before = answer(document, Answer::Finished);
  document.parameters.speedPower = 1.2;
  const auto sketch = answer(document, Answer::Sketch);
  ASSERT_TRUE(sketch->segmentation);
  test::expectValid(*sketch->mesh, *sketch->gaussArea, *sketch->segmentation);
  EXPECT_TRUE(sketch->sketch && sketch->finished && sketch->flat);
  EXPECT_EQ(sketch->segmentation->chartCount, before->segmentation->chartCount);
  EXPECT_EQ(sketch->parameters, document.parameters);
  EXPECT_EQ(momentOf(*sketch), FloodMoment{}) << "its charts cannot be made again by one flood";
  EXPECT_LE(sketch->history.size(), 9u);
  session_.step(StepUnit::Converged);  // "Run" means a whole run
  session_.waitIdle();
  expectSame(*session_.results(), *batch(mesh_, document), "run from a sketch");
}

TEST_P(Explore, TheWayBackComputesNothing) {
  open("bumps", 3000);
  const Document first = session_.document();
  const auto before = answer(first, Answer::Finished);
  Document other = first;
  other.parameters.speedPower = 2;
  answer(other, Answer::Finished);
  const auto again = answer(first, Answer::Finished);
  EXPECT_EQ(again->segmentation, before->segmentation);
  EXPECT_EQ(again->atlas, before->atlas);
  EXPECT_EQ(again->floods, before->floods) << "the film of rounds is there";
  EXPECT_EQ(again->record, before->record);
  EXPECT_EQ(again->gaussArea, before->gaussArea);
  session_.restore(other, {}, Answer::Finished);
  session_.waitIdle();
  session_.restore(first, momentOf(*before), Answer::Finished);
  session_.waitIdle();
  EXPECT_EQ(session_.results()->segmentation, before->segmentation);
}

TEST_P(Explore, LaterStagesLeaveTheFloodAlone) {
  open("bumps", 3000);
  Document document = session_.document();
  const auto before = answer(document, Answer::Finished);
  document.parameters.margin = 3;
  const auto packed = answer(document, Answer::Sketch);
  EXPECT_EQ(packed->segmentation, before->segmentation);
  EXPECT_EQ(packed->unwrap, before->unwrap);
  EXPECT_NE(packed->atlas, before->atlas);
  EXPECT_FALSE(packed->sketch);
  EXPECT_TRUE(packed->flat);
}

TEST_P(Explore, SeveralSeedsAreTriedOnAFinishedModel) {
  open("bumps", 3000);
  Document document = session_.document();
  answer(document, Answer::Finished);
  document.parameters.bestOf = 3;
  const auto results = answer(document, Answer::Finished);
  ASSERT_TRUE(results->seedRuns);
  EXPECT_EQ(results->seedRuns->runs.size(), 3u);
  expectSame(*results, *batch(mesh_, document), "best of 3");
}

TEST(Exploring, WhatWasStoppedLeavesTheOldChartsAndCanBeRun) {
  Session session(Session::Worker::Threaded);
  session.openSample("bumps", 30000);
  session.waitIdle();
  Document document = session.document();
  session.setDocument(document, Answer::Finished);
  session.waitIdle();
  const auto before = session.results();
  document.parameters.speedPower = 2;
  session.setDocument(document, Answer::Finished);
  session.stop();
  document.parameters.speedPower = 2.5;
  session.setDocument(document, Answer::Finished);
  while (!session.status().busy) {
  }
  // Values given still count; their charts are given up.
  while (*session.status().phase == '\0' && session.status().busy) {
  }
  session.stop();
  session.waitIdle();
  const auto stopped = session.results();
  if (stopped->stale) {
    EXPECT_EQ(stopped->segmentation, before->segmentation);
    session.step(StepUnit::Converged);
    session.waitIdle();
  }
  EXPECT_FALSE(session.results()->stale);
  EXPECT_EQ(session.results()->segmentation->label,
            batch(before->mesh, document)->segmentation->label);
}

SegmentOptions fourCharts() {
  SegmentOptions options;
  options.charts = 4;
  return options;
}

/// A finished run with a speed of p.
ChartRun runOf(const SegmentInputs& inputs, double speedPower) {
  ChartRun run;
  run.document.parameters.speedPower = speedPower;
  run.stepper = segmenterOf("t-flooding").make(inputs, fourCharts());
  Progress progress;
  run.stepper->advance(StepUnit::Converged, 1, progress);
  run.segmentation = run.stepper->state();
  return run;
}

TEST(KeptRuns, StayWithinTheirMemoryAndTheNewestStay) {
  const SegmentInputs mesh = test::segmentInputs(test::sampleMesh("bumps", 1000));
  KeptRuns probe;
  probe.keep(runOf(mesh, 1));
  const std::size_t one = probe.bytes();
  ASSERT_GT(one, 0u);
  KeptRuns kept(3 * one);
  kept.keep(ChartRun{});
  EXPECT_EQ(kept.size(), 0u) << "nothing finished";
  for (int p = 1; p <= 5; ++p) kept.keep(runOf(mesh, p));
  EXPECT_EQ(kept.size(), 3u);
  EXPECT_LE(kept.bytes(), 3 * one);
  Document document;
  document.parameters.speedPower = 2;
  EXPECT_FALSE(kept.take(document));
  document.parameters.speedPower = 4;
  EXPECT_TRUE(kept.take(document));
  EXPECT_FALSE(kept.take(document)) << "it was handed out";
  EXPECT_EQ(kept.bytes(), 2 * one);
}

}  // namespace
}  // namespace chartflood
