#include "tests/support/segmentation_checks.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace chartflood::test {

namespace {

/// Union-find: another way to connectivity than the searches of the program.
Index root(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

void expectValid(const Mesh& mesh, const GaussArea& gauss, const Segmentation& s) {
  ASSERT_EQ(s.label.size(), mesh.faceCount());
  ASSERT_EQ(s.seeds.size(), s.chartCount);
  EXPECT_TRUE(s.complete);
  std::vector<std::size_t> size(s.chartCount, 0);
  for (const Index label : s.label) {
    ASSERT_LT(label, s.chartCount);
    ++size[label];
  }
  for (std::size_t c = 0; c < s.chartCount; ++c) {
    EXPECT_GT(size[c], 0u) << "chart " << c << " is empty";
    EXPECT_EQ(s.label[s.seeds[c]], c) << "seed of chart " << c;
  }
  std::vector<Index> parent(mesh.faceCount());
  std::iota(parent.begin(), parent.end(), 0);
  for (Index side = 0; side < mesh.opposite().size(); ++side) {
    const Index other = mesh.opposite()[side];
    if (other == kNone) continue;
    const Index f = mesh.faceOf(side / 3), g = mesh.faceOf(other / 3);
    if (s.label[f] == s.label[g]) parent[root(parent, f)] = root(parent, g);
  }
  std::size_t pieces = 0;
  for (Index f = 0; f < parent.size(); ++f) pieces += root(parent, f) == f ? 1 : 0;
  EXPECT_EQ(pieces, s.chartCount) << "every chart is one piece";
  double sum = s.areas.onSeams;
  for (const double a : s.areas.gaussArea) {
    EXPECT_GE(a, 0);
    sum += a;
  }
  EXPECT_NEAR(sum, gauss.total(), 1e-9 * std::max(1.0, gauss.total()));
}

}  // namespace chartflood::test
