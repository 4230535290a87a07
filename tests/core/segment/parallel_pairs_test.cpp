// Work on pairs of things side by side: core/base/parallel_pairs.

#include <atomic>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/base/parallel_pairs.h"
#include "core/base/rng.h"

namespace chartflood {
namespace {

constexpr Index kThings = 12;

std::vector<std::pair<Index, Index>> randomPairs(std::size_t count, std::uint32_t seed) {
  Rng rng(seed);
  std::vector<std::pair<Index, Index>> pairs;
  while (pairs.size() < count) {
    const Index a = rng.below(kThings), b = rng.below(kThings);
    if (a != b) pairs.emplace_back(a, b);
  }
  return pairs;
}

/// Results that depend on the order in which each thing meets its pairs.
std::vector<std::uint64_t> mixed(const std::vector<std::pair<Index, Index>>& pairs,
                                 unsigned threads) {
  setThreadCount(threads);
  std::vector<std::uint64_t> value(kThings);
  std::iota(value.begin(), value.end(), 1);
  parallelPairs(pairs, kThings, [&](std::size_t i, std::size_t worker) {
    EXPECT_LT(worker, threadCount());
    std::uint64_t &a = value[pairs[i].first], &b = value[pairs[i].second];
    a = 31 * a + b + i;
    b = 17 * b + a;
    return true;
  });
  setThreadCount(0);
  return value;
}

TEST(ParallelPairs, GiveWhatDoingThemInOrderGives) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const auto pairs = randomPairs(200, seed);
    std::vector<std::uint64_t> value(kThings);
    std::iota(value.begin(), value.end(), 1);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      value[pairs[i].first] = 31 * value[pairs[i].first] + value[pairs[i].second] + i;
      value[pairs[i].second] = 17 * value[pairs[i].second] + value[pairs[i].first];
    }
    for (const unsigned threads : {1u, 2u, 4u}) EXPECT_EQ(mixed(pairs, threads), value);
  }
}

TEST(ParallelPairs, NoWorkerDoesTwoAtOnce) {
  const auto pairs = randomPairs(400, 3);
  setThreadCount(4);
  std::vector<std::atomic<int>> busy(threadCount()), held(kThings);
  std::atomic<int> done = 0;
  parallelPairs(pairs, kThings, [&](std::size_t i, std::size_t worker) {
    EXPECT_EQ(busy[worker].fetch_add(1), 0);
    EXPECT_EQ(held[pairs[i].first].fetch_add(1), 0);
    EXPECT_EQ(held[pairs[i].second].fetch_add(1), 0);
    ++done;
    --held[pairs[i].first];
    --held[pairs[i].second];
    --busy[worker];
    return true;
  });
  setThreadCount(0);
  EXPECT_EQ(done, 400);
}

TEST(ParallelPairs, StopsWhenATaskSaysSo) {
  const auto pairs = randomPairs(200, 5);
  for (const unsigned threads : {1u, 4u}) {
    setThreadCount(threads);
    std::mutex mutex;
    std::vector<std::uint8_t> done(pairs.size(), 0);
    parallelPairs(pairs, kThings, [&](std::size_t i, std::size_t) {
      const std::lock_guard lock(mutex);
      if (i == 100) return false;
      done[i] = 1;
      return true;
    });
    setThreadCount(0);
    EXPECT_EQ(done[100], 0);
    for (std::size_t i = 101; i < pairs.size(); ++i) {  // nothing that waits for it was begun
      const auto [a, b] = pairs[i];
      if (a == pairs[100].first || b == pairs[100].second) {
        EXPECT_EQ(done[i], 0) << i;
      }
    }
  }
}

TEST(ParallelPairs, PassOnWhatATaskThrows) {
  const auto pairs = randomPairs(50, 7);
  for (const unsigned threads : {1u, 4u}) {
    setThreadCount(threads);
    EXPECT_THROW(parallelPairs(pairs, kThings,
                               [](std::size_t i, std::size_t) {
                                 if (i == 20) throw std::runtime_error("twenty");
                                 return true;
                               }),
                 std::runtime_error);
    setThreadCount(0);
  }
}

TEST(ParallelPairs, WorkInsideOtherTasks) {
  const auto pairs = randomPairs(60, 9);
  setThreadCount(4);
  std::atomic<int> done = 0;
  parallelFor(6, [&](std::size_t) {
    parallelPairs(pairs, kThings, [&](std::size_t, std::size_t) {
      ++done;
      return true;
    });
  });
  setThreadCount(0);
  EXPECT_EQ(done, 6 * 60);
}

}  // namespace
}  // namespace chartflood
