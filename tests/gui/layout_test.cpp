// Nothing is cut off: at the smallest window and all sizes of the interface each widget lies
// within what can be seen of its panel, and widgets of one line do not overlap.

#include <gtest/gtest.h>

#include "core/session/settings/parameters.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

struct Screen {
  float width, height, scale;
};

std::ostream& operator<<(std::ostream& stream, const Screen& screen) {
  return stream << screen.width << "x" << screen.height << " at " << screen.scale;
}

class Layout : public ::testing::TestWithParam<Screen> {
 protected:
  HeadlessFrame ui{{GetParam().width * GetParam().scale, GetParam().height* GetParam().scale},
                   GetParam().scale};
};

TEST_P(Layout, BarsAreWhole) {
  for (const char* label : {"first", "back", "play", "step", "finish", "iteration", "run", "stop",
                            "speed", "color-mode", "screenshot", "rounds", "scrubber", "view"}) {
    EXPECT_TRUE(ui.item(label).whole()) << label;
  }
}

TEST_P(Layout, ToolsDoNotOverlap) {
  const char* const kOrder[] = {"first", "back", "play",  "step",       "finish",    "iteration",
                                "run",   "stop", "speed", "color-mode", "screenshot"};
  for (std::size_t i = 1; i < std::size(kOrder); ++i) {
    EXPECT_LE(ui.item(kOrder[i - 1]).max.x, ui.item(kOrder[i]).min.x + 0.5f) << kOrder[i];
  }
}

TEST_P(Layout, ParameterRowsAreWholeInWidth) {
  for (const ParameterInfo& info : parameterTable()) {
    if (!ui.has(std::string("label/") + info.id)) continue;  // in a folded section
    const ProbedItem control = ui.item(info.id);
    const ProbedItem label = ui.item(std::string("label/") + info.id);
    EXPECT_GE(label.min.x, label.clipMin.x) << info.id;
    EXPECT_LE(control.max.x, control.clipMax.x + 0.5f) << info.id;
    EXPECT_LE(label.max.x, control.min.x + 0.5f) << info.id;
  }
}

TEST_P(Layout, SwitchesOfOneLineDoNotOverlap) {
  const char* const kPairs[][2] = {
      {"seams", "cuts"},       {"seeds", "numbers"},        {"edges", "sharp-edges"},
      {"color-bar", "smooth"}, {"orthographic", "isolate"}, {"checker-in-texture", "checker-tint"},
      {"uv-fill", "uv-frame"}};
  for (const auto& [left, right] : kPairs) {
    EXPECT_LE(ui.item(left).max.x, ui.item(right).min.x + 0.5f) << left;
    EXPECT_LE(ui.item(right).max.x, ui.item(right).clipMax.x + 0.5f) << right;
  }
}

TEST_P(Layout, TheViewKeepsRoom) {
  const ProbedItem view = ui.item("view");
  EXPECT_GT(view.max.x - view.min.x, 240 * GetParam().scale);
  EXPECT_GT(view.max.y - view.min.y, 240 * GetParam().scale);
}

TEST_P(Layout, TargetsAreLargeEnough) {
  for (const char* label : {"first", "play", "charts", "explore on", "color-mode"}) {
    const ProbedItem item = ui.item(label);
    EXPECT_GE(item.max.y - item.min.y, 22 * GetParam().scale) << label;
  }
}

TEST_P(Layout, ToastsStayInTheView) {
  ui.state().notices.add(Notice::Kind::Warning,
                         "3 separate parts: each gets at least one chart, so K was raised to 3.");
  ui.frames(3);
  const ProbedItem toast = ui.item("toast 0"), view = ui.item("view");
  EXPECT_GE(toast.min.x, view.min.x);
  EXPECT_LE(toast.max.x, view.max.x);
}

/// Noted as a whole, with the border that their own content does not see.
bool isFrame(std::string_view label) {
  for (const char* frame : {"toast ", "chart/", "column/", "action-palette", "legend-editor",
                            "Preferences", "Keys", "Log", "About"}) {
    if (label.starts_with(frame)) return true;
  }
  return false;
}

/// Every widget that can be seen lies in the width of its panel, and in the height of those that do
/// not scroll; all lie in the window.
void expectWhole(HeadlessFrame& ui, const std::string& where) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  for (const auto& [label, item] : ui.frame().probe().items()) {
    if (!item.visible) continue;
    EXPECT_GE(item.min.x, -3) << label << " in " << where;
    EXPECT_LE(item.max.x, screen.x + 3) << label << " in " << where;
    if (!item.scrolls) {
      EXPECT_GE(item.min.y, -3) << label << " in " << where;
      EXPECT_LE(item.max.y, screen.y + 3) << label << " in " << where;
    }
    if (isFrame(label)) continue;
    if (!item.scrolls) {
      EXPECT_GE(item.min.y, item.clipMin.y - 1) << label << " in " << where;
      EXPECT_LE(item.max.y, item.clipMax.y + 1) << label << " in " << where;
    }
    EXPECT_GE(item.min.x, item.clipMin.x - 1) << label << " in " << where;
    EXPECT_LE(item.max.x, item.clipMax.x + 1) << label << " in " << where;
  }
}

TEST_P(Layout, EveryWidgetIsWholeInEveryTab) {
  if (GetParam().width < 1024) GTEST_SKIP() << "three columns need 1024 pixels";
  ui.openFlooded("sphere", 300);
  for (const char* tab : {"uv", "charts", "sphere", "plots"}) {
    ui.state().perform(ui.actions(), std::string("right-tab ") + tab);
    ui.frames(3);
    expectWhole(ui, tab);
  }
}

TEST_P(Layout, WhatFloatsOverTheViewIsWhole) {
  if (GetParam().width < 1024) GTEST_SKIP() << "three columns need 1024 pixels";
  ui.openFlooded("cube", 300);
  for (const char* line :
       {"set start flood", "color-mode balance", "legend on", "problems on", "tool seeds"}) {
    ui.state().perform(ui.actions(), line);
  }
  ui.frames(4);
  ASSERT_TRUE(ui.has("legend-editor"));
  ASSERT_TRUE(ui.has("key/show-problem open-sharp-edges"));
  expectWhole(ui, "the view");
}

TEST_P(Layout, EveryWidgetIsWholeInEveryWindow) {
  for (const char* window : {"find-action", "preferences", "keys", "log", "about", "name-preset"}) {
    ui.state().perform(ui.actions(), window);
    ui.frames(4);
    expectWhole(ui, window);
    const std::string close = std::string(window) == "name-preset" ? "close-naming" : window;
    ui.state().perform(ui.actions(), close);
    ui.frames(3);
  }
}

TEST_P(Layout, ThemesDoNotMoveAnything) {
  const ProbedItem before = ui.item("charts");
  for (const ThemeInfo& theme : themeTable()) {
    ui.state().perform(ui.actions(), std::string("theme ") + theme.id);
    ui.frames(2);
    EXPECT_EQ(ui.item("charts").min.x, before.min.x) << theme.id;
    EXPECT_EQ(ui.item("charts").max.y, before.max.y) << theme.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Layout,
                         ::testing::Values(Screen{1024, 640, 1}, Screen{1280, 800, 1},
                                           Screen{1024, 640, 0.75f}, Screen{1024, 640, 1.5f},
                                           Screen{1024, 640, 2.5f}, Screen{1920, 1080, 1.25f},
                                           Screen{700, 460, 1}),
                         [](const auto& sized) {
                           return std::to_string(static_cast<int>(sized.param.width)) + "at" +
                                  std::to_string(static_cast<int>(100 * sized.param.scale));
                         });

}  // namespace
}  // namespace chartflood
