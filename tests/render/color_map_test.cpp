#include "render/scene/color_map.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/scene/render_settings.h"

namespace chartflood {
namespace {

TEST(ColorMap, LightnessOfKnownColours) {
  EXPECT_NEAR(lightness({0, 0, 0}), 0, 1e-4);
  EXPECT_NEAR(lightness({1, 1, 1}), 100, 1e-2);
  EXPECT_NEAR(lightness(glm::vec3(119 / 255.0f)), 50, 0.2);  // mid grey of CIE L*
  EXPECT_NEAR(lightness({1, 0, 0}), 53.24, 0.05);
}

TEST(ColorMap, SafeSequentialMapsRunOneWayInLightness) {
  for (const ColorMap& map : colorMapTable()) {
    if (map.diverging || !map.colorBlindSafe) continue;
    const float direction = lightness(map.at(1)) > lightness(map.at(0)) ? 1.0f : -1.0f;
    float last = direction * lightness(map.at(0));
    for (int i = 1; i <= 200; ++i) {
      const float next = direction * lightness(map.at(static_cast<float>(i) / 200));
      EXPECT_GE(next, last - 0.05f) << map.id << " at " << i;
      last = next;
    }
    EXPECT_GT(std::abs(lightness(map.at(1)) - lightness(map.at(0))), 55) << map.id;
  }
}

TEST(ColorMap, DivergingMapsAreLightestInTheMiddleAndBalanced) {
  for (const ColorMap& map : colorMapTable()) {
    if (!map.diverging) continue;
    EXPECT_GT(lightness(map.at(0.5f)), 94) << map.id;
    for (int i = 0; i < 50; ++i) {
      const float t = static_cast<float>(i) / 100;
      EXPECT_LE(lightness(map.at(t)), lightness(map.at(t + 0.01f)) + 0.05f) << map.id;
      EXPECT_GE(lightness(map.at(1 - t - 0.01f)) + 0.05f, lightness(map.at(1 - t))) << map.id;
      EXPECT_NEAR(lightness(map.at(t)), lightness(map.at(1 - t)), 14) << map.id << " at " << t;
    }
  }
}

TEST(ColorMap, EndsAreTheFirstAndLastControl) {
  const ColorMap* viridis = findColorMap("viridis");
  ASSERT_NE(viridis, nullptr);
  EXPECT_NEAR(viridis->at(0).r, 0x44 / 255.0f, 1e-6);
  EXPECT_NEAR(viridis->at(1).g, 0xE7 / 255.0f, 1e-6);
  EXPECT_EQ(viridis->at(-3), viridis->at(0));
  EXPECT_EQ(viridis->at(7), viridis->at(1));
}

TEST(ColorMap, ThePapersMapIsMarkedUnsafe) {
  const ColorMap* paper = findColorMap("paper");
  ASSERT_NE(paper, nullptr);
  EXPECT_FALSE(paper->colorBlindSafe);
  EXPECT_GT(paper->at(0).b, paper->at(0).r);
  EXPECT_GT(paper->at(1).r, paper->at(1).b);
  EXPECT_EQ(findColorMap("jet"), nullptr);
}

TEST(ColorModes, TableFollowsTheEnumerationAndNamesKnownMaps) {
  const auto table = colorModeTable();
  ASSERT_GE(table.size(), 13u);
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(table[i].mode), i);
    EXPECT_EQ(findColorMode(table[i].id), &table[i]);
    const std::string map = table[i].colorMap;
    EXPECT_TRUE(map.empty() || findColorMap(map)) << map;
    // Colours along a map need values, and what has values is drawn by them.
    EXPECT_EQ(map.empty(),
              table[i].domain == ValueDomain::None || table[i].domain == ValueDomain::Corner)
        << table[i].id;
    EXPECT_EQ(table[i].values == nullptr, map.empty() || table[i].domain == ValueDomain::All);
    const bool onTriangles =
        table[i].domain == ValueDomain::Triangle || table[i].domain == ValueDomain::All;
    EXPECT_EQ(table[i].fill == SurfaceFill::TriangleValue, onTriangles) << table[i].id;
    EXPECT_EQ(table[i].fill == SurfaceFill::ChartValue, table[i].domain == ValueDomain::Chart);
  }
  EXPECT_EQ(findColorMode("flood-time")->mode, ColorMode::FloodTime);
  EXPECT_EQ(findColorMode("rainbow"), nullptr);
}

TEST(Background, ReadsNamesHexAndTriples) {
  EXPECT_TRUE(backgroundFromText("transparent").transparent);
  EXPECT_EQ(backgroundFromText("white").top, glm::vec3(1));
  EXPECT_EQ(backgroundFromText("#FF8000").bottom, glm::vec3(255, 128, 0) / 255.0f);
  EXPECT_EQ(backgroundFromText("255,128,0").bottom, glm::vec3(255, 128, 0) / 255.0f);
  for (const char* wrong : {"", "reddish", "#12345", "1,2", "1,2,300", "1,2,3,", "1;2;3"}) {
    EXPECT_THROW(backgroundFromText(wrong), UsageError) << wrong;
  }
}

}  // namespace
}  // namespace chartflood
