// The charts of a moment are made again by one flood: Session::restore.

#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "core/session/session.h"

namespace chartflood {
namespace {

class Restore : public testing::TestWithParam<std::tuple<Session::Worker, const char*>> {
 protected:
  void SetUp() override {
    Document document;
    document.parameters.search = std::get<1>(GetParam());
    session_.setDocument(document, Session::Answer::Nothing);
    session_.openSample("bumps", 8000);
    session_.waitIdle();
  }
  void step(StepUnit unit, std::size_t count = 1) {
    session_.step(unit, count);
    session_.waitIdle();
  }
  /// Takes the present moment, does something else, comes back, compares.
  void expectSameAfter(void (*change)(Document&)) {
    const auto before = session_.results();
    const Document document = session_.document();
    const FloodMoment moment = momentOf(*before);
    Document other = document;
    change(other);
    session_.setDocument(other);
    session_.waitIdle();
    const auto between = session_.results();
    EXPECT_NE(between->segmentation->label, before->segmentation->label);
    session_.restore(document, moment);
    session_.waitIdle();
    const auto after = session_.results();
    EXPECT_EQ(after->segmentation->label, before->segmentation->label);
    EXPECT_EQ(after->segmentation->refined, before->segmentation->refined);
    EXPECT_EQ(after->start.seeds, before->start.seeds);
    EXPECT_EQ(after->record->size(), before->record->size());
    EXPECT_EQ(momentOf(*after), moment);
    EXPECT_EQ(session_.document(), document);
  }

  Session session_{std::get<0>(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(Workers, Restore,
                         testing::Values(std::tuple(Session::Worker::Threaded, "literal"),
                                         std::tuple(Session::Worker::Inline, "literal"),
                                         std::tuple(Session::Worker::Inline, "fast")),
                         [](const auto& instance) {
                           const bool own = std::get<0>(instance.param) == Session::Worker::Inline;
                           return std::string(own ? "Inline_" : "Threaded_") +
                                  std::get<1>(instance.param);
                         });

TEST_P(Restore, TheFirstFlood) {
  step(StepUnit::Flood);
  expectSameAfter([](Document& d) { d.parameters.charts = 12; });
}

TEST_P(Restore, ALaterRoundWithItsOffsets) {
  step(StepUnit::Flood, 7);
  bool waits = false;
  for (const double offset : session_.results()->start.offsets) waits = waits || offset != 0;
  EXPECT_TRUE(waits);
  expectSameAfter([](Document& d) { d.parameters.sharpAngle = 20; });
}

TEST_P(Restore, FinishedCharts) {
  step(StepUnit::Converged);
  EXPECT_TRUE(momentOf(*session_.results()).finished);
  expectSameAfter([](Document& d) { d.parameters.speedPower = 3; });
  expectSameAfter([](Document& d) { d.parameters.balanceWeight = 10; });
  expectSameAfter([](Document& d) { d.seeds = {{1}, {2}, {3}}; });
}

TEST_P(Restore, APartOfAFlood) {
  step(StepUnit::Flood, 2);
  step(StepUnit::Face, 1234);
  EXPECT_FALSE(session_.results()->segmentation->complete);
  expectSameAfter([](Document& d) { d.parameters.lookahead = false; });
}

TEST_P(Restore, TheRoundsGoOnFromThere) {
  step(StepUnit::Flood, 2);
  const FloodMoment moment = momentOf(*session_.results());
  const Document document = session_.document();
  step(StepUnit::Flood);
  const auto next = session_.results();
  session_.restore(document, moment);
  step(StepUnit::Flood);
  EXPECT_EQ(session_.results()->segmentation->label, next->segmentation->label);
}

TEST_P(Restore, OfWhatComesAfterTheLabelsFloodsNothing) {
  session_.openSample("torus", 1000);
  session_.waitIdle();
  session_.setAutoUnwrap(true);
  step(StepUnit::Converged);
  const auto before = session_.results();
  const Document document = session_.document();
  Document other = document;
  other.parameters.margin += 3;
  session_.setDocument(other);
  session_.waitIdle();
  session_.restore(document, momentOf(*before));
  session_.waitIdle();
  const auto after = session_.results();
  EXPECT_EQ(after->record, before->record);
  EXPECT_EQ(after->history.size(), before->history.size());
  EXPECT_EQ(after->unwrap, before->unwrap) << "only packed anew";
  EXPECT_TRUE(after->flat);
  EXPECT_EQ(after->parameters, document.parameters);
}

TEST_P(Restore, ChartsAreLaidFlatAgain) {
  session_.openSample("torus", 1000);
  session_.waitIdle();
  session_.setAutoUnwrap(true);
  step(StepUnit::Converged);
  const auto before = session_.results();
  ASSERT_TRUE(before->flat);
  const Document document = session_.document();
  Document other = document;
  other.parameters.charts = 12;
  session_.setDocument(other);
  session_.waitIdle();
  session_.restore(document, momentOf(*before));
  session_.waitIdle();
  EXPECT_TRUE(session_.results()->flat);
  EXPECT_EQ(session_.results()->charts->charts.size(), before->charts->charts.size());
}

class RestoreFast : public Restore {};
INSTANTIATE_TEST_SUITE_P(Workers, RestoreFast,
                         testing::Values(std::tuple(Session::Worker::Inline, "fast")));

TEST_P(RestoreFast, ARoundAroundTheSeams) {
  while (momentOf(*session_.results()).start.fast.value_or(FastFlood{}).band.empty()) {
    step(StepUnit::Flood);
    ASSERT_FALSE(session_.results()->finished);
  }
  expectSameAfter([](Document& d) { d.parameters.charts = 12; });
  step(StepUnit::Face, 3000);
  expectSameAfter([](Document& d) { d.parameters.speedPower = 2; });
  // A lock begins again where the flood stands.
  const auto before = session_.results();
  Document locked = session_.document();
  for (const Index face : before->start.seeds)
    locked.seeds.push_back({face, face == before->start.seeds[3]});
  session_.setDocument(locked);
  session_.waitIdle();
  step(StepUnit::Face, 1);
  EXPECT_EQ(session_.results()->record->size(), before->record->size() + 1);
  EXPECT_EQ(session_.results()->start.fast, before->start.fast);
}

TEST_P(Restore, WithoutChartsTheDocumentAloneIsTaken) {
  Document document = session_.document();
  document.parameters.charts = 9;
  session_.restore(document, {});
  session_.waitIdle();
  EXPECT_FALSE(session_.results()->segmentation);
  step(StepUnit::Flood);
  EXPECT_EQ(session_.results()->segmentation->chartCount, 9u);
}

TEST_P(Restore, StaleChartsHaveNoMoment) {
  step(StepUnit::Flood);
  Document document = session_.document();
  document.parameters.charts = 9;
  session_.setDocument(document, Session::Answer::Nothing);
  session_.waitIdle();
  EXPECT_TRUE(momentOf(*session_.results()).start.seeds.empty());
}

}  // namespace
}  // namespace chartflood
