#include "core/io/weld.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

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

Index PositionTable::indexOf(glm::dvec3 position) {
  position += 0.0;  // -0 becomes 0
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hashOf(position) & mask;
  while (slots_[slot] != kNone) {
    if (sameBits(positions_[slots_[slot]], position)) return slots_[slot];
    slot = (slot + 1) & mask;
  }
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

std::vector<Index> joinEqualPositions(std::span<const glm::dvec3> positions) {
  PositionTable table(positions.size());
  std::vector<Index> first;  // vertex that brought each distinct position
  std::vector<Index> weld(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Index place = table.indexOf(positions[v]);
    if (place == first.size()) first.push_back(static_cast<Index>(v));
    weld[v] = first[place];
  }
  if (first.size() == positions.size()) weld.clear();
  return weld;
}

bool isUnshared(const InputMesh& mesh) {
  if (mesh.faceCount() < 2) return false;
  std::vector<Index> user(mesh.positions.size(), kNone);
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    for (const Index v : mesh.face(f)) {
      if (user[v] != kNone && user[v] != f) return false;
      user[v] = static_cast<Index>(f);
    }
  }
  return true;
}

}  // namespace chartflood
