// Cutting, unwrapping and packing as stages of a session: core/session/session.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/session/session.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

class UnwrapWith : public testing::TestWithParam<Session::Worker> {
 protected:
  Session session_{GetParam()};

  std::shared_ptr<const Results> results() {
    session_.waitIdle();
    return session_.results();
  }
  void segment(const char* sample, std::size_t triangles, int charts) {
    session_.openSample(sample, triangles);
    set([charts](Document& d) { d.parameters.charts = charts; });
    session_.step(StepUnit::Converged);
  }
  template <class Change>
  std::shared_ptr<const Results> set(Change change) {
    session_.waitIdle();
    Document document = session_.document();
    change(document);
    session_.setDocument(document);
    return results();
  }
  std::size_t count(Notice::Kind kind) {
    const std::vector<Notice> notices = session_.takeNotices();
    return static_cast<std::size_t>(std::count_if(notices.begin(), notices.end(),
                                                  [&](const Notice& n) { return n.kind == kind; }));
  }
};
INSTANTIATE_TEST_SUITE_P(Workers, UnwrapWith,
                         testing::Values(Session::Worker::Threaded, Session::Worker::Inline),
                         [](const auto& instance) {
                           return instance.param == Session::Worker::Inline ? "Inline" : "Threaded";
                         });

/// Finished charts outlive another patience; a margin after it is packed, and nothing else anew.
TEST_P(UnwrapWith, AMarginCountsBesideValuesOfRounds) {
  session_.setAutoUnwrap(true);
  segment("rocket", 2000, 8);
  const auto before = results();
  ASSERT_TRUE(before->flat);
  const auto after = set([](Document& d) { d.parameters.patience += 1; });
  EXPECT_EQ(after->atlas, before->atlas);
  const auto wider = set([](Document& d) { d.parameters.margin += 16; });
  EXPECT_TRUE(wider->flat);
  EXPECT_NE(wider->atlas, before->atlas);
  EXPECT_EQ(wider->unwrap, before->unwrap);
  EXPECT_EQ(wider->charts, before->charts);
  const auto tips = set([](Document& d) { d.parameters.tip = 0.3; });
  EXPECT_TRUE(tips->flat);
  EXPECT_NE(tips->charts, before->charts);
}

TEST_P(UnwrapWith, SaysWhereAMarginLeavesNoRoom) {
  session_.setAutoUnwrap(true);
  segment("torus", 2000, 5);
  results();
  session_.takeNotices();
  const auto flat = set([](Document& d) {
    d.parameters.textureSize = 256;
    d.parameters.margin = 200;
  });
  ASSERT_TRUE(flat->atlas);
  EXPECT_LT(flat->atlas->margin, 200);
  const std::string kept = std::to_string(flat->atlas->margin);
  std::vector<std::string> warnings;
  for (const Notice& notice : session_.takeNotices()) {
    if (notice.kind == Notice::Kind::Warning) warnings.push_back(notice.text);
  }
  EXPECT_EQ(warnings, std::vector<std::string>{
                          "A margin of 200 pixels leaves no room for 5 charts in a texture of 256 "
                          "pixels a side: they keep " +
                          kept + "; a texture of 1024 pixels keeps them all."});
}

TEST_P(UnwrapWith, LaysChartsFlatWhenAsked) {
  segment("torus", 2000, 5);
  EXPECT_FALSE(results()->flat);
  session_.unwrap();
  const auto flat = results();
  ASSERT_TRUE(flat->flat);
  ASSERT_EQ(flat->charts->charts.size(), 5u);
  ASSERT_EQ(flat->unwrap->charts.size(), 5u);
  ASSERT_EQ(flat->atlas->uv.size(), 5u);
  std::size_t triangles = 0;
  for (std::size_t c = 0; c < 5; ++c) {
    EXPECT_TRUE(flat->charts->charts[c].disk());
    EXPECT_EQ(flat->unwrap->charts[c].uv.size(), flat->charts->charts[c].surface.vertexCount());
    triangles += flat->charts->charts[c].surface.triangleCount();
  }
  EXPECT_EQ(triangles, flat->mesh->triangleCount());
  EXPECT_GT(flat->atlas->efficiency, 0.3);
  EXPECT_GE(flat->timing.cut, 0);
  EXPECT_GE(flat->timing.unwrap, 0);
  EXPECT_GE(flat->timing.pack, 0);
}

TEST_P(UnwrapWith, NeedsCompleteCharts) {
  session_.unwrap();
  session_.waitIdle();
  EXPECT_EQ(count(Notice::Kind::Error), 1u) << "without a model";
  session_.openSample("bumps", 2000);
  session_.step(StepUnit::Face, 100);
  session_.waitIdle();
  session_.takeNotices();
  session_.unwrap();
  session_.waitIdle();
  EXPECT_EQ(count(Notice::Kind::Error), 1u) << "with half a flood";
  EXPECT_FALSE(results()->atlas);
}

TEST_P(UnwrapWith, FollowsAStopRuleByItselfWhenToldTo) {
  session_.setAutoUnwrap(true);
  session_.openSample("bumps", 2000);
  session_.step(StepUnit::Flood);
  EXPECT_FALSE(results()->atlas) << "no stop rule has fired";
  session_.step(StepUnit::Converged);
  EXPECT_TRUE(results()->flat);
}

TEST_P(UnwrapWith, AChangeRecomputesTheStagesAfterItAlone) {
  session_.setAutoUnwrap(true);
  segment("torus", 2000, 4);
  const auto before = results();
  ASSERT_TRUE(before->flat);
  const auto margin = set([](Document& d) { d.parameters.margin = 32; });
  EXPECT_TRUE(margin->flat);
  EXPECT_EQ(margin->segmentation, before->segmentation);
  EXPECT_EQ(margin->unwrap, before->unwrap);
  EXPECT_NE(margin->atlas, before->atlas);
  EXPECT_EQ(margin->atlas->margin, 32);
  const auto circle = set([](Document& d) { d.parameters.unwrap = "circle"; });
  EXPECT_TRUE(circle->flat);
  EXPECT_EQ(circle->segmentation, before->segmentation);
  EXPECT_NE(circle->unwrap, margin->unwrap);
  EXPECT_NE(circle->stopReason, StopReason::NotStopped) << "the charts are still finished";
  const auto tip = set([](Document& d) { d.parameters.tip = 0.2; });
  EXPECT_NE(tip->charts, circle->charts);
  EXPECT_EQ(tip->segmentation, before->segmentation);
  const auto back = set([](Document& d) { d.parameters = Parameters{.charts = 4}; });
  EXPECT_EQ(back->atlas->uv, before->atlas->uv) << "equal parameters give equal bytes";
}

TEST_P(UnwrapWith, NewChartsMarkTheOldOnesStale) {
  segment("torus", 2000, 4);
  session_.unwrap();
  const auto before = results();
  session_.step(StepUnit::Flood);
  const auto after = results();
  EXPECT_EQ(after->atlas, before->atlas) << "the old ones stay visible";
  EXPECT_EQ(after->flat, after->segmentation->label == before->segmentation->label);
  session_.openSample("cube", 500);
  EXPECT_FALSE(results()->atlas);
  EXPECT_FALSE(results()->flat);
}

TEST_P(UnwrapWith, NamesChartsThatStayRound) {
  segment("torus", 2000, 1);
  set([](Document& d) { d.parameters.cutHandles = false; });
  session_.takeNotices();
  session_.unwrap();
  const auto flat = results();
  ASSERT_TRUE(flat->flat);
  EXPECT_TRUE(flat->unwrap->charts[0].uv.empty());
  EXPECT_FALSE(flat->unwrap->charts[0].problem.empty());
  EXPECT_EQ(count(Notice::Kind::Warning), 1u);
}

TEST(UnwrapThreaded, AnswersStopAndStartsOver) {
  Session session(Session::Worker::Threaded);
  session.openSample("rocket", 40000);
  session.step(StepUnit::Flood);
  session.waitIdle();
  session.unwrap();
  session.stop();
  session.waitIdle();
  session.unwrap();
  session.waitIdle();
  EXPECT_TRUE(session.results()->flat);
}

}  // namespace
}  // namespace chartflood
