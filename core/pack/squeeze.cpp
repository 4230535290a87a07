#include "core/pack/squeeze.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

namespace {

constexpr double kFirstStep = 0.15, kLargestStep = 0.6;
constexpr double kFirstMixing = 0.1;
constexpr double kSideMass = 1.5;
/// Depth from which a point pushes no harder, layout units.
constexpr float kFullDepth = 0.04f;
constexpr float kRootTwo = 1.41421357f;

/// Force of a point a unit of its length: deep points, which are few, push more than in proportion.
float pushOf(float depth) {
  constexpr float kStiffDepth = 1e-4f, kStiffest = 10;
  return std::min(depth, kFullDepth) * (1 + std::min(depth / kStiffDepth, kStiffest));
}

}  // namespace

Squeezer::Squeezer(std::span<const PackShape> shapes, const PackGaps& gaps)
    : shapes_(shapes), gaps_(gaps), items_(shapes.size()) {
  for (const PackShape& shape : shapes) {
    const double mass = std::max<double>(shape.perimeter, 1e-6);
    const double radius = std::max<double>(shape.radius, 1e-6);
    inverseRoot_.push_back(1 / std::sqrt(mass));
    inverseRoot_.push_back(1 / std::sqrt(mass));
    inverseRoot_.push_back(1 / (std::sqrt(0.5 * mass) * radius));
  }
  inverseRoot_.push_back(1 / std::sqrt(kSideMass));
}

void Squeezer::findPairs(const PackLayout& layout, double skin) {
  pairs_.clear();
  const Index count = static_cast<Index>(shapes_.size());
  std::vector<Index> byX(count);
  for (Index i = 0; i < count; ++i) byX[i] = i;
  const auto left = [&](Index i) { return layout.poses[i].x - shapes_[i].radius; };
  std::sort(byX.begin(), byX.end(),
            [&](Index a, Index b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
  const double reach = gaps_.between * layout.side * kRootTwo + skin;
  for (Index k = 0; k < count; ++k) {
    const Index a = byX[k];
    const double right = layout.poses[a].x + shapes_[a].radius + reach;
    for (Index l = k + 1; l < count && left(byX[l]) < right; ++l) {
      const Index b = byX[l];
      const double dx = layout.poses[a].x - layout.poses[b].x;
      const double dy = layout.poses[a].y - layout.poses[b].y;
      const double near = shapes_[a].radius + shapes_[b].radius + reach;
      if (dx * dx + dy * dy < near * near) pairs_.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairedAt_ = layout.poses;
  pairedSide_ = layout.side;
}

void Squeezer::pushFromField(Index fieldOf, Index pointsOf) {
  const PackShape& owner = shapes_[fieldOf];
  const PackShape& other = shapes_[pointsOf];
  const DistanceField& field = owner.field;
  Item& a = items_[fieldOf];
  Item& b = items_[pointsOf];
  // From b's own axes into a's.
  const float c = a.cos * b.cos + a.sin * b.sin, s = a.cos * b.sin - a.sin * b.cos;
  const float dx = b.x - a.x, dy = b.y - a.y;
  const float tx = a.cos * dx + a.sin * dy, ty = a.cos * dy - a.sin * dx;
  const float farthest = gap_ * kRootTwo;
  const float right = static_cast<float>(field.nx - 1), top = static_cast<float>(field.ny - 1);
  float fx = 0, fy = 0, torqueA = 0, torqueB = 0, energy = 0, sideForce = 0;
  const float gapPerSide = static_cast<float>(gaps_.between);
  for (const PackShape::Run& run : other.runs) {
    const float rx = (c * run.x - s * run.y + tx - field.x0) * field.perCell;
    const float ry = (s * run.x + c * run.y + ty - field.y0) * field.perCell;
    const float size = run.radius * field.perCell;
    if (rx < -size || ry < -size || rx > right + size || ry > top + size) continue;
    const int ni = std::clamp(static_cast<int>(rx + 0.5f), 0, field.nx - 1);
    const int nj = std::clamp(static_cast<int>(ry + 0.5f), 0, field.ny - 1);
    const float off =
        std::max(std::abs(rx - static_cast<float>(ni)), std::abs(ry - static_cast<float>(nj)));
    if (field.at(ni, nj) > farthest + run.radius + kRootTwo * off * field.cell) continue;
    for (unsigned k = run.begin; k < run.end; ++k) {
      const PackShape::Point& p = other.points[k];
      const float qx = c * p.x - s * p.y + tx, qy = s * p.x + c * p.y + ty;
      const float gx = (qx - field.x0) * field.perCell, gy = (qy - field.y0) * field.perCell;
      if (!(gx >= 0 && gy >= 0 && gx < right && gy < top)) continue;
      const int i = static_cast<int>(gx), j = static_cast<int>(gy);
      const float u = gx - static_cast<float>(i), v = gy - static_cast<float>(j);
      const float* row = &field.value[static_cast<std::size_t>(j * field.nx + i)];
      const float d00 = row[0], d10 = row[1], d01 = row[field.nx], d11 = row[field.nx + 1];
      const float lower = d00 + u * (d10 - d00), upper = d01 + u * (d11 - d01);
      const float distance = lower + v * (upper - lower);
      if (distance >= farthest) continue;
      float nx = (d10 - d00) * (1 - v) + (d11 - d01) * v, ny = upper - lower;
      const float norm = std::sqrt(nx * nx + ny * ny);
      if (norm < 1e-12f) continue;
      nx /= norm, ny /= norm;
      const float wx = a.cos * nx - a.sin * ny, wy = a.sin * nx + a.cos * ny;
      const float stretch = std::abs(wx) + std::abs(wy);
      const float depth = gap_ * stretch - distance;
      if (depth <= 0) continue;
      const float push = p.length * pushOf(depth);
      energy += push * depth, depth_ = std::max(depth_, depth);
      sideForce -= push * gapPerSide * stretch;
      fx += push * nx, fy += push * ny;
      torqueA -= push * (qx * ny - qy * nx);
      torqueB += push * ((qx - tx) * ny - (qy - ty) * nx);
    }
  }
  if (energy == 0) return;
  const float wx = a.cos * fx - a.sin * fy, wy = a.sin * fx + a.cos * fy;
  a.fx -= wx, a.fy -= wy, a.torque += torqueA;
  b.fx += wx, b.fy += wy, b.torque += torqueB;
  energy_ += energy;
  sideForce_ += sideForce;
}

void Squeezer::pushFromWalls(Index index) {
  Item& item = items_[index];
  const PackShape& shape = shapes_[index];
  if (std::max(std::abs(item.x), std::abs(item.y)) + shape.radius <= wall_) return;
  const double perSide = 0.5 - gaps_.border;
  for (const PackShape::Run& run : shape.runs) {
    const float rx = item.cos * run.x - item.sin * run.y + item.x;
    const float ry = item.sin * run.x + item.cos * run.y + item.y;
    if (std::max(std::abs(rx), std::abs(ry)) + run.radius <= wall_) continue;
    for (unsigned k = run.begin; k < run.end; ++k) {
      const PackShape::Point& p = shape.points[k];
      const float x = item.cos * p.x - item.sin * p.y, y = item.sin * p.x + item.cos * p.y;
      const float deepX = std::abs(x + item.x) - wall_, deepY = std::abs(y + item.y) - wall_;
      if (deepX > 0) {
        // Twice the force: a wall has no field of its own to push with.
        const float push = 2 * p.length * pushOf(deepX);
        const float force = x + item.x > 0 ? -push : push;
        item.fx += force, item.torque -= y * force;
        energy_ += push * deepX, depth_ = std::max(depth_, deepX), sideForce_ += perSide * push;
      }
      if (deepY > 0) {
        const float push = 2 * p.length * pushOf(deepY);
        const float force = y + item.y > 0 ? -push : push;
        item.fy += force, item.torque += x * force;
        energy_ += push * deepY, depth_ = std::max(depth_, deepY), sideForce_ += perSide * push;
      }
    }
  }
}

void Squeezer::computeForces(const PackLayout& layout) {
  gap_ = static_cast<float>(gaps_.between * layout.side);
  wall_ = static_cast<float>((0.5 - gaps_.border) * layout.side);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Pose& pose = layout.poses[i];
    items_[i] = {static_cast<float>(pose.x),
                 static_cast<float>(pose.y),
                 static_cast<float>(std::cos(pose.angle)),
                 static_cast<float>(std::sin(pose.angle)),
                 0,
                 0,
                 0};
  }
  energy_ = 0, sideForce_ = 0, depth_ = 0;
  for (const auto& [a, b] : pairs_) {
    pushFromField(a, b);
    pushFromField(b, a);
  }
  for (Index i = 0; i < items_.size(); ++i) pushFromWalls(i);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    sideForce_ +=
        (items_[i].fx * layout.poses[i].x + items_[i].fy * layout.poses[i].y) / layout.side;
  }
}

void Squeezer::step(PackLayout& layout, double pressure) {
  computeForces(layout);
  const std::size_t count = items_.size();
  for (std::size_t i = 0; i < count; ++i) {
    force_[3 * i] = items_[i].fx * inverseRoot_[3 * i];
    force_[3 * i + 1] = items_[i].fy * inverseRoot_[3 * i + 1];
    force_[3 * i + 2] = items_[i].torque * inverseRoot_[3 * i + 2];
  }
  force_[3 * count] = (sideForce_ - pressure) * inverseRoot_[3 * count];
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
  double farthest = std::abs(velocity_[3 * count] * inverseRoot_[3 * count]);
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

void Squeezer::run(PackLayout& layout, const SqueezeOptions& options, const Progress& progress) {
  force_.assign(3 * items_.size() + 1, 0.0);
  velocity_.assign(3 * items_.size() + 1, 0.0);
  dt_ = kFirstStep, mixing_ = kFirstMixing, downhill_ = 0;
  const double skin = 0.05;
  findPairs(layout, skin);
  for (int i = 0; i < options.steps && !progress.cancelled(); ++i) {
    step(layout, options.pressure);
    for (std::size_t k = 0; k < layout.poses.size(); ++k) {
      if (std::hypot(layout.poses[k].x - pairedAt_[k].x, layout.poses[k].y - pairedAt_[k].y) >
          skin / 2 - (layout.side - pairedSide_) * gaps_.between) {
        findPairs(layout, skin);
        break;
      }
    }
  }
}

}  // namespace chartflood
