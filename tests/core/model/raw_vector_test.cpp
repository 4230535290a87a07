#include "core/base/raw_vector.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

namespace chartflood {
namespace {

TEST(RawVector, KeepsItsValuesAcrossSmallAndLargeBlocks) {
  RawVector<std::uint32_t> grown;
  for (std::uint32_t i = 0; i < 3'000'000; ++i) grown.push_back(i);
  RawVector<std::uint32_t> sized(3'000'000);
  std::iota(sized.begin(), sized.end(), 0u);
  EXPECT_TRUE(grown == sized);
  RawVector<std::uint32_t> copy = sized;
  sized.resize(10);
  sized.shrink_to_fit();
  EXPECT_TRUE(copy == grown);
  copy = sized;
  EXPECT_EQ(copy.size(), 10u);
  EXPECT_EQ(copy[9], 9u);
}

TEST(RawVector, LargeBlocksBeginAtALargePage) {
  const RawVector<std::uint32_t> large(3'000'000);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.data()) % (std::uintptr_t{1} << 21), 0u);
}

}  // namespace
}  // namespace chartflood
