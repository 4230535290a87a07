#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "render/text/distance_field.h"
#include "render/text/font_data.h"
#include "render/text/glyph_atlas.h"

namespace chartflood {
namespace {

TEST(Font, TheFilesAreOpenType) {
  for (const auto font : {interRegular(), interSemiBold()}) {
    ASSERT_GT(font.size(), 100000u);
    EXPECT_EQ(std::string(font.begin(), font.begin() + 4), "OTTO");
  }
}

TEST(Utf8, DecodesAndReplacesWrongBytes) {
  EXPECT_EQ(decodeUtf8("a\u00B2\u20AC\U0001F600"),
            (std::vector<char32_t>{U'a', 0xB2, 0x20AC, 0x1F600}));
  EXPECT_EQ(decodeUtf8("\x80z"), (std::vector<char32_t>{0xFFFD, U'z'}));
  EXPECT_EQ(decodeUtf8("\xC2"), (std::vector<char32_t>{0xFFFD}));
  EXPECT_EQ(decodeUtf8("\xE2z"), (std::vector<char32_t>{0xFFFD, U'z'}));
}

TEST(DistanceField, AgreesWithBruteForce) {
  constexpr int kWidth = 23, kHeight = 17;
  std::vector<bool> inside(kWidth * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      inside[static_cast<std::size_t>(y * kWidth + x)] =
          std::hypot(x - 9, y - 8) < 6 && !(x > 10 && y > 8);
    }
  }
  const auto distance = signedDistances(inside, kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool here = inside[static_cast<std::size_t>(y * kWidth + x)];
      double nearest = 1e9;
      for (int v = -1; v <= kHeight; ++v) {
        for (int u = -1; u <= kWidth; ++u) {
          const bool in = u >= 0 && v >= 0 && u < kWidth && v < kHeight &&
                          inside[static_cast<std::size_t>(v * kWidth + u)];
          if (in != here) nearest = std::min(nearest, std::hypot(u - x, v - y));
        }
      }
      const double expected = here ? nearest - 0.5 : 0.5 - nearest;
      EXPECT_NEAR(distance[static_cast<std::size_t>(y * kWidth + x)], expected, 1e-4);
    }
  }
}

}  // namespace
}  // namespace chartflood
