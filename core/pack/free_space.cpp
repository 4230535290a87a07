#include "core/pack/free_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chartflood {

namespace {

/// Cost of a cell's distance: overlap is dear, and so is, a little, being far from everything.
constexpr float kOverlapCost = 15;
constexpr float kSnugReach = 0.08f;

/// A bounded number of a shape's points, in an order that sees all sides early.
std::vector<PackShape::Point> spreadPoints(const PackShape& shape) {
  constexpr std::size_t kMost = 47, kStride = 19;  // primes: every point comes once
  const std::size_t count = std::min(shape.points.size(), kMost);
  const std::size_t stride = count % kStride == 0 ? 1 : kStride;
  std::vector<PackShape::Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    points.push_back(shape.points[k * stride % count * shape.points.size() / count]);
  }
  return points;
}

}  // namespace

FreeSpace::FreeSpace(double side, double gap, double border)
    : side_(side), cell_(side / kCells), gap_(gap), stride_(kCells + 2 * kFrame) {
  distance_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_));
  for (int j = 0; j < stride_; ++j) {
    for (int i = 0; i < stride_; ++i) {
      const double x = (i - kFrame + 0.5) * cell_, y = (j - kFrame + 0.5) * cell_;
      const double inside = std::min(std::min(x, side - x), std::min(y, side - y));
      // The sides need less space than shapes do.
      distance_[static_cast<std::size_t>(j * stride_ + i)] =
          static_cast<float>(inside - border + gap);
    }
  }
}

void FreeSpace::add(const PackShape& shape, const Pose& pose) {
  const DistanceField& field = shape.field;
  const double c = std::cos(pose.angle), s = std::sin(pose.angle);
  const double half = side_ / 2;
  const double reach = std::hypot(
      std::max(std::abs(field.x0), std::abs(field.x0 + static_cast<float>(field.nx) * field.cell)),
      std::max(std::abs(field.y0), std::abs(field.y0 + static_cast<float>(field.ny) * field.cell)));
  const auto cellOf = [&](double v) {
    return std::clamp(static_cast<int>(std::floor((v + half) / cell_)) + kFrame, 0, stride_ - 1);
  };
  for (int j = cellOf(pose.y - reach); j <= cellOf(pose.y + reach); ++j) {
    for (int i = cellOf(pose.x - reach); i <= cellOf(pose.x + reach); ++i) {
      const double x = (i - kFrame + 0.5) * cell_ - half - pose.x;
      const double y = (j - kFrame + 0.5) * cell_ - half - pose.y;
      const double qx = c * x + s * y, qy = c * y - s * x;
      const int u = static_cast<int>((qx - field.x0) * field.perCell + 0.5);
      const int v = static_cast<int>((qy - field.y0) * field.perCell + 0.5);
      if (qx < field.x0 || qy < field.y0 || u >= field.nx || v >= field.ny) continue;
      float& distance = distance_[static_cast<std::size_t>(j * stride_ + i)];
      distance = std::min(distance, field.at(u, v));
    }
  }
}

Pose FreeSpace::bestPose(const PackShape& shape, double firstAngle, int turns) {
  cost_.resize(distance_.size());
  const float need = static_cast<float>(gap_ * 1.27);
  for (std::size_t i = 0; i < cost_.size(); ++i) {
    const float free = distance_[i] - need;
    cost_[i] = free < 0 ? kOverlapCost * -free : std::min(free, kSnugReach);
  }
  const std::vector<PackShape::Point> points = spreadPoints(shape);
  // Where the deepest point does not fit, by far, nothing else needs a look.
  const float room = 0.8f * shape.deepest.length;
  Pose best;
  float bestCost = INFINITY;
  std::vector<int> offsets(points.size());
  for (int turn = 0; turn < turns; ++turn) {
    const double angle = firstAngle + turn * 2 * std::numbers::pi / turns;
    const double c = std::cos(angle), s = std::sin(angle);
    const PackShape::Point& d = shape.deepest;
    const int di = static_cast<int>(std::lround((c * d.x - s * d.y) / cell_));
    const int dj = static_cast<int>(std::lround((s * d.x + c * d.y) / cell_));
    const int deepest = dj * stride_ + di;
    int left = std::min(0, di), right = std::max(0, di);
    int bottom = std::min(0, dj), top = std::max(0, dj);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const PackShape::Point& p = points[k];
      const int i = static_cast<int>(std::lround((c * p.x - s * p.y) / cell_));
      const int j = static_cast<int>(std::lround((s * p.x + c * p.y) / cell_));
      left = std::min(left, i), right = std::max(right, i);
      bottom = std::min(bottom, j), top = std::max(top, j);
      offsets[k] = j * stride_ + i;
    }
    constexpr int slack = 2;
    const int i0 = std::max(kFrame - slack - left, -left);
    const int i1 = std::min(kFrame + kCells + slack - right, stride_ - 1 - right);
    const int j0 = std::max(kFrame - slack - bottom, -bottom);
    const int j1 = std::min(kFrame + kCells + slack - top, stride_ - 1 - top);
    for (int j = j0; j <= j1; ++j) {
      for (int i = i0; i <= i1; ++i) {
        const int at = j * stride_ + i;
        if (distance_[static_cast<std::size_t>(at + deepest)] < room) continue;
        float cost = 0;
        for (std::size_t k = 0; k < offsets.size() && cost < bestCost; ++k) {
          cost += cost_[static_cast<std::size_t>(at + offsets[k])];
        }
        if (cost >= bestCost) continue;
        bestCost = cost;
        best = {(i - kFrame + 0.5) * cell_ - side_ / 2, (j - kFrame + 0.5) * cell_ - side_ / 2,
                angle};
      }
    }
  }
  return best;
}

}  // namespace chartflood
