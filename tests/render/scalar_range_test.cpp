#include "render/scene/scalar_range.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace chartflood {
namespace {

TEST(ScalarRange, PercentileByWeight) {
  std::vector<WeightedValue> values;
  for (int i = 1; i <= 1000; ++i) values.push_back({static_cast<double>(i), 1});
  EXPECT_NEAR(weightedPercentile(values, 0.98), 980, 0.03 * 980);
  EXPECT_NEAR(weightedPercentile(values, 0.5), 500, 0.03 * 500);
  // One tiny sliver with a huge value must not matter.
  values.push_back({1e9, 1e-6});
  EXPECT_NEAR(weightedPercentile(values, 0.98), 980, 0.03 * 980);
  EXPECT_EQ(weightedPercentile({}, 0.5), 0);
}

TEST(ScalarRange, MostlyFlatModelsUseTheMean) {
  std::vector<WeightedValue> values(1000, {0, 1});
  values[7].value = 50;
  const ScalarRange range = rangeFromZero(values);
  EXPECT_EQ(range.min, 0);
  EXPECT_NEAR(range.max, 0.05, 1e-12);
}

TEST(ScalarRange, NothingAtAllGivesAUsableRange) {
  const ScalarRange range = rangeFromZero(std::vector<WeightedValue>(5, {0, 1}));
  EXPECT_LT(range.min, range.max);
  EXPECT_FALSE(range.hasMean);
}

TEST(ScalarRange, EqualValuesEndTheRange) {
  const ScalarRange range = rangeFromZero(std::vector<WeightedValue>(8, {1.5707963, 1}));
  EXPECT_NEAR(range.max, 1.5707963, 1e-9);
}

TEST(ScalarTicks, LinearTicksAreRoundAndInside) {
  ScalarRange range;
  range.min = -100;
  range.max = 100;
  const auto ticks = scalarTicks(range, 5);
  ASSERT_EQ(ticks.size(), 5u);
  EXPECT_EQ(ticks.front().label, "-100");
  EXPECT_EQ(ticks[2].label, "0");
  EXPECT_NEAR(ticks[2].place, 0.5, 1e-12);
  EXPECT_EQ(ticks.back().label, "100");
}

TEST(ScalarTicks, LabelsNeverTouchInAnyScale) {
  for (const ScalarScale scale : {ScalarScale::Linear, ScalarScale::Root, ScalarScale::Log}) {
    for (const double top : {0.037, 1.0, 22.6, 1191.0, 3.3e6}) {
      ScalarRange range;
      range.max = top;
      range.min = scale == ScalarScale::Log ? top * 1e-4 : 0;
      range.scale = scale;
      const auto ticks = scalarTicks(range, 6);
      ASSERT_GE(ticks.size(), 2u);
      EXPECT_LE(ticks.size(), 9u);
      for (std::size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_GE(ticks[i].place, 0);
        EXPECT_LE(ticks[i].place, 1);
        EXPECT_NEAR(range.place(std::stod(ticks[i].label)), ticks[i].place, 0.02);
        if (i == 0) continue;
        EXPECT_GT(ticks[i].place - ticks[i - 1].place, 0.1);
      }
    }
  }
}

TEST(ScalarRange, PlacesFollowTheScale) {
  ScalarRange range;
  range.max = 100;
  range.scale = ScalarScale::Root;
  EXPECT_NEAR(range.place(25), 0.5, 1e-12);
  range.min = 1;
  range.scale = ScalarScale::Log;
  EXPECT_NEAR(range.place(10), 0.5, 1e-12);
  EXPECT_EQ(range.place(0), 0);
  EXPECT_EQ(range.place(1e9), 1);
}

}  // namespace
}  // namespace chartflood
