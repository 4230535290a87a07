// The hand on the seeds: every gesture in the 3D view, and the actions behind them.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/model/build_mesh.h"
#include "render/passes/renderer.h"
#include "tests/gui/headless_frame.h"
#include "tests/gui/pointer_source.h"

namespace chartflood {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using Seeds = std::vector<PlacedSeed>;

class SeedsTool : public testing::Test {
 protected:
  SeedsTool() {
    ui_.setSource(&source_);
    ui_.openFlooded("sphere", 1200);
    ui_.key("G");
    ui_.frames(2);
  }
  AppState& state() { return ui_.state(); }
  Seeds seeds() { return state().presentSeeds(); }
  int charts() { return state().document().parameters.charts; }
  std::size_t steps() { return state().undoHistory().size(); }
  std::vector<Index> labels() { return state().results().segmentation->label; }

  ImVec2 placeOf(Index face) {
    const ProbedItem view = ui_.item("view");
    const double width = view.max.x - view.min.x, height = view.max.y - view.min.y;
    const glm::dvec3 ndc = state().view.camera.project(faceMiddle(*state().results().mesh, face),
                                                       width / height, BoundingSphere{});
    return {view.min.x + static_cast<float>((ndc.x + 1) / 2 * width),
            view.min.y + static_cast<float>((1 - ndc.y) / 2 * height)};
  }
  Pick pickAt(ImVec2 place) {
    const ImVec2 low = ui_.item("view").min;
    return source_.pick(static_cast<int>(place.x - low.x), static_cast<int>(place.y - low.y));
  }
  bool canBeSeen(Index face) { return pickAt(placeOf(face)).face == face; }
  float toNearestSeed(ImVec2 place) {
    float nearest = 1e9f;
    for (const PlacedSeed& seed : seeds()) {
      const ImVec2 at = placeOf(seed.face);
      nearest = std::min(nearest, std::hypot(at.x - place.x, at.y - place.y));
    }
    return nearest;
  }
  /// A face in full view, well away from all marks.
  Index bareFace() {
    const ProbedItem view = ui_.item("view");
    for (float y = 0.3f; y < 0.7f; y += 0.02f) {
      for (float x = 0.3f; x < 0.7f; x += 0.02f) {
        const ImVec2 place{view.min.x + x * (view.max.x - view.min.x),
                           view.min.y + y * (view.max.y - view.min.y)};
        const Pick pick = pickAt(place);
        if (pick.hit() && toNearestSeed(placeOf(pick.face)) > 30) return pick.face;
      }
    }
    ADD_FAILURE() << "no bare face";
    return 0;
  }
  /// A seed in full view.
  std::size_t shownSeed() {
    const Seeds all = seeds();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (canBeSeen(all[i].face)) return i;
    }
    ADD_FAILURE() << "no seed in view";
    return 0;
  }
  void clickAt(ImVec2 place, int button = 0) {
    ui_.frames(40);  // long enough not to be a double click
    ui_.moveTo(place);
    ui_.press(button);
    ui_.release(button);
    ui_.frames(2);
  }
  void doubleClickAt(ImVec2 place) {
    clickAt(place);
    ui_.press();
    ui_.release();
    ui_.frames(2);
  }
  /// From one place to another, the button still down.
  void pull(ImVec2 from, ImVec2 to) {
    ui_.frames(40);
    ui_.moveTo(from);
    ui_.press();
    for (int i = 1; i <= 6; ++i) {
      const float t = static_cast<float>(i) / 6;
      ui_.moveTo({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
    ui_.frames(1);  // the state takes in what the last step did
  }

  HeadlessFrame ui_;
  PointerSource source_;
};

TEST_F(SeedsTool, KeysAndButtonsSwitchIt) {
  EXPECT_EQ(state().panels.tool, PanelState::Tool::Seeds);
  ui_.click("tool select");
  EXPECT_EQ(state().panels.tool, PanelState::Tool::Select);
  ui_.click("tool seeds");
  EXPECT_EQ(state().panels.tool, PanelState::Tool::Seeds);
  ui_.key("V");
  EXPECT_EQ(state().panels.tool, PanelState::Tool::Select);
}

TEST_F(SeedsTool, AClickOnTheSurfaceAddsASeed) {
  const Seeds before = seeds();
  const std::vector<Index> label = labels();
  const Index face = bareFace();
  clickAt(placeOf(face));
  ASSERT_EQ(seeds().size(), 21u);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), seeds().begin())) << "others stay";
  EXPECT_EQ(seeds().back(), (PlacedSeed{face, false}));
  EXPECT_EQ(charts(), 21);
  EXPECT_EQ(labels()[face], 20u) << "flooded at once";
  EXPECT_EQ(steps(), 1u);
  EXPECT_EQ(state().undoHistory().undoName(), "Add seed 20");
  ui_.key("Ctrl+Z");
  ui_.frames(2);
  EXPECT_EQ(labels(), label);
  EXPECT_EQ(charts(), 20);
}

TEST_F(SeedsTool, InTheSelectToolAClickSelects) {
  ui_.key("V");
  const Index face = bareFace();
  clickAt(placeOf(face));
  EXPECT_EQ(seeds().size(), 20u);
  EXPECT_THAT(ui_.lastLine(), StartsWith("select-chart"));
}

TEST_F(SeedsTool, ADragMovesASeedInOneStep) {
  const std::size_t seed = shownSeed();
  const Seeds before = seeds();
  const std::vector<Index> label = labels();
  const Index face = bareFace();
  const double turned = state().view.camera.azimuthDegrees();
  pull(placeOf(before[seed].face), placeOf(face));
  EXPECT_EQ(seeds()[seed].face, face) << "floods while it is dragged";
  EXPECT_EQ(labels()[face], seed);
  ui_.release();
  ui_.frames(2);
  EXPECT_EQ(steps(), 1u);
  EXPECT_EQ(state().undoHistory().undoName(), "Move seed " + std::to_string(seed));
  EXPECT_EQ(charts(), 20);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(seeds()[i].face, i == seed ? face : before[i].face);
  }
  EXPECT_EQ(state().view.camera.azimuthDegrees(), turned) << "the camera stays";
  ui_.key("Ctrl+Z");
  ui_.frames(2);
  EXPECT_EQ(labels(), label);
  EXPECT_EQ(seeds(), before);
  ui_.key("Ctrl+Shift+Z");
  ui_.frames(2);
  EXPECT_EQ(seeds()[seed].face, face);
}

TEST_F(SeedsTool, EscPutsADraggedSeedBack) {
  const std::size_t seed = shownSeed();
  const Seeds before = seeds();
  const std::vector<Index> label = labels();
  pull(placeOf(before[seed].face), placeOf(bareFace()));
  ASSERT_NE(seeds(), before);
  ui_.key("Esc");
  ui_.frames(2);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  ui_.moveTo({mouse.x + 20, mouse.y + 20});
  ui_.release();
  ui_.frames(2);
  EXPECT_EQ(seeds(), before);
  EXPECT_EQ(labels(), label);
  EXPECT_EQ(steps(), 0u);
  EXPECT_FALSE(state().unsaved());
}

TEST_F(SeedsTool, ADragBesideASeedTurnsTheCamera) {
  const double turned = state().view.camera.azimuthDegrees();
  const ImVec2 from = placeOf(bareFace());
  pull(from, {from.x + 100, from.y});
  ui_.release();
  ui_.frames(2);
  EXPECT_GT(std::abs(state().view.camera.azimuthDegrees() - turned), 5);
  EXPECT_EQ(steps(), 0u);
}

TEST_F(SeedsTool, WithoutLiveModeTheChartsFollowOnRelease) {
  state().perform(ui_.actions(), "live off");
  const std::size_t seed = shownSeed();
  const Index face = bareFace();
  pull(placeOf(seeds()[seed].face), placeOf(face));
  EXPECT_TRUE(state().results().stale);
  EXPECT_EQ(seeds()[seed].face, face) << "the mark is where the mouse is";
  ui_.release();
  ui_.frames(2);
  EXPECT_TRUE(state().results().stale) << "off means off";
  state().perform(ui_.actions(), "live auto");
  pull(placeOf(face), placeOf(bareFace()));
  ui_.release();
  ui_.frames(2);
  EXPECT_FALSE(state().results().stale);
}

TEST_F(SeedsTool, CtrlClickAndDeleteRemoveASeed) {
  const Seeds before = seeds();
  const std::size_t seed = shownSeed();
  ImGui::GetIO().KeyCtrl = true;
  clickAt(placeOf(before[seed].face));
  ImGui::GetIO().KeyCtrl = false;
  ui_.frames(2);
  EXPECT_EQ(charts(), 19);
  Seeds expected = before;
  expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(seed));
  EXPECT_EQ(seeds(), expected);
  const std::size_t next = shownSeed();
  ui_.moveTo(placeOf(expected[next].face));
  ui_.frames(2);
  EXPECT_EQ(state().hoveredSeed, next);
  ui_.key("Delete");
  ui_.frames(2);
  EXPECT_EQ(charts(), 18);
  EXPECT_EQ(steps(), 2u);
}

TEST_F(SeedsTool, CtrlClickBesideASeedDoesNothing) {
  ImGui::GetIO().KeyCtrl = true;
  clickAt(placeOf(bareFace()));
  ImGui::GetIO().KeyCtrl = false;
  EXPECT_EQ(charts(), 20);
}

TEST_F(SeedsTool, ADoubleClickLocksAndUnlocks) {
  const std::size_t seed = shownSeed();
  const std::vector<Index> label = labels();
  const ImVec2 place = placeOf(seeds()[seed].face);
  doubleClickAt(place);
  EXPECT_TRUE(seeds()[seed].locked);
  EXPECT_EQ(state().undoHistory().undoName(), "Lock seed " + std::to_string(seed));
  EXPECT_EQ(charts(), 20);
  EXPECT_EQ(labels(), label);
  EXPECT_TRUE(seedMarks(state())[seed].locked) << "shows a padlock";
  const Index face = seeds()[seed].face;
  state().perform(ui_.actions(), "run");
  ui_.frames(3);
  EXPECT_EQ(seeds()[seed], (PlacedSeed{face, true}));
  doubleClickAt(place);
  EXPECT_FALSE(seeds()[seed].locked);
}

TEST_F(SeedsTool, ADoubleClickOnTheSurfaceAddsOneUnlockedSeed) {
  doubleClickAt(placeOf(bareFace()));
  ASSERT_EQ(seeds().size(), 21u);
  EXPECT_FALSE(seeds().back().locked);
}

TEST_F(SeedsTool, ARightClickOpensAMenu) {
  const std::size_t seed = shownSeed();
  const std::string number = " seed=" + std::to_string(seed);
  clickAt(placeOf(seeds()[seed].face), 1);
  ui_.frames(3);
  EXPECT_TRUE(ui_.has("swap-colors/" + std::to_string(seed)));
  ui_.click("menu/lock-seed" + number);
  ui_.frames(2);
  EXPECT_TRUE(seeds()[seed].locked);
  clickAt(placeOf(seeds()[seed].face), 1);
  ui_.frames(3);
  ui_.click("menu/delete-seed" + number);
  ui_.frames(2);
  EXPECT_EQ(seeds().size(), 19u);
}

TEST_F(SeedsTool, HiddenSeedsAreNotTaken) {
  const Seeds all = seeds();
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ImVec2 place = placeOf(all[i].face);
    const Pick pick = pickAt(place);
    const bool behind = pick.hit() && glm::length(pick.point - faceMiddle(*state().results().mesh,
                                                                          all[i].face)) > 0.3;
    if (!behind) continue;
    ++hidden;
    ui_.moveTo(place);
    ui_.frames(2);
    EXPECT_NE(state().hoveredSeed, i);
  }
  EXPECT_GT(hidden, 3u);
}

TEST_F(SeedsTool, RefusalsAreToasts) {
  const auto refusal = [&](const std::string& line) {
    EXPECT_FALSE(state().perform(ui_.actions(), line)) << line;
    const Toast& toast = state().notices.toasts().back();
    EXPECT_EQ(toast.kind, Notice::Kind::Info) << line;
    return toast.text;
  };
  const std::string taken = std::to_string(seeds()[4].face);
  EXPECT_EQ(refusal("add-seed face=" + taken), "Seed 4 is on this face already.");
  EXPECT_EQ(refusal("move-seed seed=2 face=" + taken), "Seed 4 is on this face already.");
  EXPECT_THAT(refusal("add-seed face=99999"), HasSubstr("no face 99999"));
  EXPECT_THAT(refusal("add-seed face=-1"), HasSubstr("no face -1"));
  EXPECT_THAT(refusal("delete-seed seed=20"), HasSubstr("seeds are 0 to 19"));
  EXPECT_THAT(refusal("delete-seed"), HasSubstr("Point at a seed"));
  EXPECT_THAT(refusal("clear-locks"), HasSubstr("No seed is locked"));
  EXPECT_EQ(steps(), 0u);
  state().perform(ui_.actions(), "set charts 1");
  EXPECT_EQ(refusal("delete-seed seed=0"), "The last seed stays: there is always one chart.");
}

TEST_F(SeedsTool, SpreadKeepsLockedSeedsAndLocksClear) {
  state().perform(ui_.actions(), "lock-seed seed=3");
  const Index face = seeds()[3].face;
  state().perform(ui_.actions(), "spread-seeds");
  EXPECT_EQ(state().document().seeds, (Seeds{{face, true}}));
  EXPECT_EQ(seeds().size(), 20u);
  EXPECT_EQ(seeds()[0].face, face);
  state().perform(ui_.actions(), "clear-locks");
  EXPECT_FALSE(seeds()[0].locked);
}

TEST_F(SeedsTool, TheListOfSeedsIsCopiedAsOptions) {
  state().perform(ui_.actions(), "copy-seeds");
  ASSERT_TRUE(state().requests.clipboard);
  EXPECT_THAT(*state().requests.clipboard,
              StartsWith("--charts=20 --seeds=" + std::to_string(seeds()[0].face) + ","));
}

TEST_F(SeedsTool, TheMenuAddsASeedInTheMiddleOfTheView) {
  ui_.click("menu/Seeds");
  ui_.frames(2);
  ui_.click("menu/add-seed-in-view");
  ui_.frames(3);
  EXPECT_EQ(seeds().size(), 21u);
}

TEST(SeedParts, EveryPartKeepsASeed) {
  HeadlessFrame ui;
  InputMesh parts;
  parts.file = "parts";
  for (Index i = 0; i < 2; ++i) {
    const double x = 3.0 * i;
    const Index v = 4 * i;
    parts.positions.insert(parts.positions.end(),
                           {{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}});
    parts.corners.insert(parts.corners.end(), {v, v + 1, v + 2, v, v + 2, v + 3});
  }
  ui.state().session().openMesh(buildMesh(std::make_shared<const InputMesh>(parts)));
  ui.state().session().step(StepUnit::Flood);
  ui.frames(2);
  ui.state().perform(ui.actions(), "set charts 2");
  const std::vector<PlacedSeed> seeds = ui.state().presentSeeds();
  ASSERT_EQ(seeds.size(), 2u);
  EXPECT_FALSE(ui.state().perform(ui.actions(), "delete-seed seed=0"));
  EXPECT_THAT(ui.state().notices.toasts().back().text, HasSubstr("no other seed"));
  for (Index face = 0; face < 4; ++face) {
    if (face == seeds[0].face || face == seeds[1].face) continue;
    const bool own = (face < 2) == (seeds[0].face < 2);
    EXPECT_EQ(ui.state().perform(ui.actions(), "move-seed seed=0 face=" + std::to_string(face)),
              own);
    ui.state().undo();
  }
}

}  // namespace
}  // namespace chartflood
