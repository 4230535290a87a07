#include "core/segment/rounds/offset_steps.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace chartflood {

namespace {

// Measured on what is left of the spread after five rounds; more than three remembered rounds do
// not help, as floods answer to offsets by jumps.
constexpr double kShare = 1.2;
constexpr std::size_t kRemembered = 3;
constexpr double kDependent = 1e-9;  // squared length, as a share, of what tells nothing new

using Values = std::vector<double>;

double dot(const Values& a, const Values& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
/// a += factor * b
void add(Values& a, double factor, const Values& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}
Values difference(const Values& a, const Values& b) {
  Values result = a;
  add(result, -1, b);
  return result;
}
Values centered(std::span<const double> values) {
  Values result(values.begin(), values.end());
  const double mean =
      std::accumulate(result.begin(), result.end(), 0.0) / static_cast<double>(result.size());
  for (double& value : result) value -= mean;
  return result;
}

}  // namespace

void OffsetSteps::update(std::vector<double>& offsets, std::span<const double> chartGauss) {
  Round now{centered(offsets), centered(chartGauss)};
  Values next = now.offsets;
  add(next, kShare, now.surplus);
  // Changes of the surplus since earlier rounds, made orthogonal, with those of the offsets.
  std::vector<Round> changes;
  for (auto round = rounds_.rbegin(); round != rounds_.rend(); ++round) {
    Round change{difference(now.offsets, round->offsets), difference(now.surplus, round->surplus)};
    const double length = dot(change.surplus, change.surplus);
    for (const Round& other : changes) {
      const double part = dot(change.surplus, other.surplus) / dot(other.surplus, other.surplus);
      add(change.offsets, -part, other.offsets);
      add(change.surplus, -part, other.surplus);
    }
    const double left = dot(change.surplus, change.surplus);
    if (left <= kDependent * length) continue;
    const double removed = dot(now.surplus, change.surplus) / left;
    add(next, -removed, change.offsets);
    add(next, -removed * kShare, change.surplus);
    changes.push_back(std::move(change));
  }
  if (rounds_.size() == kRemembered) rounds_.erase(rounds_.begin());
  rounds_.push_back(std::move(now));
  const double smallest = *std::min_element(next.begin(), next.end());
  for (std::size_t c = 0; c < offsets.size(); ++c) offsets[c] = next[c] - smallest;
}

}  // namespace chartflood
