// Charts moved apart exactly: core/pack/gap_check.

#include "core/pack/gap_check.h"

#include <gtest/gtest.h>

namespace chartflood {
namespace {

ChartOutline outlineOfLoop(const std::vector<glm::dvec2>& loop, double area) {
  ChartOutline outline;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    outline.segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  outline.hull = loop;
  outline.area = area;
  return outline;
}

ChartOutline rectangle(double width, double height) {
  return outlineOfLoop({{0, 0}, {width, 0}, {width, height}, {0, height}}, width * height);
}

constexpr PackGaps kGaps{0.01, 0.005};

TEST(GapCheck, PartsChartsThatOverlapALittle) {
  const ChartOutline a = rectangle(0.3, 0.3), b = rectangle(0.2, 0.3);
  std::vector<PlacedOutline> charts{{&a, {0, 0}, {0.1, 0.3, 0}}, {&b, {0, 0}, {0.397, 0.35, 0}}};
  const Progress progress;
  const Settled settled = settle(charts, kGaps, 1, 60, progress);
  EXPECT_TRUE(settled.apart);
  EXPECT_TRUE(settled.stuck.empty());
  EXPECT_GT(settled.scale, 0.98);
  const double right = charts[0].pose.x + 0.3 * settled.scale;
  EXPECT_GE(charts[1].pose.x - right, kGaps.between - 1e-12);
}

TEST(GapCheck, NamesAChartStuckInABay) {
  // The bay is wider than the square, but not by two gaps.
  const ChartOutline bay = outlineOfLoop({{0, 0},
                                          {0.5, 0},
                                          {0.5, 0.3},
                                          {0.265, 0.3},
                                          {0.265, 0.1},
                                          {0.235, 0.1},
                                          {0.235, 0.3},
                                          {0, 0.3}},
                                         0.144);
  const ChartOutline square = rectangle(0.02, 0.02);
  std::vector<PlacedOutline> charts{{&square, {0, 0}, {0.44, 0.35, 0}},
                                    {&bay, {0, 0}, {0.2, 0.2, 0}}};
  const Progress progress;
  const Settled settled = settle(charts, kGaps, 1, 60, progress);
  EXPECT_FALSE(settled.apart);
  EXPECT_EQ(settled.stuck, std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace chartflood
