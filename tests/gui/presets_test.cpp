// The user's own presets: saved, used, renamed, deleted and brought back; what is broken in the
// settings file is named and left out.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gui/headless_frame.h"
#include "tests/support/temporary_folder.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class Presets : public ::testing::Test {
 protected:
  bool run(const char* line) { return ui.state().perform(ui.actions(), line); }
  const Parameters& values() { return ui.state().document().parameters; }
  const std::vector<UserPreset>& presets() { return ui.state().preferences.presets; }

  HeadlessFrame ui;
};

TEST_F(Presets, BringTheirValuesBackAsOneUndoStep) {
  run("set charts 33");
  run("set speed-power 2.5");
  ASSERT_TRUE(run("save-preset \"My clay\""));
  const Parameters saved = values();
  run("reset-all");
  ASSERT_TRUE(run("own-preset \"My clay\""));
  EXPECT_EQ(values(), saved);
  run("undo");
  EXPECT_EQ(values(), Parameters{});
}

TEST_F(Presets, NamesAreTakenOnceAndNeverFromBuiltInOnes) {
  EXPECT_TRUE(run("save-preset one"));
  EXPECT_FALSE(run("save-preset one"));
  EXPECT_FALSE(run("save-preset Paper"));
  EXPECT_FALSE(run("save-preset \"  \""));
  EXPECT_THAT(presets(), SizeIs(1));
}

TEST_F(Presets, DeletionCanBeTakenBack) {
  run("save-preset one");
  run("save-preset two");
  const UserPreset one = presets()[0];
  EXPECT_FALSE(run("restore-preset"));
  EXPECT_TRUE(run("delete-preset one"));
  EXPECT_THAT(presets(), SizeIs(1));
  EXPECT_TRUE(run("restore-preset"));
  ASSERT_THAT(presets(), SizeIs(2));
  EXPECT_EQ(presets()[1], one);
}

TEST_F(Presets, SavedAndRenamedByTypingAName) {
  run("set charts 9");
  ui.click("preset");
  ui.frames(2);
  ui.click("preset/save");
  ui.frames(3);
  ui.type("Nine");
  ui.enter();
  ASSERT_THAT(presets(), SizeIs(1));
  EXPECT_EQ(presets()[0].name, "Nine");
  EXPECT_FALSE(ui.state().panels.namesPreset);
  EXPECT_TRUE(run("rename-preset Nine \"A few\""));
  EXPECT_EQ(presets()[0].name, "A few");
}

TEST_F(Presets, AreWrittenWhenTheyChange) {
  int written = 0;
  ui.state().keepPreferences = [&] { ++written; };
  run("save-preset one");
  run("rename-preset one two");
  run("delete-preset two");
  run("restore-preset");
  EXPECT_EQ(written, 4);
}

class PresetFile : public ::testing::Test {
 protected:
  Preferences readBack() { return readPreferences(folder, folder, warning); }

  const TemporaryFolder temporary;
  const std::filesystem::path folder = temporary.path();
  std::string warning;
};

TEST_F(PresetFile, SurvivesTheSettingsFile) {
  Parameters parameters;
  askCharts(parameters, 7);
  parameters.speedPower = 2.25;
  parameters.unwrap = "circle";
  Preferences likes;
  likes.theme = ThemeKind::Light;
  likes.presets = {userPresetOf("Sch\u00f6n", parameters), userPresetOf("other", Parameters{})};
  writePreferences(likes, folder, folder);
  EXPECT_EQ(readBack(), likes);
  EXPECT_EQ(warning, "");
  EXPECT_EQ(applyUserPreset({}, likes.presets[0], warning), parameters);
}

TEST_F(PresetFile, BrokenPresetsAreNamedAndLeftOut) {
  std::ofstream(folder / "config.json")
      << R"({"presets": {"good": {"charts": 12}, "bad": 5, "odd": {"charts": "many", "wings": 2}}})";
  const Preferences likes = readBack();
  EXPECT_THAT(warning, HasSubstr("'bad'"));
  ASSERT_THAT(likes.presets, SizeIs(2));
  EXPECT_EQ(applyUserPreset({}, likes.presets[0], warning).charts, 12);
  EXPECT_EQ(warning, "");
  EXPECT_EQ(applyUserPreset({}, likes.presets[1], warning), Parameters{});
  EXPECT_THAT(warning, HasSubstr("charts, wings"));
}

TEST_F(PresetFile, ABrokenPresetIsStillThereAfterTheNextSave) {
  std::ofstream(folder / "config.json")
      << R"({"presets": {"good": {"charts": 12}, "bad": 5, "odd": [1, "two"]}})";
  const Preferences first = readBack();
  ASSERT_THAT(first.presets, SizeIs(1));
  writePreferences(first, folder, folder);
  EXPECT_EQ(readBack(), first);
  EXPECT_THAT(warning, HasSubstr("kept as it is"));
  std::ifstream stream(folder / "config.json");
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_THAT(text.str(), HasSubstr(R"("bad": 5)"));
  EXPECT_THAT(text.str(), HasSubstr("two"));
}

TEST(PresetWarning, IsStillSeenWhenTheFirstFrameComesLate) {
  HeadlessFrame ui;
  ui.state().notices.add(Notice::Kind::Warning, "The settings file holds an unusable preset.");
  ui.state().update(9);  // the window took its time to open
  ui.frames(2);
  EXPECT_TRUE(ui.has("toast 0"));
  ui.state().update(9);
  ui.frames(2);
  EXPECT_FALSE(ui.has("toast 0"));
}

}  // namespace
}  // namespace chartflood
