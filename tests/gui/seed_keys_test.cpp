// Seeds by keyboard alone: chosen, moved over the surface, locked, added and deleted.

#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/host/film/seed_steps.h"
#include "render/passes/renderer.h"
#include "tests/gui/headless_frame.h"
#include "tests/gui/pointer_source.h"

namespace chartflood {
namespace {

class SeedKeys : public ::testing::Test {
 protected:
  SeedKeys() {
    ui.setSource(&source);
    ui.openFlooded("sphere", 1200);
    ui.key("G");
    ui.frames(2);
  }
  AppState& state() { return ui.state(); }
  std::vector<PlacedSeed> seeds() { return state().presentSeeds(); }
  Index face(std::size_t seed) { return seeds()[seed].face; }
  glm::dvec3 middle(Index f) { return faceMiddle(*state().results().mesh, f); }
  void key(const char* chord) {
    ui.key(chord);
    ui.frames(4);
  }

  PointerSource source;
  HeadlessFrame ui;
};

TEST_F(SeedKeys, TabAndBracketsGoRoundTheSeeds) {
  EXPECT_EQ(state().chosenSeed, kNone);
  key("Tab");
  EXPECT_EQ(state().chosenSeed, 0u);
  key("]");
  EXPECT_EQ(state().chosenSeed, 1u);
  key("[");
  key("Shift+Tab");
  EXPECT_EQ(state().chosenSeed, seeds().size() - 1);
  EXPECT_EQ(state().selectedChart, kNone);  // that is what the brackets do elsewhere
  key("Esc");
  EXPECT_EQ(state().chosenSeed, kNone);
  key("V");
  key("]");
  EXPECT_EQ(state().selectedChart, 0u);
}

TEST_F(SeedKeys, AChosenSeedLooksAtTheEyeAndIsEmphasised) {
  for (std::size_t i = 0; i < seeds().size(); ++i) {
    key("Tab");
    const glm::dvec3 normal = faceNormal(*state().results().mesh, face(state().chosenSeed));
    EXPECT_LE(glm::dot(normal, state().view.camera.forward()), 0);
    EXPECT_TRUE(seedMarks(state())[state().chosenSeed].emphasis);
  }
}

TEST_F(SeedKeys, ArrowsMoveItInTheDirectionOfThePicture) {
  key("Tab");
  const std::size_t steps = state().undoHistory().size();
  struct Way {
    const char* key;
    double x, y;
  };
  for (const Way& way :
       {Way{"Left", -1, 0}, Way{"Right", 1, 0}, Way{"Up", 0, 1}, Way{"Down", 0, -1}}) {
    const Camera camera = state().view.camera;
    const glm::dvec3 before = middle(face(0));
    key(way.key);
    const glm::dvec3 moved = middle(face(0)) - before;
    const double along =
        way.x * glm::dot(moved, camera.right()) + way.y * glm::dot(moved, camera.upward());
    EXPECT_GT(along, 0) << way.key;
    EXPECT_LT(glm::length(moved), 0.2) << way.key;
  }
  EXPECT_EQ(state().undoHistory().size(), steps + 4);
  const Index here = face(0);
  key("Shift+Left");
  const double far = glm::distance(middle(face(0)), middle(here));
  key("Ctrl+Z");
  EXPECT_EQ(face(0), here);
  key("Left");
  EXPECT_GT(far, 4 * glm::distance(middle(face(0)), middle(here)));
}

TEST_F(SeedKeys, WithoutAChosenSeedArrowsStepTheFlood) {
  key("Home");
  const std::size_t before = state().playback.playhead();
  ui.key("Right");
  ui.frames(1);
  EXPECT_EQ(state().playback.playhead(), before + 1);
}

TEST_F(SeedKeys, LockDeleteAndAdd) {
  key("Tab");
  key("Ctrl+L");
  EXPECT_TRUE(seeds()[0].locked);
  key("Ctrl+L");
  EXPECT_FALSE(seeds()[0].locked);
  const std::size_t count = seeds().size();
  key("Tab");
  key("Delete");
  EXPECT_EQ(seeds().size(), count - 1);
  EXPECT_LT(state().chosenSeed, seeds().size());
  key("Insert");
  EXPECT_EQ(seeds().size(), count);
}

TEST(SeedSteps, NeverOntoATakenFaceAndNoneOutwardsAtABorder) {
  HeadlessFrame ui;
  ui.openFlooded("sphere", 500);
  const Mesh& mesh = *ui.state().results().mesh;
  const Camera& camera = ui.state().view.camera;
  const auto any = [](Index) { return true; };
  std::set<Index> seen;
  Index face = 7;
  for (int i = 0; i < 6; ++i) {
    const Index next = faceTowards(mesh, face, camera.right(), camera.forward(), any);
    if (next == kNone) break;
    EXPECT_TRUE(seen.insert(next).second);
    EXPECT_NE(faceTowards(mesh, face, camera.right(), camera.forward(),
                          [&](Index f) { return f != next; }),
              next);
    face = next;
  }
  EXPECT_FALSE(seen.empty());
  EXPECT_EQ(faceTowards(mesh, face, camera.right(), camera.forward(), [](Index) { return false; }),
            kNone);
}

}  // namespace
}  // namespace chartflood
