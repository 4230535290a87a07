// The search for actions: what a few letters find, and its use by the keyboard alone.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/actions/action_search.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

std::string firstLine(HeadlessFrame& ui, const char* words) {
  const auto found = searchActions(ui.actions(), ui.state(), words);
  return found.empty() ? "" : found[0].line;
}

TEST(MatchScore, PrefersBeginningsAndRuns) {
  EXPECT_EQ(matchScore("xyz", "Frame all"), -1);
  EXPECT_GT(matchScore("fa", "Frame all"), matchScore("fa", "Default"));
  EXPECT_GT(matchScore("fram", "Frame all"), matchScore("fram", "Far from"));
  EXPECT_GT(matchScore("all frame", "Frame all"), 0);
  EXPECT_EQ(matchScore("", "Frame all"), 0);
}

TEST(SearchActions, FindsWhatIsMeant) {
  HeadlessFrame ui;
  EXPECT_EQ(firstLine(ui, "stretch"), "color-mode stretch");
  EXPECT_EQ(firstLine(ui, "theme light"), "theme light");
  EXPECT_EQ(firstLine(ui, "charts 30"), "set charts 30");
  EXPECT_EQ(firstLine(ui, "crease avoidance"), "show-parameter speed-power");
  EXPECT_EQ(firstLine(ui, "unwrap circle"), "set unwrap circle");
  EXPECT_EQ(firstLine(ui, "frame all"), "frame-all");
  EXPECT_TRUE(searchActions(ui.actions(), ui.state(), "qqqqq").empty());
}

TEST(SearchActions, RefusesValuesThatAParameterDoesNotTake) {
  HeadlessFrame ui;
  for (const FoundAction& found : searchActions(ui.actions(), ui.state(), "charts 0")) {
    EXPECT_NE(found.line, "set charts 0");
  }
}

TEST(SearchActions, EveryActionCanBeFoundByItsTitle) {
  HeadlessFrame ui;
  for (const FoundAction& entry : searchActions(ui.actions(), ui.state(), "")) {
    const auto found = searchActions(ui.actions(), ui.state(), entry.title);
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const FoundAction& each) {
      return each.line == entry.line;
    })) << entry.title;
  }
}

TEST(SearchActions, WhatWasDoneLastComesFirst) {
  HeadlessFrame ui;
  ui.state().perform(ui.actions(), "theme light");
  EXPECT_EQ(firstLine(ui, ""), "theme light");
}

TEST(SearchActions, SaysWhySomethingCannotBeDone) {
  HeadlessFrame ui;
  const auto found = searchActions(ui.actions(), ui.state(), "undo");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].line, "undo");
  EXPECT_THAT(found[0].reason, HasSubstr("nothing to undo"));
}

TEST(ActionPalette, SetsAParameterByKeysAlone) {
  HeadlessFrame ui;
  ui.key("Ctrl+P");
  ui.frames(3);
  ASSERT_TRUE(ui.has("action-palette"));
  ui.type("charts 30");
  ui.enter();
  EXPECT_EQ(ui.state().document().parameters.charts, 30);
  ui.frames(2);
  EXPECT_FALSE(ui.has("action-palette"));
  ui.key("4");  // single keys act again
  EXPECT_EQ(ui.state().view.render.colorMode, ColorMode::Balance);
}

TEST(ActionPalette, ArrowsChooseAndEscapeCloses) {
  HeadlessFrame ui;
  ui.key("Ctrl+Shift+P");
  ui.frames(3);
  ui.type("theme");
  ui.frames(1);
  const auto found = searchActions(ui.actions(), ui.state(), "theme");
  ui.arrow(ImGuiKey_DownArrow);
  ui.enter();
  EXPECT_EQ(ui.lastLine(), found[1].line);
  ui.key("Ctrl+P");
  ui.frames(3);
  ui.escape();
  EXPECT_FALSE(ui.state().panels.search);
}

TEST(ActionPalette, JumpsToARowInAFoldedSection) {
  HeadlessFrame ui;
  ASSERT_FALSE(ui.has("patience"));
  ui.key("Ctrl+P");
  ui.frames(3);
  ui.type("patience");
  ui.enter();
  ui.frames(4);
  const ProbedItem row = ui.item("patience");
  EXPECT_TRUE(row.whole());
}

}  // namespace
}  // namespace chartflood
