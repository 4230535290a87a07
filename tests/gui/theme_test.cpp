// Text can be read on every ground that it stands on, in every theme, and the window follows the
// choice at once.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "app/gui/panels/plot_widgets.h"
#include "app/gui/views/scene_view.h"
#include "render/scene/chart_palette.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

/// Relative luminance of WCAG 2.1.
double luminance(ImU32 color) {
  const auto channel = [&](int shift) {
    const double c = static_cast<double>((color >> shift) & 255u) / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(IM_COL32_R_SHIFT) + 0.7152 * channel(IM_COL32_G_SHIFT) +
         0.0722 * channel(IM_COL32_B_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

ImU32 packed(const glm::vec3& c) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1}); }

class Themes : public ::testing::TestWithParam<ThemeKind> {
 protected:
  const Palette& p = themePalette(GetParam());
  const double least = GetParam() == ThemeKind::HighContrast ? 7 : 4.5;
};

TEST_P(Themes, TextIsReadableOnEveryGround) {
  for (const ImU32 ground : {p.ground, p.panel, p.bar, p.popup, p.control, p.controlHovered,
                             p.controlActive, p.accentSoft}) {
    EXPECT_GE(contrast(p.text, ground), least) << std::hex << ground;
    EXPECT_GE(contrast(p.dim, ground), least) << std::hex << ground;
  }
}

TEST_P(Themes, SignalsAreReadableAsText) {
  for (const ImU32 ground : {p.panel, p.bar, p.popup}) {
    for (const ImU32 signal : {p.accent, p.front, p.good, p.warning, p.error}) {
      EXPECT_GE(contrast(signal, ground), least) << std::hex << signal << " on " << ground;
    }
  }
}

TEST_P(Themes, BarsOfChartsAreToldFromTheirGround) {
  for (const ChartPalette& palette : chartPaletteTable()) {
    for (const std::uint32_t rgb : palette.colors) {
      const ImU32 color = IM_COL32((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255, 255);
      const ImU32 shown = legibleOn(p.bar, color);
      EXPECT_GE(contrast(shown, p.bar), 2.95) << std::hex << rgb;
      const bool enough = contrast(color, p.bar) >= 3;
      EXPECT_EQ(shown == color, enough) << std::hex << rgb;
    }
  }
}

TEST_P(Themes, TextOverTheModelStandsOnItsVeil) {
  // The veil lets a part of what is behind it through: black and white are the worst.
  const double share = static_cast<double>(p.veil >> IM_COL32_A_SHIFT) / 255;
  for (const double behind : {0.0, 255.0}) {
    const auto mixed = [&](int shift) {
      const double own = static_cast<double>((p.veil >> shift) & 255u);
      return static_cast<int>(std::lround(share * own + (1 - share) * behind));
    };
    const ImU32 ground =
        IM_COL32(mixed(IM_COL32_R_SHIFT), mixed(IM_COL32_G_SHIFT), mixed(IM_COL32_B_SHIFT), 255);
    EXPECT_GE(contrast(p.text, ground), least) << behind;
  }
}

TEST_P(Themes, TheGroundBehindTheModelIsOfTheThemesKind) {
  const Background ground = themeGround(GetParam());
  for (const glm::vec3& part : {ground.bottom, ground.top}) {
    EXPECT_GE(contrast(p.text, packed(part)), least);
    EXPECT_GE(contrast(p.dim, packed(part)), least);
    for (const ImU32 axis : {p.axisX, p.axisY, p.axisZ}) {
      EXPECT_GE(contrast(axis, packed(part)), 3);  // graphics: WCAG 2.1, 1.4.11
    }
  }
}

TEST(HighContrast, ControlsAndPanelsHaveEdgesThatCanBeSeen) {
  HeadlessFrame ui;
  EXPECT_EQ(ImGui::GetStyle().FrameBorderSize, 0);
  ui.state().perform(ui.actions(), "theme high-contrast");
  ui.frames(2);
  EXPECT_GE(ImGui::GetStyle().FrameBorderSize, 1);
  EXPECT_GE(ImGui::GetStyle().WindowBorderSize, 1);
  const Palette& p = themePalette(ThemeKind::HighContrast);
  for (const ImU32 ground : {p.ground, p.panel, p.bar, p.popup, p.control}) {
    EXPECT_GE(contrast(p.line, ground), 3) << std::hex << ground;  // WCAG 2.1, 1.4.11
  }
}

INSTANTIATE_TEST_SUITE_P(All, Themes,
                         ::testing::Values(ThemeKind::Dark, ThemeKind::Light,
                                           ThemeKind::HighContrast));

TEST(Theme, TheWindowAndTheGroundFollowAtOnce) {
  HeadlessFrame ui;
  ui.state().perform(ui.actions(), "theme light");
  ui.frames(1);
  const ImVec4 text = ImGui::GetStyle().Colors[ImGuiCol_Text];
  EXPECT_EQ(ImGui::ColorConvertFloat4ToU32(text), themePalette(ThemeKind::Light).text);
  EXPECT_EQ(sceneSettings(ui.state(), 1).background, themeGround(ThemeKind::Light));
  ui.state().view.render.background = backgroundFromText("#102030");
  EXPECT_EQ(sceneSettings(ui.state(), 1).background, backgroundFromText("#102030"));
}

TEST(Theme, ASimulationSaysThatItIsOnAndLeavesPicturesAlone) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  const RenderSettings before = sceneSettings(ui.state(), 1);
  EXPECT_FALSE(ui.has("vision-badge"));
  ui.state().perform(ui.actions(), "simulate green");
  ui.frames(1);
  EXPECT_TRUE(ui.has("vision-badge"));
  EXPECT_EQ(sceneSettings(ui.state(), 1), before);
}

TEST(Preferences, ChoicesOfTheWindowAreActions) {
  HeadlessFrame ui;
  ui.key("Ctrl+,");
  ui.frames(2);
  ui.click("likes/Theme");
  ui.frames(2);
  ui.click("likes/theme high-contrast");
  EXPECT_EQ(ui.state().preferences.theme, ThemeKind::HighContrast);
  ui.click("invert-turn-x");
  EXPECT_TRUE(ui.state().preferences.invertTurnX);
  ui.escape();
  EXPECT_FALSE(ui.state().panels.preferences);
}

}  // namespace
}  // namespace chartflood
