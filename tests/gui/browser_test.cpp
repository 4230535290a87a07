// The choice of files: typing, clicking, formats, and what happens when something is wrong.

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gui/headless_frame.h"
#include "tests/support/temporary_folder.h"

namespace chartflood {
namespace {

using ::testing::HasSubstr;

class Browser : public ::testing::Test {
 protected:
  Browser() {
    for (const char* name : {"ant.obj", "bee.obj", "cow.obj"}) {
      std::ofstream(folder / name) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\n"
                                      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    }
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  void open(const std::string& name) {
    ui.state().playback.setSpeed(2 * Playback::kFastest);
    ui.state().perform(ui.actions(), "open " + path(name));
    ui.frames(12);
  }
  void browse(const std::string& line) {
    ui.state().perform(ui.actions(), line);
    ui.frames(3);
  }
  /// Opens the window in the folder of the test, which is where the last model came from.
  void browseHere() {
    open("ant.obj");
    browse("browse");
  }
  void retype(const std::string& text) {
    ui.click("browser-name");
    ui.frames(1);
    ImGui::GetIO().KeyCtrl = true;
    ui.arrow(ImGuiKey_A);
    ImGui::GetIO().KeyCtrl = false;
    ui.type(text.c_str());
    ui.frames(1);
  }
  bool isOpen() const { return ui.has("browser-accept"); }

  TemporaryFolder temporary;
  std::filesystem::path folder = temporary.path();
  HeadlessFrame ui;
};

TEST_F(Browser, ADoubleClickOpensAFile) {
  browseHere();
  ASSERT_TRUE(ui.has("browser/cow.obj"));
  ui.moveTo(ui.item("browser/cow.obj").center());
  for (int i = 0; i < 2; ++i) {
    ui.press();
    ui.release();
  }
  ui.frames(6);
  EXPECT_FALSE(isOpen());
  EXPECT_EQ(ui.state().modelName(), "cow");
}

TEST_F(Browser, AClickChoosesAndHidesNothing) {
  browseHere();
  ui.click("browser/bee.obj");
  ui.frames(3);
  for (const char* name : {"ant.obj", "bee.obj", "cow.obj"}) {
    EXPECT_TRUE(ui.has(std::string("browser/") + name)) << name;
  }
  ui.enter();
  ui.frames(6);
  EXPECT_EQ(ui.state().modelName(), "bee") << "Enter takes what was clicked";
}

TEST_F(Browser, TypingFiltersAndArrowsChoose) {
  browseHere();
  ui.arrow(ImGuiKey_DownArrow);
  ui.arrow(ImGuiKey_DownArrow);
  ui.enter();
  ui.frames(6);
  EXPECT_EQ(ui.state().modelName(), "bee");
  browse("browse");
  ui.type("co");
  ui.frames(2);
  EXPECT_TRUE(ui.has("browser/cow.obj"));
  EXPECT_FALSE(ui.has("browser/bee.obj"));
}

TEST_F(Browser, AnExportBeginsBesideTheModelAndOffersFormats) {
  open("cow.obj");
  ASSERT_TRUE(ui.state().results().flat);
  browse("export-mesh");
  EXPECT_TRUE(ui.has("browser/cow.obj"));
  for (const char* ending : {".obj", ".ply", ".glb"}) {
    ui.click(std::string("browser-format/") + ending);
    ui.click("browser-accept");
    ui.frames(3);
    EXPECT_TRUE(std::filesystem::exists(path("cow_uv") + ending)) << ending;
    EXPECT_FALSE(isOpen());
    browse("export-mesh");
  }
}

TEST_F(Browser, AWrongEndingLeavesItOpen) {
  open("cow.obj");
  browse("export-mesh");
  retype("cow.xyz");
  ui.click("browser-accept");
  ui.frames(2);
  EXPECT_TRUE(isOpen());
  EXPECT_FALSE(std::filesystem::exists(path("cow.xyz")));
  ui.click("browser-format/.ply");
  ui.click("browser-accept");
  ui.frames(2);
  EXPECT_FALSE(isOpen());
  EXPECT_TRUE(std::filesystem::exists(path("cow.ply")));
}

TEST_F(Browser, AFailureLeavesItOpen) {
  open("cow.obj");
  browse("export-mesh");
  retype("none/cow.obj");
  ui.click("browser-accept");
  ui.frames(2);
  EXPECT_TRUE(isOpen());
}

TEST_F(Browser, OverTheModelItAsksOnce) {
  open("cow.obj");
  const auto before = std::filesystem::file_size(path("cow.obj"));
  browse("export-mesh");
  retype("cow.obj");
  ui.click("browser-accept");
  ui.frames(2);
  EXPECT_TRUE(isOpen());
  EXPECT_EQ(std::filesystem::file_size(path("cow.obj")), before);
  ui.click("browser-accept");
  ui.frames(2);
  EXPECT_FALSE(isOpen());
  EXPECT_NE(std::filesystem::file_size(path("cow.obj")), before);
}

TEST_F(Browser, AFileThatCannotBeReadIsNotOfferedAgain) {
  std::ofstream(folder / "bad.obj") << "f 1 2 3\n";
  open("ant.obj");
  open("bad.obj");
  EXPECT_THAT(ui.state().notices.toasts().back().text, HasSubstr("bad.obj"));
  ASSERT_EQ(ui.state().preferences.recentFiles.size(), 1u);
  EXPECT_THAT(ui.state().preferences.recentFiles.front(), HasSubstr("ant.obj"));
}

}  // namespace
}  // namespace chartflood
