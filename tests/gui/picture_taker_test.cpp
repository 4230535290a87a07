// Pictures of the views, drawn without a window.

#include <filesystem>

#include <gtest/gtest.h>

#include "app/gui/picture_taker.h"
#include "app/host/action_registry.h"
#include "render/gl/offscreen_context.h"
#include "render/image.h"

namespace chartflood {

namespace {

class PictureTakerTest : public ::testing::Test {
 protected:
  PictureTakerTest() {
    state.openSample("sphere", 300);
    state.playback.setSpeed(2 * Playback::kFastest);
    settle();
    state.panels.viewWidth = 160;
    state.panels.viewHeight = 120;
    state.preferences.picture.smooth = 1;
  }
  void settle() {
    for (int i = 0; i < 8; ++i) state.update(1.0 / 60);
  }
  void run(std::string_view line) {
    ASSERT_TRUE(state.perform(actions, line)) << line;
    settle();
  }
  Image picture(const std::string& how) {
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) /
                                       ("chartflood-picture-" + std::to_string(++count) + ".png");
    EXPECT_TRUE(state.perform(actions, "screenshot " + how + " file=" + file.string()));
    {
      PictureTaker taker([] {});
      taker.update(state, scene, 1);
    }  // waits for the file
    const Image image = readPng(file);
    std::filesystem::remove(file);
    return image;
  }
  static Image columns(const Image& image, int from, int to) {
    Image part(to - from, image.height());
    for (int y = 0; y < image.height(); ++y) {
      for (int x = from; x < to; ++x) part.at(x - from, y) = image.at(x, y);
    }
    return part;
  }

  std::unique_ptr<gl::Context> context =
      gl::createOffscreenContext(gl::offscreenBackendFromId("auto"));
  gl::CurrentScope current{*context};
  AppState state{Session::Worker::Inline};
  ActionRegistry actions = makeActionRegistry();
  SceneView live{[] {}};
  CompareScene scene{live, [] {}};
  int count = 0;
};

TEST_F(PictureTakerTest, AWipeShowsAOnTheLeftAndTheLiveStateOnTheRight) {
  const Image a = picture("view=3d");
  run("store A");
  run("set charts 5");
  const Image now = picture("view=3d");
  ASSERT_NE(a, now);
  run("wipe on");
  run("wipe-at 0.25");
  const Image wiped = picture("view=ab");
  EXPECT_EQ(columns(wiped, 0, 40), columns(a, 0, 40));
  EXPECT_EQ(columns(wiped, 40, 160), columns(now, 40, 160));
}

TEST_F(PictureTakerTest, SidesTakeEqualParts) {
  run("store A");
  const Image sides = picture("view=ab");
  EXPECT_EQ(sides.width(), 160);
  // The same state twice, seen by the same camera.
  EXPECT_EQ(columns(sides, 0, 80), columns(sides, 80, 160));
}

TEST_F(PictureTakerTest, ATransparentGroundHasNoAlpha) {
  state.preferences.picture.ground = "transparent";
  run("color-mode shaded");
  run("seams off");
  run("seeds off");
  const Image image = picture("view=3d");
  EXPECT_EQ(image.at(0, 0)[3], 0);
  std::size_t solid = 0;
  for (const Rgba8& p : image.pixels()) {
    if (p[3] == 255) ++solid;
  }
  EXPECT_GT(solid, 100u);
}

TEST_F(PictureTakerTest, TwiceTheSizeIsTwiceThePixels) {
  const Image image = picture("view=3d scale=2");
  EXPECT_EQ(image.width(), 320);
  EXPECT_EQ(image.height(), 240);
}

}  // namespace

}  // namespace chartflood
