// Undo brings back the charts that were shown, label by label.

#include <gtest/gtest.h>

#include "tests/gui/headless_frame.h"

namespace chartflood {
namespace {

class Undo : public testing::Test {
 protected:
  Undo() { ui_.openFlooded("bumps", 3000); }
  void run(const std::string& line) {
    EXPECT_TRUE(ui_.state().perform(ui_.actions(), line)) << line;
    ui_.frames(3);
  }
  std::vector<Index> labels() { return ui_.state().results().segmentation->label; }

  HeadlessFrame ui_;
};

TEST_F(Undo, RestoresLabelsAfterEveryKindOfChange) {
  run("set layout square");  // where the pieces lie in the texture takes most of the time
  for (const char* before : {"finish", "iteration", "run"}) {
    run(before);
    for (const char* line :
         {"set charts 12", "set sharp-angle 20", "set speed-power 3", "set clean-up 0",
          "set refine none", "preset paper", "reset-seeds", "reset-flood", "spread-seeds",
          "add-seed face=17", "delete-seed seed=4", "move-seed seed=3 face=18", "roll-seed"}) {
      const Document document = ui_.state().document();
      const std::vector<Index> label = labels();
      const FloodMoment moment = momentOf(ui_.state().results());
      run(line);
      run("undo");
      EXPECT_EQ(labels(), label) << before << ", " << line;
      EXPECT_EQ(ui_.state().document(), document) << line;
      EXPECT_EQ(momentOf(ui_.state().results()), moment) << line;
    }
  }
}

TEST_F(Undo, RedoRestoresLabelsToo) {
  run("iteration");
  std::vector<std::vector<Index>> seen = {labels()};
  for (const char* line : {"set charts 9", "add-seed face=40", "lock-seed seed=2",
                           "set speed-epsilon 0.01", "move-seed seed=1 face=41"}) {
    run(line);
    seen.push_back(labels());
  }
  for (std::size_t i = seen.size() - 1; i-- > 0;) {
    run("undo");
    EXPECT_EQ(labels(), seen[i]) << i;
  }
  for (std::size_t i = 1; i < seen.size(); ++i) {
    run("redo");
    EXPECT_EQ(labels(), seen[i]) << i;
  }
}

TEST_F(Undo, NamesTellBothEndsOfADrag) {
  run("set charts 22 drag=on");
  run("set charts 24 drag=on");
  run("set charts 25");
  EXPECT_EQ(ui_.state().undoHistory().undoName(), "K 20 to 25");
  run("set sharp-angle 30");
  EXPECT_EQ(ui_.state().undoHistory().undoName(), "Sharp edge angle 45\u00b0 to 30\u00b0");
  EXPECT_EQ(ui_.state().undoHistory().size(), 2u);
}

TEST_F(Undo, KeepsTwoHundredSteps) {
  ui_.state().perform(ui_.actions(), "live off");
  for (int i = 0; i < 250; ++i) {
    ui_.state().perform(ui_.actions(), "set patience " + std::to_string(20 + i % 2));
  }
  EXPECT_EQ(ui_.state().undoHistory().size(), 200u);
}

TEST_F(Undo, AnotherModelEndsIt) {
  run("add-seed face=40");
  ui_.openFlooded("sphere", 500);
  EXPECT_FALSE(ui_.state().undoHistory().canUndo()) << "its seeds are faces of another mesh";
  EXPECT_TRUE(ui_.state().document().seeds.empty());
}

TEST(UndoHistoryDrag, CanBeTakenBack) {
  UndoHistory<int> history;
  EXPECT_EQ(history.takeBack(), std::nullopt);
  history.changed(1, "to 2", "a");
  history.changed(2, "to 3", "a");
  ASSERT_NE(history.joined("a"), nullptr);
  EXPECT_EQ(*history.joined("a"), 1);
  EXPECT_EQ(history.joined("b"), nullptr);
  EXPECT_EQ(history.takeBack(), 1);
  EXPECT_EQ(history.size(), 0u);
  history.changed(1, "to 2", "a");
  history.close();
  EXPECT_EQ(history.takeBack(), std::nullopt) << "what is closed stays";
}

}  // namespace
}  // namespace chartflood
