// The preview in the dialog of pictures, and pictures of the window itself.

#include <chrono>
#include <cstddef>
#include <thread>
#include <vector>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "app/gui/views/picture_preview.h"
#include "app/gui/widgets/imgui_gl.h"
#include "app/host/actions/actions.h"
#include "app/host/script/action_registry.h"
#include "render/gl/offscreen_context.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {

namespace {

constexpr int kWidth = 160, kHeight = 120;

class PicturePreviewTest : public ::testing::Test {
 protected:
  PicturePreviewTest() {
    state.openSample("sphere", 300);
    state.playback.setSpeed(2 * Playback::kFastest);
    settle();
    state.panels.viewWidth = 2 * kWidth;
    state.panels.viewHeight = 2 * kHeight;
  }
  void settle() {
    for (int i = 0; i < 8; ++i) state.update(1.0 / 60);
  }
  void run(std::string_view line) {
    ASSERT_TRUE(state.perform(actions, line)) << line;
    settle();
  }
  std::vector<PreviewPart> ask() {
    return preview.preview(state, wantedExtent(state, state.preferences.picture), kWidth, kHeight,
                           1);
  }
  /// Until it shows the newest.
  void finish() {
    for (int i = 0; i < 5000; ++i) {
      ask();
      while (preview.busy()) preview.goOn();
      if (preview.upToDate()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // it rests between two pictures
    }
    ADD_FAILURE() << "never up to date";
  }
  /// What the dialog would show.
  Image shown() {
    finish();
    Image image(kWidth, kHeight);
    for (const PreviewPart& part : ask()) {
      const auto name = static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(part.texture));
      glBindTexture(GL_TEXTURE_2D, name);
      GLint width = 0, height = 0;
      glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
      glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
      Image drawn(width, height);
      glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, &drawn.at(0, 0));
      const int left = static_cast<int>(part.left * kWidth + 0.5f);
      const int right = static_cast<int>(part.right * kWidth + 0.5f);
      const int from = static_cast<int>(part.from * static_cast<float>(width) + 0.5f);
      for (int y = 0; y < kHeight; ++y) {
        for (int x = left; x < right; ++x) {
          image.at(x, y) = drawn.at(from + x - left, height - 1 - y);
        }
      }
    }
    return image;
  }
  /// The picture itself at the preview's size.
  Image wanted() {
    PictureRequest request;
    request.settings = state.preferences.picture;
    const PictureExtent extent = wantedExtent(state, request.settings);
    const float scale = extent.scale * kWidth / static_cast<float>(extent.width);
    return drawPieces(picturePieces(state, scene, request, kWidth, kHeight, scale), kWidth, kHeight,
                      2);
  }
  /// The same but for the smoothing of edges; more of them where small letters stand.
  void expectLike(const Image& one, const Image& other, bool letters = false) {
    ASSERT_EQ(one.width(), other.width());
    const ImageDifference difference = compareImages(one, other, 60);
    EXPECT_LT(difference.differentPixels, one.pixels().size() / (letters ? 15 : 50));
    EXPECT_LT(difference.mean, letters ? 10 : 3);
  }

  std::unique_ptr<gl::Context> context =
      gl::createOffscreenContext(gl::offscreenBackendFromId("auto"));
  gl::CurrentScope current{*context};
  AppState state{Session::Worker::Inline};
  ActionRegistry actions = makeActionRegistry();
  SceneView live{[] {}};
  CompareScene scene{live, [] {}};
  UvView uv{live};
  PicturePreview preview{scene, uv};
};

TEST_F(PicturePreviewTest, ShowsThePictureAsItWillBe) {
  expectLike(shown(), wanted());
  for (const char* option : {"picture-set ground white", "picture-set seams off",
                             "picture-set seeds off", "picture-set size square"}) {
    run(option);
    expectLike(shown(), wanted());
  }
  EXPECT_EQ(shown().at(0, 0), (Rgba8{255, 255, 255, 255}));
}

TEST_F(PicturePreviewTest, FollowsTheModel) {
  const Image before = shown();
  run("set charts 4");
  const Image after = shown();
  EXPECT_NE(before, after);
  expectLike(after, wanted());
}

TEST_F(PicturePreviewTest, PutsModelAndTextureTogether) {
  run("unwrap");
  for (int i = 0; i < 5000 && !live.renderer().hasUv(); ++i) {
    live.prepare(state);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  run("picture-set view both");
  expectLike(shown(), wanted(), true);
  run("picture-set view uv");
  expectLike(shown(), wanted(), true);
}

TEST_F(PicturePreviewTest, PutsTheHalvesOfAComparisonTogether) {
  run("store A");
  run("set charts 4");
  run("picture-set view ab");
  expectLike(shown(), wanted());
  run("wipe on");
  run("wipe-at 0.25");
  expectLike(shown(), wanted());
}

TEST_F(PicturePreviewTest, DrawsNothingWhileNothingChanges) {
  finish();
  for (int i = 0; i < 5; ++i) {
    ask();
    EXPECT_TRUE(preview.upToDate());
    EXPECT_FALSE(preview.busy());
  }
}

TEST_F(PicturePreviewTest, GivesWayToAViewAndComesAgain) {
  finish();
  run("set charts 4");
  ask();
  // A view takes the renderer over while the preview may be under way.
  const gl::Framebuffer elsewhere(64, 64, 1);
  live.renderer().beginDrawing(elsewhere, state.view.camera, sceneSettings(state, 1),
                               PicturePart::whole(64, 64));
  preview.goOn();
  EXPECT_FALSE(preview.busy());
  EXPECT_TRUE(live.renderer().drawing(elsewhere)) << "it was pushed aside";
  while (!live.renderer().continueDrawing(1)) {
  }
  expectLike(shown(), wanted());
}

/// The interface, drawn as the window draws it.
class WindowPictureTest : public ::testing::Test {
 protected:
  WindowPictureTest() {
    drawer.uploadFonts();
    window.openFlooded("sphere", 300);
    window.state().panels.firstCard = false;
    window.moveTo({5, 790});
  }
  void run(std::string_view line) {
    EXPECT_TRUE(window.state().perform(window.actions(), line)) << line;
    window.frames(4);
  }
  Image picture() { return windowImage(drawer, *ImGui::GetDrawData()); }

  std::unique_ptr<gl::Context> context =
      gl::createOffscreenContext(gl::offscreenBackendFromId("auto"));
  gl::CurrentScope current{*context};
  HeadlessFrame window;
  ImguiGl drawer;
};

TEST_F(WindowPictureTest, ShowsThePanelsWithoutTheDialogThatTakesIt) {
  window.frames(3);
  const Image before = picture();
  EXPECT_EQ(before.width(), 1280);
  EXPECT_EQ(before.height(), 800);
  EXPECT_EQ(before.at(3, 3)[3], 255);
  run("picture-dialog on");
  ASSERT_TRUE(window.has("picture/preview"));
  EXPECT_EQ(compareImages(before, picture()).differentPixels, 0u);
  run("left-pane off");
  EXPECT_GT(compareImages(before, picture()).differentPixels, 10'000u);
}

TEST_F(WindowPictureTest, IsAsLargeAsTheWindow) {
  run("picture-set view window");
  const PictureExtent extent = wantedExtent(window.state(), window.state().preferences.picture);
  EXPECT_EQ(extent.width, 1280);
  EXPECT_EQ(extent.height, 800);
}

}  // namespace

}  // namespace chartflood
