// The legend of the colours: opened from the bar in the picture, each colour mode with its own,
// kept by a session.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/files/session_legend.h"
#include "app/host/files/session_view.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

class LegendEditor : public ::testing::Test {
 protected:
  LegendEditor() {
    ui.openFlooded("sphere", 500);
    run("color-mode balance");
    ui.frames(3);
  }
  bool run(const std::string& line) { return ui.state().perform(ui.actions(), line); }
  RenderSettings& render() { return ui.state().view.render; }

  HeadlessFrame ui;
};

TEST_F(LegendEditor, AClickOnTheBarOpensItAndEscClosesIt) {
  EXPECT_FALSE(ui.has("legend-editor"));
  ui.click("legend");
  ui.frames(2);
  ASSERT_TRUE(ui.has("legend-editor"));
  const ProbedItem editor = ui.item("legend-editor");
  EXPECT_GE(editor.min.x, 0);
  EXPECT_GE(editor.min.y, 0);
  EXPECT_LE(editor.max.x, ui.item("legend").min.x);
  ui.key("Esc");
  ui.frames(2);
  EXPECT_FALSE(ui.has("legend-editor"));
  ui.key("Shift+B");
  ui.frames(2);
  EXPECT_TRUE(ui.has("legend-editor"));
}

TEST_F(LegendEditor, ModesWithoutValuesHaveNone) {
  run("color-mode charts");
  ui.frames(2);
  EXPECT_FALSE(ui.has("legend"));
  EXPECT_FALSE(run("legend"));
  EXPECT_FALSE(run("legend-range 0 1"));
  run("color-mode gauss");
  EXPECT_FALSE(run("legend-range 0 1"));  // each kind of element has a range of its own
  EXPECT_TRUE(run("legend-steps 5"));
}

TEST_F(LegendEditor, EveryControlChangesTheColours) {
  run("legend on");
  ui.frames(3);
  EXPECT_FALSE(render().range);
  ui.click("legend/fixed");
  ui.frames(2);
  ASSERT_TRUE(render().range);
  EXPECT_DOUBLE_EQ(render().range->first, -render().range->second);
  ui.click("legend/low");
  ui.type("-5");
  ui.enter();
  EXPECT_DOUBLE_EQ(render().range->first, -5);
  ui.click("legend/auto");
  EXPECT_FALSE(render().range);
  ui.frames(2);
  ui.click("legend-scale root");
  EXPECT_EQ(render().scale, ScalarScale::Root);
  ui.drag("legend/steps", 0.0f, 0.4f);
  EXPECT_EQ(render().colorSteps, 7);
  ui.click("invert-colors");
  EXPECT_TRUE(render().invertColorMap);
  ui.click("legend-clamp");
  EXPECT_FALSE(render().clampColors);
  ui.click("legend/colormap");
  ui.frames(2);
  ui.click("legend/colormap cividis");
  EXPECT_EQ(render().colorMap, "cividis");
  ui.frames(2);
  ui.click("legend-reset");
  EXPECT_EQ(presentLegend(render()), LegendChoice{});
}

TEST_F(LegendEditor, WhatMakesNoSenseIsRefused) {
  EXPECT_FALSE(run("legend-range 2 1"));
  EXPECT_FALSE(run("legend-range 2"));
  EXPECT_FALSE(run("legend-range auto 3"));
  EXPECT_FALSE(run("legend-range low high"));
  EXPECT_FALSE(run("legend-range nan 1"));
  EXPECT_FALSE(run("legend-steps 1"));
  EXPECT_FALSE(run("legend-steps 99"));
  EXPECT_FALSE(run("legend-scale log"));  // balance lies on both sides of 0
  EXPECT_EQ(presentLegend(render()), LegendChoice{});
}

TEST_F(LegendEditor, EachModeKeepsItsOwn) {
  run("legend-range -20 20");
  run("colormap paper");
  run("color-mode flood-time");
  EXPECT_EQ(presentLegend(render()), LegendChoice{});
  run("legend-steps 4");
  run("color-mode balance");
  EXPECT_EQ(render().colorMap, "paper");
  EXPECT_EQ(render().range, std::make_pair(-20.0, 20.0));
  EXPECT_EQ(render().colorSteps, 0);
  ui.key("5");
  EXPECT_EQ(render().colorSteps, 4);
}

TEST_F(LegendEditor, ASessionBringsAllOfThemBack) {
  run("legend-range -20 20.5");
  run("legend-clamp off");
  run("color-mode flood-order");
  run("colormap magma");
  run("invert-colors on");
  const SessionView values = viewValues(ui.state().view);
  ViewSettings read;
  EXPECT_TRUE(applyViewValues(values, read).empty());
  EXPECT_EQ(read.legends, ui.state().view.legends);
  EXPECT_EQ(presentLegend(read.render), presentLegend(render()));
  EXPECT_FALSE(applyLegends("balance steps=1000", read));
  EXPECT_FALSE(applyLegends("nonsense invert", read));
  EXPECT_EQ(read.legends, ui.state().view.legends);
}

}  // namespace
}  // namespace chartflood
