#include "core/pack/squeeze.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

namespace {

constexpr double kFirstStep = 0.15, kLargestStep = 0.6;
constexpr double kFirstMixing = 0.1;
constexpr double kSideMass = 1.5;
}  // namespace

Squeezer::Squeezer(std::span<const PackShape> shapes, const PackGaps& gaps)
    : shapes_(shapes), contacts_(shapes, gaps),
      sideInCharts_(std::sqrt(layoutArea(shapes.size()))) {
  for (const PackShape& shape : shapes) {
    const double mass = std::max<double>(shape.perimeter, 1e-6);
    const double radius = std::max<double>(shape.radius, 1e-6);
    inverseRoot_.push_back(1 / std::sqrt(mass));
    inverseRoot_.push_back(1 / std::sqrt(mass));
    inverseRoot_.push_back(1 / (std::sqrt(0.5 * mass) * radius));
  }
  inverseRoot_.push_back(1 / std::sqrt(kSideMass));
  rest();
}

void Squeezer::step(PackLayout& layout, const SqueezeOptions& options) {
  contacts_.push(layout, options.skin);
  const std::size_t count = shapes_.size();
  double sideForce = contacts_.sidePush() - options.pressure;
  for (std::size_t i = 0; i < count; ++i) {
    const ShapePush& push = contacts_.pushes()[i];
    force_[3 * i] = push.x * inverseRoot_[3 * i];
    force_[3 * i + 1] = push.y * inverseRoot_[3 * i + 1];
    force_[3 * i + 2] = push.torque * inverseRoot_[3 * i + 2];
    // Places grow with the side.
    sideForce += (push.x * layout.poses[i].x + push.y * layout.poses[i].y) / layout.side;
  }
  force_[3 * count] = sideForce * inverseRoot_[3 * count];
  double power = 0, forceSquare = 0, speedSquare = 0;
  for (std::size_t k = 0; k < force_.size(); ++k) {
    velocity_[k] += dt_ * force_[k];
    power += force_[k] * velocity_[k];
    forceSquare += force_[k] * force_[k];
    speedSquare += velocity_[k] * velocity_[k];
  }
  if (power > 0) {
    const double along = forceSquare > 0 ? mixing_ * std::sqrt(speedSquare / forceSquare) : 0;
    for (std::size_t k = 0; k < force_.size(); ++k) {
      velocity_[k] = (1 - mixing_) * velocity_[k] + along * force_[k];
    }
    if (++downhill_ > 5) dt_ = std::min(dt_ * 1.1, kLargestStep), mixing_ *= 0.99;
  } else {
    std::fill(velocity_.begin(), velocity_.end(), 0.0);
    dt_ *= 0.5, mixing_ = kFirstMixing, downhill_ = 0;
    dt_ = std::max(dt_, 0.02);
  }
  // The side goes faster the more charts there are along it.
  double farthest = std::abs(velocity_[3 * count] * inverseRoot_[3 * count]) / sideInCharts_;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = shapes_[i].radius;
    for (int k = 0; k < 3; ++k) {
      farthest = std::max(farthest, std::abs(velocity_[3 * i + k] * inverseRoot_[3 * i + k]) *
                                        (k == 2 ? radius : 1.0));
    }
  }
  if (farthest * dt_ > 0.01) {
    const double slow = 0.01 / (farthest * dt_);
    for (double& v : velocity_) v *= slow;
  }
  const double newSide = std::max(
      layout.side + dt_ * velocity_[3 * count] * inverseRoot_[3 * count], 0.5 * layout.side);
  const double grow = newSide / layout.side;
  for (std::size_t i = 0; i < count; ++i) {
    Pose& pose = layout.poses[i];
    pose.x = grow * pose.x + dt_ * velocity_[3 * i] * inverseRoot_[3 * i];
    pose.y = grow * pose.y + dt_ * velocity_[3 * i + 1] * inverseRoot_[3 * i + 1];
    pose.angle += dt_ * velocity_[3 * i + 2] * inverseRoot_[3 * i + 2];
  }
  layout.side = newSide;
}

void Squeezer::rest() {
  force_.assign(3 * shapes_.size() + 1, 0.0);
  velocity_.assign(3 * shapes_.size() + 1, 0.0);
  dt_ = kFirstStep, mixing_ = kFirstMixing, downhill_ = 0;
}

void Squeezer::run(PackLayout& layout, const SqueezeOptions& options, const Progress& progress) {
  for (int i = 0; i < options.steps && !progress.cancelled(); ++i) {
    step(layout, options);
  }
}

}  // namespace chartflood
