// Simulated colour vision against properties that hold whatever the table: greys stay, colours that
// the colour-blind mix up come close, others stay apart.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "render/scene/color_vision.h"

namespace chartflood {
namespace {

TEST(ColorVision, GreysStay) {
  for (const ColorVisionInfo& kind : colorVisionTable()) {
    for (const float grey : {0.0f, 0.2f, 0.5f, 1.0f}) {
      const glm::vec3 seen = seenColor(glm::vec3(grey), kind.vision);
      EXPECT_LT(glm::distance(seen, glm::vec3(grey)), 1e-3f) << kind.id << ' ' << grey;
    }
  }
}

TEST(ColorVision, FullVisionChangesNothing) {
  const glm::vec3 color(0.8f, 0.3f, 0.1f);
  EXPECT_LT(glm::distance(seenColor(color, ColorVision::Full), color), 1e-5f);
}

TEST(ColorVision, MixesUpWhatTheColorBlindMixUp) {
  // Ishihara's pair: an orange and a green of one lightness.
  const glm::vec3 orange(0.80f, 0.47f, 0.13f), green(0.53f, 0.56f, 0.13f);
  const float full = glm::distance(orange, green);
  EXPECT_LT(glm::distance(seenColor(orange, ColorVision::GreenBlind),
                          seenColor(green, ColorVision::GreenBlind)),
            0.5f * full);
  EXPECT_GT(glm::distance(seenColor(orange, ColorVision::BlueBlind),
                          seenColor(green, ColorVision::BlueBlind)),
            0.7f * full);
  // Blue and green for the blue-blind.
  const glm::vec3 teal(0.0f, 0.55f, 0.55f), leaf(0.0f, 0.55f, 0.35f);
  EXPECT_LT(glm::distance(seenColor(teal, ColorVision::BlueBlind),
                          seenColor(leaf, ColorVision::BlueBlind)),
            glm::distance(teal, leaf));
}

}  // namespace
}  // namespace chartflood
