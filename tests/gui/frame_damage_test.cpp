// What of the window is drawn again: nothing that stays, everything that changes.

#include "app/gui/widgets/frame_damage.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gui/widgets/imgui_gl.h"
#include "render/gl/framebuffer.h"
#include "render/gl/offscreen_context.h"
#include "render/passes/offscreen_render.h"
#include "render/scene/image.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr PixelRectangle kWindow{0, 0, 1280, 800};

long pixelsOf(const std::vector<PixelRectangle>& parts) {
  long sum = 0;
  for (const PixelRectangle& part : parts) {
    sum += long{part.right - part.left} * (part.bottom - part.top);
  }
  return sum;
}

bool holds(const std::vector<PixelRectangle>& parts, float x, float y) {
  return std::any_of(parts.begin(), parts.end(), [&](const PixelRectangle& part) {
    return float(part.left) <= x && x < float(part.right) && float(part.top) <= y &&
           y < float(part.bottom);
  });
}

/// A 3D view that shows one texture under changing identities.
class OneTexture : public SceneSource {
 public:
  ImTextureID picture(const AppState&, int, int, float, bool) override {
    return textureId(7, content);
  }
  Pick pick(int, int) override { return {}; }
  std::uint32_t content = 1;
};

class FrameDamageTest : public ::testing::Test {
 protected:
  FrameDamageTest() {
    window.openFlooded("sphere", 300);
    window.state().panels.firstCard = false;
    window.moveTo({5, 790});
    window.frames(3);
  }
  std::vector<PixelRectangle> changed() { return damage.changed(*ImGui::GetDrawData()); }

  HeadlessFrame window;
  FrameDamage damage;
};

TEST_F(FrameDamageTest, BeginsWithTheWholeWindow) { EXPECT_THAT(changed(), ElementsAre(kWindow)); }

TEST_F(FrameDamageTest, IsNothingWhileNothingChanges) {
  changed();
  window.frames(1);
  EXPECT_THAT(changed(), IsEmpty());
}

TEST_F(FrameDamageTest, IsTheWholeWindowWhenItIsForgotten) {
  changed();
  damage.forget();
  EXPECT_THAT(changed(), ElementsAre(kWindow));
}

TEST_F(FrameDamageTest, IsTheWholeWindowAtAnotherSize) {
  changed();
  ImDrawData larger = *ImGui::GetDrawData();
  larger.FramebufferScale = {2, 2};
  EXPECT_THAT(damage.changed(larger), ElementsAre(PixelRectangle{0, 0, 2560, 1600}));
}

TEST_F(FrameDamageTest, HoldsAHoveredSliderAndLittleElse) {
  changed();
  const ImVec2 middle = window.item("charts").center();
  window.moveTo(middle);
  window.frames(2);
  const auto parts = changed();
  EXPECT_TRUE(holds(parts, middle.x, middle.y));
  EXPECT_LT(pixelsOf(parts), pixelsOf({kWindow}) / 5);
}

TEST_F(FrameDamageTest, IsTheViewWhenItsTextureShowsSomethingElse) {
  OneTexture source;
  window.setSource(&source);
  window.frames(2);
  changed();
  window.frames(1);
  EXPECT_THAT(changed(), IsEmpty());
  ++source.content;
  window.frames(1);
  const auto parts = changed();
  const ProbedItem view = window.item("view");
  for (const float x : {view.min.x + 1, view.max.x - 1}) {
    for (const float y : {view.min.y + 1, view.max.y - 1}) EXPECT_TRUE(holds(parts, x, y));
  }
  EXPECT_FALSE(holds(parts, 5, 5)) << "the menu stays";
}

/// The same window, drawn as a whole and by its changes.
class DrawnByPartsTest : public FrameDamageTest {
 protected:
  DrawnByPartsTest() {
    drawer.uploadFonts();
    window.frames(2);
  }
  void drawParts() {
    canvas.bindForDrawing();
    drawer.draw(*ImGui::GetDrawData(), changed());
  }
  Image drawnByParts() { return readFramebuffer(canvas); }
  Image drawnWhole() {
    const gl::Framebuffer target(1280, 800, 1);
    target.bindForDrawing();
    drawer.draw(*ImGui::GetDrawData());
    return readFramebuffer(target);
  }

  std::unique_ptr<gl::Context> context =
      gl::createOffscreenContext(gl::offscreenBackendFromId("auto"));
  gl::CurrentScope current{*context};
  gl::Framebuffer canvas{1280, 800, 1};
  ImguiGl drawer;
};

TEST_F(DrawnByPartsTest, LooksAsDrawnWholeAfterEveryStep) {
  drawParts();
  EXPECT_EQ(compareImages(drawnByParts(), drawnWhole()).differentPixels, 0u);
  const auto step = [&](const char* what, auto&& act) {
    act();
    window.frames(1);
    drawParts();
    EXPECT_EQ(compareImages(drawnByParts(), drawnWhole()).differentPixels, 0u) << what;
  };
  const auto does = [&](const char* line) {
    EXPECT_TRUE(window.state().perform(window.actions(), line)) << line;
  };
  step("a hovered slider", [&] { window.moveTo(window.item("charts").min); });
  step("a dragged slider", [&] { window.drag("charts", 0.5f, 0.7f); });
  step("a menu", [&] { window.click("menu/File"); });
  step("no menu", [&] { window.escape(); });
  step("a wheel over a panel", [&] {
    window.moveTo({100, 400});
    window.wheel(-3);
  });
  step("another theme", [&] { does("theme light"); });
  step("a bar less", [&] { does("left-pane off"); });
  step("a window", [&] { does("about on"); });
  step("a window less", [&] { does("about off"); });
}

}  // namespace

}  // namespace chartflood
