// Seeds placed by hand and their locks: core/session/document and what the session makes of them.

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/session.h"
#include "tests/support/segmentation_checks.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

using testing::Contains;
using testing::ElementsAre;
using Seeds = std::vector<PlacedSeed>;

TEST(Document, FewerSeedsDropTheNewestUnlocked) {
  Seeds seeds{{10}, {11, true}, {12}, {13, true}, {14}};
  dropNewestUnlocked(seeds, 4);
  EXPECT_EQ(seeds, (Seeds{{10}, {11, true}, {12}, {13, true}}));
  dropNewestUnlocked(seeds, 3);
  EXPECT_EQ(seeds, (Seeds{{10}, {11, true}, {13, true}}));
  dropNewestUnlocked(seeds, 1);
  EXPECT_EQ(seeds, (Seeds{{11, true}, {13, true}})) << "locked ones stay";
}

TEST(Document, SeedsFollowFewerChartsAndAnotherRoll) {
  const Document before{{}, {{1}, {2, true}, {3}}, {}};
  Document fewer = before;
  fewer.parameters.charts = 2;
  EXPECT_EQ(withFittingSeeds(before, fewer).seeds, (Seeds{{1}, {2, true}}));
  Document more = before;
  more.parameters.charts = 30;
  EXPECT_EQ(withFittingSeeds(before, more).seeds, before.seeds);
  Document rolled = before;
  rolled.parameters.rngSeed = 7;
  EXPECT_EQ(withFittingSeeds(before, rolled).seeds, (Seeds{{2, true}}));
}

TEST(Document, FacesOfTheFileAreFoundInTheMesh) {
  InputMesh input;
  input.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  input.corners = {0, 1, 2, 1, 1, 1, 0, 2, 3};  // the middle face is none and is dropped
  const auto mesh = test::rebuild(std::move(input));
  ASSERT_EQ(mesh->faceCount(), 2u);
  EXPECT_EQ(meshFace(*mesh, 0), 0u);
  EXPECT_EQ(meshFace(*mesh, 1), kNone);
  EXPECT_EQ(meshFace(*mesh, 2), 1u);
  EXPECT_EQ(meshFace(*mesh, 3), kNone);
}

class PlacedSeeds : public testing::Test {
 protected:
  void open(const char* sample, std::size_t triangles) {
    session_.openSample(sample, triangles);
    ASSERT_TRUE(session_.results()->mesh);
  }
  std::shared_ptr<const Results> after(StepUnit unit, std::size_t count = 1) {
    session_.step(unit, count);
    return session_.results();
  }
  void place(Seeds seeds) {
    Document document = session_.document();
    document.parameters.charts = static_cast<int>(seeds.size());
    document.seeds = std::move(seeds);
    session_.setDocument(document);
  }
  /// The present seeds, with locks on some.
  Seeds presentWithLocks(std::vector<std::size_t> locked) {
    Seeds seeds;
    for (const Index face : session_.results()->start.seeds) seeds.push_back({face});
    for (const std::size_t i : locked) seeds[i].locked = true;
    return seeds;
  }
  std::vector<Index> labels() { return session_.results()->segmentation->label; }

  Session session_{Session::Worker::Inline};
};

TEST_F(PlacedSeeds, LockedOnesStayInAllRounds) {
  open("rocket", 5000);
  place({{5, true}, {100}, {2000, true}, {3000}, {4000}});
  const auto results = after(StepUnit::Flood, 12);
  ASSERT_EQ(results->history.size(), 12u);
  std::size_t moved = 0;
  for (const IterationSummary& round : results->history) {
    EXPECT_EQ(round.seeds[0], 5u);
    EXPECT_EQ(round.seeds[2], 2000u);
    moved += round.movedSeeds;
  }
  EXPECT_GT(moved, 0u) << "the others move";
  const auto end = after(StepUnit::Converged);
  EXPECT_EQ(end->segmentation->seeds[0], 5u);
  EXPECT_EQ(end->segmentation->seeds[2], 2000u);
  test::expectValid(*end->mesh, *end->gaussArea, *end->segmentation);
}

TEST_F(PlacedSeeds, UnlockedOnesAreOnlyWhereTheRoundsBegin) {
  open("rocket", 5000);
  place({{5}, {100}, {2000}});
  const auto results = after(StepUnit::Flood, 5);
  EXPECT_THAT(results->history[0].seeds, ElementsAre(5, 100, 2000));
  EXPECT_NE(results->history[4].seeds, results->history[0].seeds);
}

TEST_F(PlacedSeeds, FewerChartsKeepLockedSeeds) {
  open("rocket", 5000);
  after(StepUnit::Flood);
  const std::vector<Index> all = session_.results()->start.seeds;
  place(presentWithLocks({18, 19}));
  Document document = session_.document();
  document.parameters.charts = 5;
  session_.setDocument(withFittingSeeds(session_.document(), document));
  EXPECT_THAT(session_.results()->start.seeds,
              ElementsAre(all[0], all[1], all[2], all[18], all[19]));
  document = session_.document();
  document.parameters.charts = 1;
  session_.setDocument(withFittingSeeds(session_.document(), document));
  EXPECT_THAT(session_.results()->start.seeds, ElementsAre(all[18], all[19]));
  bool said = false;
  for (const Notice& notice : session_.takeNotices()) {
    said = said || notice.text == "2 seeds are locked, so K was raised to 2.";
  }
  EXPECT_TRUE(said);
}

TEST_F(PlacedSeeds, FewerChartsLeaveMovedSeedsWhereTheRoundsTookThem) {
  open("rocket", 5000);
  after(StepUnit::Flood);
  place(presentWithLocks({}));
  const std::vector<Index> moved = after(StepUnit::Flood, 6)->start.seeds;
  Document document = session_.document();
  document.parameters.charts = 12;
  session_.setDocument(withFittingSeeds(session_.document(), document));
  const std::vector<Index> left(moved.begin(), moved.begin() + 12);
  EXPECT_EQ(session_.results()->start.seeds, left);
}

TEST_F(PlacedSeeds, LockingChangesNothingThatIsShown) {
  open("bumps", 5000);
  for (const StepUnit unit : {StepUnit::Flood, StepUnit::Converged}) {
    after(unit, 4);
    const auto before = session_.results();
    place(presentWithLocks({3}));
    const auto results = session_.results();
    EXPECT_EQ(results->segmentation->label, before->segmentation->label);
    EXPECT_EQ(results->history.size(), before->history.size());
    EXPECT_EQ(results->record, before->record) << "nothing was flooded again";
    EXPECT_EQ(results->placed, session_.document().seeds);
  }
}

TEST_F(PlacedSeeds, LaterLocksHoldFromTheNextRoundOn) {
  open("rocket", 5000);
  const auto before = after(StepUnit::Flood, 3);
  const std::vector<Index> label = before->segmentation->label;
  place(presentWithLocks({0, 1, 2, 3, 4, 5, 6, 7}));
  const std::vector<Index> locked(before->start.seeds.begin(), before->start.seeds.begin() + 8);
  const auto next = after(StepUnit::Flood, 4);
  for (const IterationSummary& round : next->history) {
    EXPECT_TRUE(std::equal(locked.begin(), locked.end(), round.seeds.begin()));
  }
  EXPECT_EQ(next->history[0].seeds, before->history[2].seeds) << "goes on from the round shown";
  EXPECT_EQ(after(StepUnit::Converged)->segmentation->seeds[7], locked[7]);
}

TEST_F(PlacedSeeds, AMovedSeedLeavesTheOthers) {
  open("rocket", 5000);
  after(StepUnit::Flood, 4);
  const auto before = session_.results();
  Seeds seeds = presentWithLocks({});
  const Index away = before->start.seeds[2] == 7 ? 8 : 7;
  seeds[2].face = away;
  place(seeds);
  const auto results = session_.results();
  std::vector<Index> expected = before->start.seeds;
  expected[2] = away;
  EXPECT_EQ(results->start.seeds, expected);
  EXPECT_EQ(results->start.offsets, before->start.offsets) << "the charts wait as they did";
  EXPECT_EQ(results->segmentation->label[away], 2u);
}

TEST_F(PlacedSeeds, TheEndOfADragThatDidNotFloodFloods) {
  open("rocket", 5000);
  after(StepUnit::Flood);
  Document document = session_.document();
  document.parameters.speedPower = 3;
  session_.setDocument(document, Session::Answer::Nothing);
  EXPECT_TRUE(session_.results()->stale);
  session_.setDocument(document, Session::Answer::Flood);
  EXPECT_FALSE(session_.results()->stale);
}

}  // namespace
}  // namespace chartflood
