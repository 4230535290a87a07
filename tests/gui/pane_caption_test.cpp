// What stands under the halves of a comparison: nothing of it is cut off.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gui/panels/pane_caption.h"
#include "app/host/state/compare_look.h"
#include "tests/gui/headless_frame.h"
#include "tests/gui/pointer_source.h"

namespace chartflood {

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

float letters(const std::string& text) { return static_cast<float>(text.size()); }

std::vector<std::string> flowed(const std::vector<std::string>& pieces, float width) {
  return flowedRows(pieces, width, letters);
}

TEST(FlowedRows, PiecesStayWholeWhileTheyFit) {
  EXPECT_THAT(flowed({"K 20", "spread 3 %", "seams 4"}, 40),
              ElementsAre("K 20   spread 3 %   seams 4"));
  EXPECT_THAT(flowed({"K 20", "spread 3 %", "seams 4"}, 17),
              ElementsAre("K 20   spread 3 %", "seams 4"));
  EXPECT_THAT(flowed({"K 20", "spread 3 %", "seams 4"}, 10),
              ElementsAre("K 20", "spread 3 %", "seams 4"));
}

TEST(FlowedRows, LongPiecesBreakBetweenWordsAndEndTheirRow) {
  EXPECT_THAT(flowed({"one", "two three four", "five"}, 9),
              ElementsAre("one", "two three", "four", "five"));
  EXPECT_THAT(flowed({"unbreakable"}, 4), ElementsAre("unbreakable"));
  EXPECT_THAT(flowed({}, 4), IsEmpty());
}

/// Everything said under a half can be read.
void expectLegible(const HeadlessFrame& window, const std::string& name) {
  const ProbedItem plate = window.item("caption/" + name);
  const auto inside = [&](const std::string& label) {
    const ProbedItem item = window.item(label);
    EXPECT_TRUE(item.whole()) << label;
    EXPECT_GE(item.min.x, plate.min.x) << label;
    EXPECT_LE(item.max.x, plate.max.x) << label;
    EXPECT_GE(item.min.y, plate.min.y) << label;
    EXPECT_LE(item.max.y, plate.max.y) << label;
  };
  inside("caption/" + name + "/method");
  int rows = 0;
  while (window.has("caption/" + name + "/" + std::to_string(rows))) {
    inside("caption/" + name + "/" + std::to_string(rows));
    ++rows;
  }
  EXPECT_GE(rows, 1);
  if (window.has("use " + name)) inside("use " + name);
}

/// The same for all halves, and no word under them is shortened.
void expectAllLegible(HeadlessFrame& window) {
  for (const ComparePane& pane : window.state().compare.panes()) {
    expectLegible(window, paneName(window.state().compare, pane));
  }
  const float below = window.item("view/A").max.y;
  for (const auto& [label, item] : window.frame().probe().items()) {
    if (!label.starts_with("cut/")) continue;
    EXPECT_LT(item.min.y, below) << label;
  }
}

struct WindowSize {
  ImVec2 size;
  float scale;
};

class PaneCaptionTest : public ::testing::TestWithParam<WindowSize> {
 protected:
  PaneCaptionTest() : window(GetParam().size, GetParam().scale) {
    window.setSource(&source);
    window.openFlooded("cube", 300);
    for (const char* line : {"set charts 3", "unwrap", "store A", "set speed-power 3",
                             "set cut-tips off", "store B", "set sharp-angle 30", "store C"}) {
      run(line);
    }
  }
  void run(const char* line) {
    EXPECT_TRUE(window.state().perform(window.actions(), line)) << line;
    window.frames(4);
  }
  HeadlessFrame window;
  PointerSource source;
};

TEST_P(PaneCaptionTest, ThreeSidesAreLegible) {
  expectAllLegible(window);
  run("right-pane");  // shown where it was hidden, and the other way round
  expectAllLegible(window);
}

TEST_P(PaneCaptionTest, SoAreTheirProblems) {
  run("problems on");
  ASSERT_FALSE(paneCaption(window.state(), {0}).problems.empty());
  expectAllLegible(window);
}

TEST_P(PaneCaptionTest, AWipesCaptionsShareTheWidth) {
  run("wipe on");
  expectAllLegible(window);
  EXPECT_LE(window.item("caption/A").max.x, window.item("caption/B").min.x);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PaneCaptionTest,
                         ::testing::Values(WindowSize{{1024, 640}, 1}, WindowSize{{1280, 800}, 1},
                                           WindowSize{{2560, 1440}, 2},
                                           WindowSize{{2560, 1600}, 2.5f}));

TEST(PaneCaption, StandsUnderAViewOfHalfTheHeightAtLeast) {
  HeadlessFrame window({640, 480});
  window.openFlooded("cube", 300);
  for (const char* line : {"store A", "store B", "store C", "problems on"}) {
    window.state().perform(window.actions(), line);
  }
  window.frames(4);
  const ProbedItem view = window.item("view/A"), plate = window.item("caption/A");
  EXPECT_GE(view.max.y - view.min.y, plate.max.y - plate.min.y);
  EXPECT_TRUE(window.item("use A").whole());
}

TEST(ProblemKey, NamesWhatAnyHalfHasWhileComparing) {
  HeadlessFrame window;
  window.openFlooded("cube", 300);
  const auto run = [&](const char* line) {
    EXPECT_TRUE(window.state().perform(window.actions(), line)) << line;
    window.frames(4);
  };
  run("set charts 2");
  run("store A");
  run("problems on");
  run("set charts 40");
  // Two charts leave creases of a cube uncut.
  const PaneCaption kept = paneCaption(window.state(), {0});
  ASSERT_FALSE(kept.problems.empty());
  EXPECT_THAT(kept.problems, ::testing::Contains(::testing::HasSubstr("inside")));
  EXPECT_TRUE(window.item("key/open-sharp-edges").whole());
}

}  // namespace

}  // namespace chartflood
