// What undo and session files keep makes the same charts again, whatever the method.

#include <gtest/gtest.h>

#include "core/session/session.h"

namespace chartflood {
namespace {

class MethodRestore : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    Document document;
    document.parameters.method = GetParam();
    document.parameters.charts = 9;
    session_.setDocument(document);
    session_.openSample("bumps", 3000);
  }
  void expectSameAfterOtherWork() {
    const auto before = session_.results();
    const Document document = session_.document();
    const FloodMoment moment = momentOf(*before);
    Document other = document;
    other.parameters.method = "t-flooding";
    session_.setDocument(other);
    EXPECT_NE(session_.results()->segmentation->label, before->segmentation->label);
    session_.restore(document, moment);
    const auto after = session_.results();
    EXPECT_EQ(after->segmentation->label, before->segmentation->label);
    EXPECT_EQ(after->finished, before->finished);
    EXPECT_EQ(momentOf(*after), moment);
  }
  Session session_{Session::Worker::Inline};
};
INSTANTIATE_TEST_SUITE_P(Methods, MethodRestore, testing::Values("vsa", "mcgim"));

TEST_P(MethodRestore, FinishedCharts) {
  session_.step(StepUnit::Converged);
  EXPECT_EQ(session_.results()->segmentation->chartCount, 9u);
  expectSameAfterOtherWork();
}

TEST_P(MethodRestore, ARoundOnTheWayAndAPartOfIt) {
  session_.step(StepUnit::Flood, 4);
  EXPECT_LT(session_.results()->segmentation->chartCount, 9u);
  expectSameAfterOtherWork();
  session_.step(StepUnit::Face, 500);
  expectSameAfterOtherWork();
}

TEST_P(MethodRestore, TheRoundsGoOnToAllCharts) {
  session_.step(StepUnit::Flood, 3);
  session_.restore(session_.document(), momentOf(*session_.results()));
  session_.step(StepUnit::Converged);
  EXPECT_EQ(session_.results()->segmentation->chartCount, 9u);
}

}  // namespace
}  // namespace chartflood
