// The UV tab: it and the 3D view point at and select the same things.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

/// Chart 0 with face 7 fills the left half of a picture, chart 3 with face 40 the right.
template <typename Base>
class Halves : public Base {
 public:
  Pick half(int x) const {
    Pick pick;
    pick.triangle = pick.face = 2 * x < width ? 7 : 40;
    pick.chart = 2 * x < width ? 0 : 3;
    return pick;
  }
  void note(const AppState& state, int pictureWidth) {
    width = pictureWidth;
    hovered = state.hoveredFace;
    selected = state.selectedChart;
  }
  int width = 1;
  Index hovered = kNone, selected = kNone;  ///< in the last picture
};

class FakeScene : public Halves<SceneSource> {
 public:
  ImTextureID picture(const AppState& state, int w, int, float, bool) override {
    note(state, w);
    return nullptr;
  }
  Pick pick(int x, int) override { return half(x); }
};

class FakeUv : public Halves<UvSource> {
 public:
  bool ready(const AppState&) const override { return flat; }
  UvPicture picture(const AppState& state, int w, int h, float, UvMotion moving) override {
    note(state, w);
    settings = uvSettings(state, 1);
    motion = moving;
    return {nullptr, state.view.uvCamera, w, h};
  }
  Pick pick(const AppState&, int x, int) override { return half(x); }
  const UvHighlight& highlight(const AppState& state) override {
    hovered = state.hoveredFace;
    return nothing;
  }
  bool flat = true;
  UvMotion motion = UvMotion::None;
  RenderSettings settings;
  UvHighlight nothing;
};

class UvPanel : public ::testing::Test {
 protected:
  void SetUp() override {
    ui.sceneSource = &scene;
    ui.uvSource = &uv;
    ui.openFlooded("sphere", 500);
    ui.frames(3);
  }
  ImVec2 inside(const char* label, float x, float y) const {
    const ProbedItem item = ui.item(label);
    return {item.min.x + x * (item.max.x - item.min.x), item.min.y + y * (item.max.y - item.min.y)};
  }
  glm::dvec2 size() const {
    const ProbedItem item = ui.item("uv");
    return {item.max.x - item.min.x, item.max.y - item.min.y};
  }
  void clickAt(ImVec2 place) {
    ui.moveTo(place);
    ui.press();
    ui.release();
    ui.frames(30);  // no double click
  }
  HeadlessFrame ui;
  FakeScene scene;
  FakeUv uv;
};

TEST_F(UvPanel, IsTheFirstTab) { EXPECT_TRUE(ui.has("uv")); }

TEST_F(UvPanel, PointingInTheTextureLightsTheModel) {
  ui.moveTo(inside("uv", 0.8f, 0.5f));
  ui.frames(2);
  EXPECT_EQ(ui.state().hoveredFace, 40u);
  EXPECT_EQ(scene.hovered, 40u);
  EXPECT_EQ(uv.hovered, 40u);
  ui.frames(5);
  EXPECT_EQ(scene.hovered, 40u) << "a resting mouse goes on pointing";
}

TEST_F(UvPanel, PointingAtTheModelLightsTheTexture) {
  ui.moveTo(inside("uv", 0.8f, 0.5f));
  ui.moveTo(inside("view", 0.2f, 0.5f));
  ui.frames(2);
  EXPECT_EQ(uv.hovered, 7u);
  ui.moveTo(inside("view", 0.8f, 0.5f));
  ui.frames(2);
  EXPECT_EQ(uv.hovered, 40u);
}

TEST_F(UvPanel, LeavingBothPointsAtNothing) {
  ui.moveTo(inside("uv", 0.2f, 0.5f));
  ui.moveTo(ui.item("scrubber").center());
  ui.frames(2);
  EXPECT_EQ(ui.state().hoveredFace, kNone);
}

TEST_F(UvPanel, ClickSelectsInBothViews) {
  clickAt(inside("uv", 0.8f, 0.5f));
  EXPECT_EQ(ui.state().selectedChart, 3u);
  EXPECT_EQ(scene.selected, 3u);
  EXPECT_EQ(uv.settings.selectedCharts, std::vector<Index>{3});
  clickAt(inside("view", 0.2f, 0.5f));
  EXPECT_EQ(ui.state().selectedChart, 0u);
  EXPECT_EQ(uv.selected, 0u);
}

TEST_F(UvPanel, TheWheelKeepsThePlaceUnderTheMouse) {
  const ImVec2 between = inside("uv", 0.3f, 0.7f);
  const ImVec2 place{std::floor(between.x), std::floor(between.y)};  // mice have whole pixels
  const ProbedItem item = ui.item("uv");
  const glm::dvec2 pixel(place.x - item.min.x, place.y - item.min.y);
  ui.moveTo(place);
  const UvCamera before = ui.state().view.uvCamera;
  ui.wheel(3);
  ui.wheel(0);
  const UvCamera& after = ui.state().view.uvCamera;
  EXPECT_LT(after.span, 0.7 * before.span);
  EXPECT_NEAR(glm::distance(after.toUv(pixel, size()), before.toUv(pixel, size())), 0, 1e-6);
  EXPECT_EQ(ui.state().selectedChart, kNone);
  EXPECT_EQ(uv.motion, UvMotion::Own);
  ui.frames(15);
  EXPECT_EQ(uv.motion, UvMotion::None);
}

TEST_F(UvPanel, DragMovesAndDoesNotSelect) {
  for (const int button : {0, 2}) {
    const glm::dvec2 before = ui.state().view.uvCamera.center;
    ui.moveTo(inside("uv", 0.4f, 0.5f));
    ui.press(button);
    ui.moveTo(inside("uv", 0.5f, 0.5f));
    ui.moveTo(inside("uv", 0.6f, 0.5f));
    ui.release(button);
    ui.frames(30);
    EXPECT_LT(ui.state().view.uvCamera.center.x, before.x - 0.05) << button;
    EXPECT_EQ(ui.state().selectedChart, kNone);
  }
}

TEST_F(UvPanel, FAndDoubleClickShowTheWholeTexture) {
  const auto zoomIn = [&] {
    ui.moveTo(inside("uv", 0.3f, 0.7f));
    ui.wheel(4);
    ui.wheel(0);
    ASSERT_NE(ui.state().view.uvCamera, UvCamera::whole());
  };
  zoomIn();
  ui.key("F");
  EXPECT_EQ(ui.state().view.uvCamera, UvCamera::whole());
  zoomIn();
  for (int i = 0; i < 2; ++i) {
    ui.press();
    ui.release();
  }
  EXPECT_EQ(ui.state().view.uvCamera, UvCamera::whole());
  // Over the model the same key leaves the texture alone.
  zoomIn();
  ui.moveTo(inside("view", 0.5f, 0.5f));
  ui.frames(1);
  ui.key("F");
  EXPECT_NE(ui.state().view.uvCamera, UvCamera::whole());
}

TEST_F(UvPanel, IsolateShowsTheSelectedChartAloneAndFollowsIt) {
  clickAt(inside("uv", 0.8f, 0.5f));
  ui.key("I");
  ui.frames(2);
  const auto hides = [&](Index chart) {
    const std::vector<Index>& hidden = uv.settings.hiddenCharts;
    return std::find(hidden.begin(), hidden.end(), chart) != hidden.end();
  };
  EXPECT_FALSE(hides(3));
  EXPECT_TRUE(hides(4));
  EXPECT_TRUE(hides(0));
  EXPECT_EQ(sceneSettings(ui.state(), 1).hiddenCharts, uv.settings.hiddenCharts);
  ui.key("]");
  ui.frames(2);
  EXPECT_TRUE(hides(3));
  EXPECT_FALSE(hides(4));
  ui.key("I");
  ui.frames(2);
  EXPECT_TRUE(uv.settings.hiddenCharts.empty());
}

TEST_F(UvPanel, HasTheModelsColoursAndItsOwnNumbers) {
  ui.key("9");
  ui.frames(2);
  EXPECT_EQ(uv.settings.colorMode, ColorMode::Checkerboard);
  EXPECT_TRUE(uv.settings.numbers);
  EXPECT_FALSE(uv.settings.scalarBar);
}

TEST_F(UvPanel, SaysWhatIsMissingBeforeAnUnwrap) {
  uv.flat = false;
  ui.frames(3);
  EXPECT_FALSE(ui.has("uv"));
  const bool canUnwrap = ui.actions().find("unwrap") != nullptr;
  EXPECT_EQ(ui.has("unwrap"), canUnwrap);
}

TEST_F(UvPanel, OtherTabsTakeItsPlace) {
  ui.moveTo(inside("uv", 0.2f, 0.5f));
  ui.state().perform(ui.actions(), "right-tab charts");
  ui.frames(3);
  EXPECT_FALSE(ui.has("uv"));
  EXPECT_EQ(ui.state().hoveredFace, kNone);
  ui.state().perform(ui.actions(), "right-tab uv");
  ui.frames(3);
  EXPECT_TRUE(ui.has("uv"));
}

TEST(TextureRows, SetTheCheckerboard) {
  HeadlessFrame ui({1280, 1500});
  ui.drag("checker-size", 0.2f, 1.0f);
  EXPECT_EQ(ui.state().view.render.checkerSquares, 256);
  ui.ctrlClick("checker-size");
  ui.type("77");
  ui.enter();
  EXPECT_EQ(ui.state().view.render.checkerSquares, 77);
  ui.click("checker-kind");
  ui.frames(2);
  ui.click("checker-kind circles");
  EXPECT_EQ(ui.state().view.render.checkerKind, CheckerKind::Circles);
  ui.click("checker-tint");
  EXPECT_EQ(ui.state().view.render.checkerTint, 0);
  ui.click("checker-in-texture");
  EXPECT_TRUE(ui.state().view.render.checkerInTexture);
  ui.click("cuts");
  EXPECT_FALSE(ui.state().view.render.cuts);
  ui.click("uv-fill");
  EXPECT_FALSE(ui.state().view.uv.fill);
}

TEST(TextureRows, RefuseWhatCannotBe) {
  HeadlessFrame ui;
  EXPECT_FALSE(ui.state().perform(ui.actions(), "checker-size 0"));
  EXPECT_FALSE(ui.state().perform(ui.actions(), "checker-kind stars"));
  EXPECT_FALSE(ui.state().perform(ui.actions(), "isolate"));
  EXPECT_EQ(ui.state().view.render.checkerSquares, RenderSettings{}.checkerSquares);
}

TEST(TextureKeys, ChooseTheModesAndQGoesRoundTheKinds) {
  HeadlessFrame ui;
  const std::pair<const char*, ColorMode> kKeys[] = {{"6", ColorMode::Stretch},
                                                     {"7", ColorMode::AreaDistortion},
                                                     {"8", ColorMode::AngleDistortion},
                                                     {"9", ColorMode::Checkerboard}};
  for (const auto& [key, mode] : kKeys) {
    ui.key(key);
    EXPECT_EQ(ui.state().view.render.colorMode, mode);
  }
  ui.key("Q");
  EXPECT_EQ(ui.state().view.render.checkerKind, CheckerKind::Numbers);
  ui.key("Q");
  ui.key("Q");
  EXPECT_EQ(ui.state().view.render.checkerKind, CheckerKind::Squares);
}

}  // namespace
}  // namespace chartflood
