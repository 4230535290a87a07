#include "core/model/position_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace chartflood {

namespace {

std::uint64_t hashOf(const glm::dvec3& p) {
  std::uint64_t hash = 0;
  for (const double x : {p.x, p.y, p.z}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

/// By bits, so that a position that is not a number equals itself.
bool sameBits(const glm::dvec3& a, const glm::dvec3& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;  // NOLINT(bugprone-suspicious-memory-comparison)
}

}  // namespace

PositionTable::PositionTable(std::size_t expected)
    : slots_(std::bit_ceil(std::max<std::size_t>(2 * expected, 64)), kNone) {
  positions_.reserve(expected);
}

/// Where the position stands or would stand; -0 is 0 already.
std::size_t PositionTable::slotOf(const glm::dvec3& position) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hashOf(position) & mask;
  while (slots_[slot] != kNone && !sameBits(positions_[slots_[slot]], position)) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

Index PositionTable::find(glm::dvec3 position) const { return slots_[slotOf(position + 0.0)]; }

Index PositionTable::indexOf(glm::dvec3 position) {
  position += 0.0;  // -0 becomes 0
  const std::size_t slot = slotOf(position);
  if (slots_[slot] != kNone) return slots_[slot];
  const Index number = static_cast<Index>(positions_.size());
  slots_[slot] = number;
  positions_.push_back(position);
  if (2 * positions_.size() > slots_.size()) grow();
  return number;
}

void PositionTable::grow() {
  const std::size_t mask = 2 * slots_.size() - 1;
  slots_.assign(mask + 1, kNone);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    std::size_t slot = hashOf(positions_[i]) & mask;
    while (slots_[slot] != kNone) slot = (slot + 1) & mask;
    slots_[slot] = static_cast<Index>(i);
  }
}

bool samePlace(const glm::dvec3& a, const glm::dvec3& b) { return sameBits(a + 0.0, b + 0.0); }

Index NearPlaces::indexOf(const glm::dvec3& position) {
  const glm::dvec3 cell = glm::floor(position / distance_);
  Index nearest = kNone;
  double least = distance_;
  for (int i = 0; i < 27; ++i) {
    const glm::dvec3 near = cell + glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const Index number = cells_.find(near);
    if (number == kNone) continue;
    for (Index place = first_[number]; place != kNone; place = next_[place]) {
      const double distance = glm::length(places_[place] - position);
      if (distance > least || (distance == least && nearest != kNone && nearest < place)) continue;
      least = distance;
      nearest = place;
    }
  }
  if (nearest != kNone) return nearest;
  const Index place = static_cast<Index>(places_.size());
  const Index number = cells_.indexOf(cell);
  if (number == first_.size()) first_.push_back(kNone);
  places_.push_back(position);
  next_.push_back(first_[number]);
  first_[number] = place;
  return place;
}

}  // namespace chartflood
