// Pictures of the views, drawn without a window.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/gui/views/picture_taker.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/chart_swap.h"
#include "app/host/script/action_registry.h"
#include "render/gl/offscreen_context.h"
#include "render/scene/image.h"
#include "tests/support/temporary_folder.h"

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
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "picture.png";
    EXPECT_TRUE(state.perform(actions, "screenshot " + how + " file=" + file.string()));
    {
      PictureTaker taker([] {});
      taker.update(state, scene, 1);
    }  // waits for the file
    return readPng(file);
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
};

TEST_F(PictureTakerTest, ALinkStaysALink) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("real.png", folder / "link.png");
  ASSERT_TRUE(state.perform(actions, "screenshot view=3d file=" + (folder / "link.png").string()));
  {
    PictureTaker taker([] {});
    taker.update(state, scene, 1);
  }  // waits for the file
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
  EXPECT_EQ(readPng(folder / "real.png").width(), 160);
}

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

TEST_F(PictureTakerTest, SidesHaveTheirOwnProblemsMarked) {
  state.openSample("cube", 300);
  settle();
  run("set charts 2");
  run("store A");
  run("set charts 40");
  const Image plain = picture("view=ab");
  run("problems on");
  const Image marked = picture("view=ab");
  EXPECT_NE(columns(marked, 0, 80), columns(plain, 0, 80));
  run("use A");
  run("store B");
  // Both sides are the same now, one of them as the live state has it.
  const Image alike = picture("view=ab");
  EXPECT_EQ(columns(alike, 0, 80), columns(marked, 0, 80));
  EXPECT_EQ(columns(alike, 80, 160), columns(marked, 0, 80));
}

TEST_F(PictureTakerTest, SwappedColoursAreShownAndStay) {
  const Image before = picture("view=3d");
  state.view.chartColors = live.chartColorNumbers(state);
  Index chart = 0;
  while (colorPartners(state, chart).empty()) ++chart;
  const Index other = colorPartners(state, chart)[0];
  const std::vector<Index> first = state.view.chartColors;
  const std::string line = "swap-colors " + std::to_string(chart) + ' ' + std::to_string(other);
  run(line);
  EXPECT_TRUE(live.chartColorNumbers(state).empty()) << "they are not drawn yet";
  EXPECT_NE(picture("view=3d"), before);
  EXPECT_EQ(live.chartColorNumbers(state), state.view.chartColors);
  EXPECT_NE(state.view.chartColors, first);
  run(line);
  EXPECT_EQ(picture("view=3d"), before);
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

/// Rows of pictures, one a pass of the window.
class PictureRowTest : public PictureTakerTest {
 protected:
  PictureRowTest() { state.preferences.picture.folder = folder.path().string(); }
  /// Passes until the row has ended, 1000 at most.
  void pass(int most = 1000) {
    for (int i = 0; i < most; ++i) {
      taker.update(state, scene, 1);
      if (!state.pictureRow.running() && state.requests.pictures.empty()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  std::vector<std::filesystem::path> files(const std::string& name) {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path() / name)) {
      found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  TemporaryFolder folder;
  PictureTaker taker{[] {}};
};

TEST_F(PictureRowTest, ATurntableIsAWholeTurn) {
  const Image start = picture("view=3d");
  const Camera before = state.view.camera;
  run("turntable 4");
  pass();
  const auto pictures = files("sphere_turntable");
  ASSERT_EQ(pictures.size(), 4u);
  EXPECT_EQ(pictures[0].filename(), "sphere_turntable_001.png");
  EXPECT_EQ(readPng(pictures[0]), start);
  EXPECT_NE(readPng(pictures[1]), start);
  EXPECT_NE(readPng(pictures[2]), readPng(pictures[1]));
  EXPECT_EQ(state.view.camera, before);
}

TEST_F(PictureRowTest, AFilmEndsWithTheCharts) {
  const Image end = picture("view=3d");
  run("flood-film 3");
  pass();
  const auto pictures = files("sphere_flood");
  ASSERT_EQ(pictures.size(), 3u);
  EXPECT_NE(readPng(pictures[0]), readPng(pictures[1]));
  EXPECT_NE(readPng(pictures[1]), end);
  EXPECT_EQ(readPng(pictures[2]), end);
}

TEST_F(PictureRowTest, AnotherRowGetsAFolderOfItsOwn) {
  for (int i = 0; i < 2; ++i) {
    run("turntable 2");
    pass();
  }
  EXPECT_EQ(files("sphere_turntable").size(), 2u);
  EXPECT_EQ(files("sphere_turntable_2").size(), 2u);
}

TEST_F(PictureRowTest, StopEndsTheRowAndKeepsWhatIsThere) {
  run("turntable 500");
  pass(5);
  ASSERT_TRUE(state.pictureRow.running());
  run("stop");
  pass();
  EXPECT_FALSE(state.pictureRow.running());
  EXPECT_LT(files("sphere_turntable").size(), 20u);
}

TEST_F(PictureRowTest, OtherChartsEndTheRow) {
  run("turntable 500");
  pass(5);
  run("set charts 3");
  pass();
  EXPECT_FALSE(state.pictureRow.running());
  EXPECT_LT(files("sphere_turntable").size(), 20u);
}

TEST_F(PictureRowTest, ASecondRowIsRefusedMeanwhile) {
  run("turntable 500");
  pass(3);
  EXPECT_FALSE(state.perform(actions, "flood-film"));
  run("stop-pictures");
  pass();
}

}  // namespace

}  // namespace chartflood
