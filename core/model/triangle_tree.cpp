#include "core/model/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <glm/common.hpp>

namespace chartflood {

namespace {

constexpr std::size_t kLeaf = 4;  // triangles in a box of the lowest level

/// Spreads the ten lowest bits to every third place.
std::uint64_t spread(std::uint64_t x) {
  x = (x | (x << 16)) & 0x030000FF;
  x = (x | (x << 8)) & 0x0300F00F;
  x = (x | (x << 4)) & 0x030C30C3;
  return (x | (x << 2)) & 0x09249249;
}

/// Place on the Z-order curve through the cube.
std::uint64_t curvePlace(const glm::dvec3& p, const glm::dvec3& low, double scale) {
  std::uint64_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::clamp((p[axis] - low[axis]) * scale, 0.0, 1023.0);
    place |= spread(static_cast<std::uint64_t>(cell)) << axis;
  }
  return place;
}

float below(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) <= value
             ? nearest
             : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

float above(double value) { return -below(-value); }

/// The ray sheared so that it runs along the third axis (Woop, Benthin and Wald, Watertight
/// Ray/Triangle Intersection, 2013): an edge gives both its triangles the same answer.
class Ray {
 public:
  Ray(const glm::dvec3& from, const glm::dvec3& to) : from_(from), way_(to - from) {
    const glm::dvec3 size = glm::abs(way_);
    z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    shear_ = {way_[x_] / way_[z_], way_[y_] / way_[z_], 1 / way_[z_]};
    inverse_ = 1.0 / way_;
  }

  bool degenerate() const { return way_[z_] == 0; }
  glm::dvec3 at(double share) const { return from_ + share * way_; }

  /// Share of the way at which the box is entered, or more than `most` when it is missed.
  template <class Box>
  double entry(const Box& box, double most) const {
    double in = 0, out = most;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      if (way_[axis] == 0) {
        if (from_[axis] < box.low[a] || from_[axis] > box.high[a]) return kMissed;
        continue;
      }
      double first = (box.low[a] - from_[axis]) * inverse_[axis];
      double second = (box.high[a] - from_[axis]) * inverse_[axis];
      if (first > second) std::swap(first, second);
      in = std::max(in, first);
      out = std::min(out, second);
    }
    // A little more than the rounding of the two products.
    return in <= out + 1e-12 ? in : kMissed;
  }

  /// Share of the way at which the triangle is met, or kMissed.
  double meets(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    const glm::dvec3 p = sheared(a), q = sheared(b), r = sheared(c);
    const double u = r.x * q.y - r.y * q.x;
    const double v = p.x * r.y - p.y * r.x;
    const double w = q.x * p.y - q.y * p.x;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return kMissed;
    const double sum = u + v + w;
    if (sum == 0) return kMissed;
    const double share = (u * p.z + v * q.z + w * r.z) / sum;
    return share >= 0 && share <= 1 ? share : kMissed;
  }

  static constexpr double kMissed = std::numeric_limits<double>::infinity();

 private:
  glm::dvec3 sheared(const glm::dvec3& point) const {
    const glm::dvec3 p = point - from_;
    return {p[x_] - shear_.x * p[z_], p[y_] - shear_.y * p[z_], shear_.z * p[z_]};
  }

  glm::dvec3 from_, way_, shear_{0}, inverse_{0};
  int x_ = 0, y_ = 1, z_ = 2;
};

}  // namespace

TriangleTree::TriangleTree(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {
  const auto positions = mesh_->positions();
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const glm::dvec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
  const glm::dvec3 size = high - low;
  const double scale = 1023 / std::max({size.x, size.y, size.z, 1e-300});

  std::vector<std::uint64_t> places;  // with the triangle below
  places.reserve(mesh_->triangleCount());
  for (Index t = 0; t < mesh_->triangleCount(); ++t) {
    const auto& [a, b, c] = mesh_->triangles()[t];
    const glm::dvec3 center = (positions[a] + positions[b] + positions[c]) / 3.0;
    places.push_back(curvePlace(center, low, scale) << 32 | t);
  }
  std::sort(places.begin(), places.end());
  order_.reserve(places.size());
  for (const std::uint64_t place : places) order_.push_back(static_cast<Index>(place));

  buildLeaves();
  while (levels_.back().size() > 1) {
    const std::vector<Box>& lower = levels_.back();
    std::vector<Box> upper;
    upper.reserve((lower.size() + 1) / 2);
    for (std::size_t i = 0; i < lower.size(); i += 2) {
      Box box = lower[i];
      const Box& other = lower[std::min(i + 1, lower.size() - 1)];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], other.low[axis]);
        box.high[axis] = std::max(box.high[axis], other.high[axis]);
      }
      upper.push_back(box);
    }
    levels_.push_back(std::move(upper));
  }
}

void TriangleTree::buildLeaves() {
  std::vector<Box>& leaves = levels_.emplace_back();
  leaves.reserve((order_.size() + kLeaf - 1) / kLeaf);
  for (std::size_t begin = 0; begin < order_.size(); begin += kLeaf) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (std::size_t i = begin; i < std::min(begin + kLeaf, order_.size()); ++i) {
      for (const Index v : mesh_->triangles()[order_[i]]) {
        low = glm::min(low, mesh_->positions()[v]);
        high = glm::max(high, mesh_->positions()[v]);
      }
    }
    leaves.push_back({{below(low.x), below(low.y), below(low.z)},
                      {above(high.x), above(high.y), above(high.z)}});
  }
}

std::optional<TriangleTree::Hit>
TriangleTree::first(const glm::dvec3& from, const glm::dvec3& to,
                    const std::function<bool(Index)>& counts) const {
  const Ray ray(from, to);
  if (order_.empty() || ray.degenerate()) return std::nullopt;
  struct Node {
    std::size_t level, number;
    double entry;
  };
  // A level leaves at most one box behind.
  std::array<Node, 64> stack;
  std::size_t waiting = 0;
  double nearest = 1;
  Index found = kNone;
  const auto push = [&](std::size_t level, std::size_t number, double entry) {
    if (entry <= nearest) stack[waiting++] = {level, number, entry};
  };
  const std::size_t top = levels_.size() - 1;
  push(top, 0, ray.entry(levels_[top][0], nearest));
  while (waiting > 0) {
    const Node node = stack[--waiting];
    if (node.entry > nearest) continue;
    if (node.level > 0) {
      const std::vector<Box>& lower = levels_[node.level - 1];
      const std::size_t one = 2 * node.number, other = one + 1;
      const double a = ray.entry(lower[one], nearest);
      const double b = other < lower.size() ? ray.entry(lower[other], nearest) : Ray::kMissed;
      // The nearer one on top.
      push(node.level - 1, a <= b ? other : one, std::max(a, b));
      push(node.level - 1, a <= b ? one : other, std::min(a, b));
      continue;
    }
    const std::size_t end = std::min((node.number + 1) * kLeaf, order_.size());
    for (std::size_t i = node.number * kLeaf; i < end; ++i) {
      const Index t = order_[i];
      const auto& [a, b, c] = mesh_->triangles()[t];
      const auto p = mesh_->positions();
      const double share = ray.meets(p[a], p[b], p[c]);
      const bool nearer = share < nearest || (share == nearest && t < found);
      if (!nearer || (counts && !counts(t))) continue;
      nearest = share;
      found = t;
    }
  }
  if (found == kNone) return std::nullopt;
  return Hit{found, ray.at(nearest)};
}

}  // namespace chartflood
