// Comparing: what the slots hold, which halves there are, and the mouse in each.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/state/compare_look.h"
#include "tests/gui/headless_frame.h"
#include "tests/gui/pointer_source.h"

namespace chartflood {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CompareTest : public ::testing::Test {
 protected:
  CompareTest() {
    window.setSource(&source);
    window.openFlooded("sphere", 400);
  }
  bool run(std::string_view line) {
    const bool done = window.state().perform(window.actions(), line);
    window.frames(3);
    return done;
  }
  Compare& compare() { return window.state().compare; }
  std::vector<Index> labels() { return window.state().results().segmentation->label; }

  HeadlessFrame window;
  PointerSource source;
};

TEST_F(CompareTest, WithAAloneTheRightSideIsLive) {
  const auto kept = labels();
  ASSERT_TRUE(run("store A"));
  ASSERT_TRUE(run("set charts 5"));
  EXPECT_THAT(compare().panes(), ElementsAre(ComparePane{0}, ComparePane{}));
  EXPECT_EQ(compare().stored[0].results->segmentation->label, kept);
  EXPECT_NE(labels(), kept);
  EXPECT_TRUE(window.has("view/A"));
  EXPECT_TRUE(window.has("view/Live"));
  EXPECT_FALSE(window.has("view"));
}

TEST_F(CompareTest, TwoAndThreeStoredTakeTheWholeView) {
  run("store A");
  run("store B");
  EXPECT_THAT(compare().panes(), ElementsAre(ComparePane{0}, ComparePane{1}));
  run("store C");
  EXPECT_EQ(compare().panes().size(), 3u);
  EXPECT_TRUE(window.item("view/C").whole());
  EXPECT_LE(window.item("view/A").max.x, window.item("view/B").min.x);
  EXPECT_LE(window.item("view/B").max.x, window.item("view/C").min.x);
  run("wipe on");
  EXPECT_EQ(compare().panes().size(), 2u);
}

TEST_F(CompareTest, UseBringsTheLabelsBackAndCanBeUndone) {
  run("store A");
  const Document before = window.state().document();
  const auto kept = labels();
  run("set charts 5");
  window.frames(5);
  const auto other = labels();
  ASSERT_TRUE(run("use A"));
  EXPECT_EQ(labels(), kept);
  EXPECT_EQ(window.state().document(), before);
  ASSERT_TRUE(run("undo"));
  EXPECT_EQ(labels(), other);
  EXPECT_EQ(window.state().document().parameters.charts, 5);
}

TEST_F(CompareTest, SwapChangesSidesOnly) {
  run("store A");
  run("set charts 5");
  EXPECT_FALSE(run("swap")) << "there is no B yet";
  run("store B");
  const auto a = compare().stored[0].results, b = compare().stored[1].results;
  window.key("X");
  EXPECT_EQ(compare().stored[0].results, b);
  EXPECT_EQ(compare().stored[1].results, a);
  EXPECT_EQ(compare().stored[0].name, "A");
}

TEST_F(CompareTest, FiguresSayWhatDiffers) {
  run("store A");
  run("set speed-power 3");
  const PaneCaption a = paneCaption(window.state(), {0}), live = paneCaption(window.state(), {});
  EXPECT_EQ(a.method, "t-flooding");
  EXPECT_THAT(a.differing, ElementsAre(HasSubstr("p 1")));
  EXPECT_THAT(live.differing, ElementsAre(HasSubstr("p 3")));
  EXPECT_THAT(a.figures, ElementsAre("K 20", HasSubstr("spread"), HasSubstr("seams")));
  EXPECT_TRUE(a.problems.empty());
}

TEST_F(CompareTest, ChartsLaidFlatLaterBringTheirStretch) {
  run("set unwrap circle");
  run("set cut-tips off");
  run("store A");
  EXPECT_FALSE(compare().stored[0].figures.stretch.has_value());
  run("unwrap");
  window.frames(3);
  ASSERT_TRUE(compare().stored[0].figures.stretch.has_value());
  EXPECT_GE(*compare().stored[0].figures.stretch, 1.0);
}

TEST_F(CompareTest, AClickSelectsInTheHalfWhereItWasMade) {
  run("store A");
  window.frames(3);
  window.click("view/A");
  EXPECT_THAT(window.lastLine(), HasSubstr("select-stored A"));
  EXPECT_EQ(window.state().selectedChart, kNone);
  window.moveTo(window.item("view/Live").center());
  EXPECT_TRUE(compare().underMouse.live());
  EXPECT_NE(window.state().hoveredFace, kNone);
}

TEST_F(CompareTest, UnlinkedCamerasTurnAlone) {
  run("store A");
  run("link-cameras off");
  const Camera before = paneCamera(window.state(), {});
  window.drag("view/A", 0.3f, 0.6f);
  EXPECT_NE(paneCamera(window.state(), {0}), before);
  EXPECT_EQ(paneCamera(window.state(), {}), before);
  window.drag("view/Live", 0.3f, 0.6f);
  EXPECT_NE(paneCamera(window.state(), {}), before);
}

TEST_F(CompareTest, UnlinkedColoursBelongToTheHalfClickedLast) {
  run("store A");
  run("link-colors off");
  window.click("view/A");
  run("color-mode balance");
  EXPECT_EQ(paneLook(window.state(), {0}).colorMode, ColorMode::Balance);
  EXPECT_EQ(paneLook(window.state(), {}).colorMode, ColorMode::Charts);
}

TEST_F(CompareTest, TheWipeIsDraggedAndStaysInside) {
  run("store A");
  run("wipe on");
  const ProbedItem line = window.item("wipe-line");
  window.moveTo(line.center());
  window.press();
  window.moveTo({line.center().x + 5000, line.center().y});
  window.release();
  EXPECT_DOUBLE_EQ(compare().wipe, 0.98);
  EXPECT_FALSE(run("wipe-at 1.5"));
}

TEST_F(CompareTest, ClearShowsTheLiveStateAlone) {
  run("store A");
  ASSERT_TRUE(run("clear-compare"));
  EXPECT_TRUE(compare().stored.empty());
  EXPECT_TRUE(window.has("view"));
}

TEST(CommonRange, SpansAllScalesOfValues) {
  ScalarRange a, b, plain;
  a.min = 1, a.max = 2, b.min = 0.5, b.max = 1.5, plain.plainEnds = true;
  EXPECT_EQ(commonRange({a, std::nullopt, b, plain}), std::pair(0.5, 2.0));
  EXPECT_EQ(commonRange({plain}), std::nullopt);
}

}  // namespace

}  // namespace chartflood
