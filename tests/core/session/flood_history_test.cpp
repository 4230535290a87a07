#include "core/session/pipeline/flood_history.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "core/session/session.h"

namespace chartflood {
namespace {

constexpr std::size_t kFaces = 100;
constexpr std::size_t kBytes = kFaces * sizeof(Incorporation);

std::shared_ptr<const FloodRecord> log() { return std::make_shared<FloodRecord>(kFaces); }

TEST(FloodHistory, DropsTheOldestButNeverTheFirstTheBestNorTheNewest) {
  FloodHistory history(5 * kBytes);
  for (std::size_t round = 0; round < 20; ++round) {
    history.keep(round, log(), std::min<std::size_t>(round, 7));
    EXPECT_LE(history.bytes(), 5 * kBytes);
  }
  for (std::size_t round = 0; round < 20; ++round) {
    const bool stays = round == 0 || round == 7 || round >= 17;
    EXPECT_EQ(history.records()[round] != nullptr, stays) << round;
  }
}

TEST(FloodHistory, KeepsTheRoundThatIsLookedAt) {
  FloodHistory history(4 * kBytes);
  for (std::size_t round = 0; round < 10; ++round) history.keep(round, log(), 1);
  history.recall(4, log());
  EXPECT_NE(history.records()[4], nullptr);
  EXPECT_LE(history.bytes(), 4 * kBytes);
  for (std::size_t round = 10; round < 20; ++round) history.keep(round, log(), 1);
  EXPECT_NE(history.records()[4], nullptr);
  history.recall(6, log());
  EXPECT_EQ(history.records()[4], nullptr);
}

TEST(FloodHistory, ALogThatReplacesAnotherIsCountedOnce) {
  FloodHistory history;
  history.keep(0, log(), 0);
  history.keep(0, log(), 0);
  EXPECT_EQ(history.bytes(), kBytes);
  history.clear();
  EXPECT_EQ(history.bytes(), 0u);
}

/// A short run on a small sample.
class Rounds : public ::testing::Test {
 protected:
  void SetUp() override {
    Document document;
    document.parameters.charts = 6;
    document.parameters.maxIterations = 5;
    session_.setDocument(document);
    session_.openSample("rocket", 800);
  }
  Session session_{Session::Worker::Inline};
};

TEST_F(Rounds, EachHasItsWholeLog) {
  session_.step(StepUnit::Converged);
  const auto results = session_.results();
  ASSERT_GE(results->history.size(), 2u);
  ASSERT_EQ(results->floods.size(), results->history.size());
  for (std::size_t round = 0; round < results->floods.size(); ++round) {
    const auto& flood = results->floods[round];
    ASSERT_NE(flood, nullptr);
    EXPECT_EQ(flood->size(), results->mesh->faceCount());
    EXPECT_EQ((*flood)[0].face, results->history[round].seeds[(*flood)[0].chart]);
  }
  EXPECT_EQ(results->record, results->floods[results->bestIteration]);
}

TEST_F(Rounds, AnAdoptedRoundHasTheSameLog) {
  session_.step(StepUnit::Iteration, 3);
  const auto before = session_.results();
  session_.adoptIteration(0);
  const auto after = session_.results();
  EXPECT_EQ(after->floods.size(), before->floods.size());
  ASSERT_EQ(after->floods[0], after->record);
  for (std::size_t i = 0; i < after->record->size(); ++i) {
    ASSERT_EQ((*after->floods[0])[i].face, (*before->floods[0])[i].face);
    ASSERT_EQ((*after->floods[0])[i].chart, (*before->floods[0])[i].chart);
  }
}

TEST_F(Rounds, RecallingOneLeavesTheStateAlone) {
  session_.step(StepUnit::Iteration, 2);
  session_.step(StepUnit::Face, 100);
  const auto before = session_.results();
  session_.recallRound(0);
  const auto after = session_.results();
  EXPECT_EQ(after->record, before->record);
  EXPECT_EQ(after->segmentation, before->segmentation);
  ASSERT_NE(after->floods[0], nullptr);
}

TEST_F(Rounds, AFloodBegunAgainEndsAsANewRound) {
  session_.step(StepUnit::Flood);
  session_.resetFlood();
  const std::size_t rounds = session_.results()->history.size();
  session_.step(StepUnit::Flood);
  const auto results = session_.results();
  EXPECT_EQ(results->history.size(), rounds + 1);
  EXPECT_EQ(results->recordIteration, rounds);
  EXPECT_EQ(results->floods[rounds], results->record);
  EXPECT_NE(results->floods[rounds - 1], nullptr);
  EXPECT_NE(results->floods[rounds - 1], results->record);
}

TEST_F(Rounds, TheLastOneIsKeptWhereThatIsWished) {
  Document document = session_.document();
  document.parameters.keep = "last";
  document.parameters.refine = "none";
  session_.setDocument(document);
  session_.step(StepUnit::Converged);
  const auto results = session_.results();
  ASSERT_TRUE(results->finished);
  EXPECT_EQ(results->recordIteration + 1, results->history.size());
  EXPECT_NE(results->bestIteration, results->recordIteration) << "choose a run that gets worse";
  std::vector<Index> label(results->mesh->faceCount());
  const FloodRecord& last = *results->floods.back();
  for (std::size_t i = 0; i < last.size(); ++i) label[last[i].face] = last[i].chart;
  EXPECT_EQ(results->segmentation->label, label);
}

}  // namespace
}  // namespace chartflood
