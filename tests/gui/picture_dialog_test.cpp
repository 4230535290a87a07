// The dialog of pictures, what it asks for, and what is remembered.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/gui/views/picture_preview.h"
#include "app/host/settings/picture_settings.h"
#include "core/base/error.h"
#include "tests/gui/headless_frame.h"

namespace chartflood {

namespace {

TEST(PictureSettings, SizesKeepLinesInProportion) {
  PictureSettings settings;
  EXPECT_EQ(pictureExtent(settings, 640, 480).width, 640);
  settings.size = "window-2";
  const PictureExtent twice = pictureExtent(settings, 640, 480);
  EXPECT_EQ(twice.height, 960);
  EXPECT_FLOAT_EQ(twice.scale, 2);
  settings.size = "1080p";
  EXPECT_FLOAT_EQ(pictureExtent(settings, 640, 480).scale, 2.25f);
  settings.size = "window-4";
  const PictureExtent huge = pictureExtent(settings, 8192, 4096);
  EXPECT_EQ(huge.width, 16384);
  EXPECT_EQ(huge.height, 8192);
}

TEST(PictureSettings, LockedRatioTakesTheOtherSideAlong) {
  PictureSettings settings;
  setPictureValue(settings, "width", "3840");
  EXPECT_EQ(settings.height, 2160);
  setPictureValue(settings, "lock-ratio", "off");
  setPictureValue(settings, "height", "100");
  EXPECT_EQ(settings.width, 3840);
  EXPECT_THROW(setPictureValue(settings, "width", "16385"), UsageError);
  EXPECT_THROW(setPictureValue(settings, "width", "1e3"), UsageError);
  EXPECT_THROW(setPictureValue(settings, "ground", "pink"), UsageError);
  EXPECT_EQ(settings.width, 3840);
}

TEST(PictureSettings, EveryTextReadsBack) {
  PictureSettings settings, again;
  settings = {"both", "own", 300,  200,   false, 4,   "white",
              false,  false, true, false, 9,     "a", "/b c"};
  again.lockRatio = false;
  for (const auto& row : pictureSettingTable()) {
    setPictureValue(again, row.id, pictureValue(settings, row.id));
  }
  EXPECT_EQ(again, settings);
}

TEST(PictureSettings, OnlyWhatIsShownCanBeKept) {
  RenderSettings render;
  render.numbers = false;
  PictureSettings settings;
  settings.ground = "transparent";
  settings.seeds = false;
  applyPicture(settings, render);
  EXPECT_TRUE(render.background.transparent);
  EXPECT_FALSE(render.seedMarks);
  EXPECT_FALSE(render.numbers);
  EXPECT_TRUE(render.seams);
}

TEST(PictureDialog, SetsWhatF12Takes) {
  HeadlessFrame window;
  window.openFlooded("sphere", 200);
  window.key("Shift+F12");
  window.frames(3);
  window.click("picture-set background white");
  window.click("picture-set supersampling 4");
  window.click("picture/seed-marks");
  window.key("Shift+F12");
  window.frames(2);
  EXPECT_FALSE(window.has("picture/seed-marks"));
  window.key("F12");
  ASSERT_EQ(window.state().requests.pictures.size(), 1u);
  const PictureSettings& wanted = window.state().requests.pictures[0].settings;
  EXPECT_EQ(wanted.ground, "white");
  EXPECT_EQ(wanted.smooth, 4);
  EXPECT_FALSE(wanted.seeds);
  EXPECT_EQ(window.state().preferences.picture, wanted);
}

TEST(PictureDialog, NothingIsCutOff) {
  for (const ImVec2 size : {ImVec2(1024, 640), ImVec2(2560, 1440)}) {
    HeadlessFrame window(size, size.x > 2000 ? 2.0f : 1.0f);
    window.state().panels.firstCard = false;
    window.state().panels.picture = true;
    window.state().preferences.picture.size = "own";
    window.frames(4);
    for (const char* label : {"picture-set view ab", "picture/lock-ratio", "picture/numbers",
                              "picture-set view window", "picture-set background transparent",
                              "picture/folder", "picture/preview", "copy-command", "screenshot"}) {
      EXPECT_TRUE(window.item(label).whole()) << label << " at " << size.x;
    }
  }
}

/// Notes what it is asked for.
class NotedPreview : public PreviewSource {
 public:
  std::vector<PreviewPart> preview(const AppState&, const PictureExtent& extent, int width,
                                   int height, float) override {
    asked.push_back({extent.width, extent.height, width, height});
    return {{}};
  }
  bool upToDate() const override { return fresh; }

  struct Asked {
    int width, height, shownWidth, shownHeight;
  };
  std::vector<Asked> asked;
  bool fresh = true;
};

class PicturePreviewBox : public ::testing::Test {
 protected:
  PicturePreviewBox() {
    window.previewSource = &previews;
    window.openFlooded("sphere", 200);
  }
  void run(const char* line) {
    EXPECT_TRUE(window.state().perform(window.actions(), line)) << line;
    window.frames(3);
  }
  NotedPreview previews;
  HeadlessFrame window;
};

TEST_F(PicturePreviewBox, IsDrawnSmallInTheShapeOfThePicture) {
  EXPECT_TRUE(previews.asked.empty()) << "nothing while the dialog is closed";
  run("picture-dialog on");
  run("picture-set size 4k");
  ASSERT_FALSE(previews.asked.empty());
  EXPECT_EQ(previews.asked.back().width, 3840);
  EXPECT_EQ(previews.asked.back().shownWidth, 240);
  EXPECT_EQ(previews.asked.back().shownHeight, 135);
  run("picture-set size square");
  EXPECT_EQ(previews.asked.back().shownWidth, 135);
  EXPECT_EQ(previews.asked.back().shownHeight, 135);
  const ProbedItem place = window.item("picture/preview"), shown = window.item("picture/shown");
  EXPECT_NEAR(place.center().x, shown.center().x, 1);
}

TEST_F(PicturePreviewBox, OfTheWindowHasItsShape) {
  run("picture-dialog on");
  window.click("picture-set view window");
  window.frames(2);
  EXPECT_EQ(window.state().preferences.picture.view, "window");
  EXPECT_EQ(previews.asked.back().width, 1280);
  EXPECT_EQ(previews.asked.back().height, 800);
  // Nothing else can be chosen of it.
  window.click("picture-set background white");
  window.click("picture/seed-marks");
  EXPECT_EQ(window.state().preferences.picture.ground, "theme");
  EXPECT_TRUE(window.state().preferences.picture.seeds);
  EXPECT_TRUE(window.state().perform(window.actions(), "screenshot"));
  EXPECT_EQ(window.state().requests.pictures.back().settings.view, "window");
  // Without helpers there is no window, and it does not turn.
  window.key("Ctrl+F12");
  EXPECT_EQ(window.state().requests.pictures.back().settings.view, "3d");
  run("turntable 3");
  EXPECT_EQ(window.state().requests.pictures.back().settings.view, "3d");
}

TEST_F(PicturePreviewBox, ComesSoonAgainUntilItIsUpToDate) {
  run("picture-dialog on");
  EXPECT_GT(window.frame().wakeIn(), 0.1);
  previews.fresh = false;
  window.frames(1);
  EXPECT_LE(window.frame().wakeIn(), 0.05);
}

TEST_F(PicturePreviewBox, SaysWhyThereCanBeNoPicture) {
  run("picture-dialog on");
  previews.asked.clear();
  run("picture-set view ab");
  EXPECT_TRUE(previews.asked.empty());
  EXPECT_FALSE(window.has("picture/shown"));
  run("store A");
  EXPECT_FALSE(previews.asked.empty());
}

TEST(PictureDialog, WhatCannotBeTakenIsRefusedWithASentence) {
  HeadlessFrame window;
  window.openFlooded("sphere", 200);
  EXPECT_FALSE(window.state().perform(window.actions(), "screenshot view=ab"));
  EXPECT_FALSE(window.state().perform(window.actions(), "screenshot view=uv"));
  EXPECT_TRUE(window.state().requests.pictures.empty());
  window.state().perform(window.actions(), "store A");
  EXPECT_TRUE(window.state().perform(window.actions(), "screenshot view=ab"));
}

TEST(PictureDialog, BareIsTransparentWithoutHelpers) {
  HeadlessFrame window;
  window.openFlooded("sphere", 200);
  window.key("Ctrl+F12");
  ASSERT_EQ(window.state().requests.pictures.size(), 1u);
  const PictureRequest& request = window.state().requests.pictures[0];
  EXPECT_TRUE(request.bare);
  EXPECT_EQ(request.settings.ground, "transparent");
  EXPECT_FALSE(request.settings.legend);
}

}  // namespace

}  // namespace chartflood
