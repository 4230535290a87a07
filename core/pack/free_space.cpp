#include "core/pack/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace chartflood {

namespace {

/// Cost of a cell's distance: overlap is dear, and so is, a little, being far from everything.
static float kOverlapCost = getenv("OC") ? (float)atof(getenv("OC")) : 30;
static float kSnugReach = getenv("SR") ? (float)atof(getenv("SR")) : 0.08f;

}  // namespace

const int FreeSpace::kCells = getenv("CELLS") ? atoi(getenv("CELLS")) : 72;

FreeSpace::FreeSpace(double side, double gap, double border)
    : side_(side), cell_(side / kCells), gap_(gap), border_(border), stride_(kCells + 2 * kFrame) {
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
  const double reach =
      std::hypot(std::max(std::abs(field.x0), std::abs(field.x0 + static_cast<float>(field.nx) * field.cell)),
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
  // A bounded number of points, in an order that sees all sides early.
  std::vector<std::size_t> chosen;
  const std::size_t wanted = std::min<std::size_t>(shape.points.size(), 48);
  for (std::size_t k = 0; k < wanted; ++k) chosen.push_back(k * 19 % wanted);
  if (wanted % 19 == 0) {
    for (std::size_t k = 0; k < wanted; ++k) chosen[k] = k;
  }
  static const float DP = getenv("DP") ? (float)atof(getenv("DP")) : 0.8f;
  const float room = shape.deepest.length * DP;
  Pose best;
  float bestCost = INFINITY;
  std::vector<int> offsets(wanted);
  for (int turn = 0; turn < turns; ++turn) {
    const double angle = firstAngle + turn * 2 * std::numbers::pi / turns;
    const double c = std::cos(angle), s = std::sin(angle);
    int left = 0, right = 0, bottom = 0, top = 0;
    for (std::size_t k = 0; k < wanted; ++k) {
      const PackShape::Point& p = shape.points[chosen[k] * shape.points.size() / wanted];
      const int i = static_cast<int>(std::lround((c * p.x - s * p.y) / cell_));
      const int j = static_cast<int>(std::lround((s * p.x + c * p.y) / cell_));
      left = std::min(left, i), right = std::max(right, i);
      bottom = std::min(bottom, j), top = std::max(top, j);
      offsets[k] = j * stride_ + i;
    }
    const int deepest = static_cast<int>(std::lround((s * shape.deepest.x + c * shape.deepest.y) / cell_)) * stride_ +
                        static_cast<int>(std::lround((c * shape.deepest.x - s * shape.deepest.y) / cell_));
    const int slack = 2;
    const int i0 = std::max(kFrame - slack - left, -left);
    const int i1 = std::min(kFrame + kCells + slack - right, stride_ - 1 - right);
    const int j0 = std::max(kFrame - slack - bottom, -bottom);
    const int j1 = std::min(kFrame + kCells + slack - top, stride_ - 1 - top);
    for (int j = j0; j <= j1; ++j) {
      for (int i = i0; i <= i1; ++i) {
        const int at = j * stride_ + i;
        if (distance_[static_cast<std::size_t>(at + deepest)] < room) continue;
        float cost = 0;
        for (std::size_t k = 0; k < wanted && cost < bestCost; ++k) {
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
