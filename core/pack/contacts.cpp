#include "core/pack/contacts.h"

#include <algorithm>
#include <cmath>

#include "core/pack/lanes.h"

namespace chartflood {

namespace {

/// How far pairs of shapes are looked for beyond the gap, layout units.
constexpr double kPairSkin = 0.05;
/// Depth from which a point pushes no harder, layout units.
constexpr float kFullDepth = 0.04f;
constexpr float kRootTwo = 1.41421357f;

/// Force of a point a unit of its length: deep points, which are few, push more than in proportion.
FloatLanes pushOf(FloatLanes depth) {
  constexpr float kPerStiffDepth = 1e4f, kStiffest = 10;
  return smaller(depth, FloatLanes{} + kFullDepth) *
         (1 + smaller(depth * kPerStiffDepth, FloatLanes{} + kStiffest));
}

double distance(const Pose& a, const Pose& b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return std::sqrt(x * x + y * y);
}

}  // namespace

Contacts::Contacts(std::span<const PackShape> shapes, const PackGaps& gaps)
    : shapes_(shapes), gaps_(gaps), frames_(shapes.size()), pushes_(shapes.size()),
      depths_(shapes.size()) {}

void Contacts::setFrames(const PackLayout& layout) {
  gap_ = static_cast<float>(gaps_.between * layout.side);
  wall_ = static_cast<float>((0.5 - gaps_.border) * layout.side);
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Pose& pose = layout.poses[i];
    frames_[i] = {static_cast<float>(pose.x), static_cast<float>(pose.y),
                  static_cast<float>(std::cos(pose.angle)),
                  static_cast<float>(std::sin(pose.angle))};
  }
}

bool Contacts::pairsHold(const PackLayout& layout) const {
  if (pairedAt_.empty()) return false;
  const double reach = kPairSkin / 2 - std::max(0.0, layout.side - pairedSide_) * gaps_.between;
  for (std::size_t i = 0; i < pairedAt_.size(); ++i) {
    if (distance(layout.poses[i], pairedAt_[i]) > reach) return false;
  }
  return true;
}

Contacts::Group Contacts::makeGroup(Index field, Index points) {
  const Group group{field, points, columnCount_};
  const std::size_t count = shapes_[points].points.size();
  columnCount_ += (count + kFloatLanes - 1) / kFloatLanes * kFloatLanes;
  return group;
}

void Contacts::findPairs(const PackLayout& layout) {
  std::vector<std::pair<Index, Index>> found;
  const Index count = static_cast<Index>(shapes_.size());
  std::vector<Index> byX(count);
  for (Index i = 0; i < count; ++i) byX[i] = i;
  const auto left = [&](Index i) { return layout.poses[i].x - shapes_[i].radius; };
  std::sort(byX.begin(), byX.end(),
            [&](Index a, Index b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
  const double reach = gaps_.between * layout.side * kRootTwo + kPairSkin + skin_;
  for (Index k = 0; k < count; ++k) {
    const Index a = byX[k];
    const double right = layout.poses[a].x + shapes_[a].radius + reach;
    for (Index l = k + 1; l < count && left(byX[l]) < right; ++l) {
      const Index b = byX[l];
      const double near = shapes_[a].radius + shapes_[b].radius + reach;
      if (distance(layout.poses[a], layout.poses[b]) < near) {
        found.emplace_back(std::min(a, b), std::max(a, b));
      }
    }
  }
  std::sort(found.begin(), found.end());
  pairs_.clear();
  walls_.clear();
  columnCount_ = 0;
  constexpr Pose kNowhere{INFINITY, 0, 0};
  for (const auto& [a, b] : found) {
    pairs_.push_back({makeGroup(a, b), makeGroup(b, a), {kNowhere, kNowhere}});
  }
  for (Index i = 0; i < count; ++i) walls_.push_back({makeGroup(i, i), kNowhere, 0});
  columns_.resize(columnCount_);
  pairedAt_ = layout.poses;
  pairedSide_ = layout.side;
}

double Contacts::moved(Index shape, const Pose& from, const Pose& to) const {
  return distance(from, to) + shapes_[shape].radius * std::abs(to.angle - from.angle);
}

void Contacts::push(const PackLayout& layout, double skin) {
  if (skin != skin_) pairedAt_.clear();
  skin_ = skin;
  setFrames(layout);
  if (!pairsHold(layout)) findPairs(layout);
  std::fill(pushes_.begin(), pushes_.end(), ShapePush());
  std::fill(depths_.begin(), depths_.end(), 0.0f);
  energy_ = 0, sidePush_ = 0, depth_ = 0;
  for (Pair& pair : pairs_) {
    const Index a = pair.first.field, b = pair.second.field;
    const Pose &poseA = layout.poses[a], &poseB = layout.poses[b];
    if (!(moved(a, pair.at[0], poseA) + moved(b, pair.at[1], poseB) < skin)) {
      findInField(pair.first);
      findInField(pair.second);
      pair.at[0] = poseA, pair.at[1] = poseB;
    }
    if (pair.first.count > 0) pushFromField(pair.first);
    if (pair.second.count > 0) pushFromField(pair.second);
  }
  for (Wall& wall : walls_) {
    const Index i = wall.group.points;
    if (!(moved(i, wall.at, layout.poses[i]) + std::abs(layout.side - wall.side) / 2 < skin)) {
      findAtWalls(wall.group);
      wall.at = layout.poses[i], wall.side = layout.side;
    }
    if (wall.group.count > 0) pushFromWalls(wall.group);
  }
}

void Contacts::findInField(Group& group) {
  const Index fieldOf = group.field, pointsOf = group.points;
  const PackShape& other = shapes_[pointsOf];
  const DistanceField& field = shapes_[fieldOf].field;
  const Frame &a = frames_[fieldOf], &b = frames_[pointsOf];
  // From b's own axes into a's.
  const float c = a.cos * b.cos + a.sin * b.sin, s = a.cos * b.sin - a.sin * b.cos;
  const float dx = b.x - a.x, dy = b.y - a.y;
  const float tx = a.cos * dx + a.sin * dy, ty = a.cos * dy - a.sin * dx;
  const float skin = static_cast<float>(skin_);
  const float farthest = gap_ * kRootTwo + skin;
  const float right = static_cast<float>(field.nx - 1), top = static_cast<float>(field.ny - 1);
  std::size_t end = group.begin;
  // Whether all points in a circle about (x, y) are farther away than contacts are looked for.
  const auto allFar = [&](float x, float y, float radius) {
    const float rx = (c * x - s * y + tx - field.x0) * field.perCell;
    const float ry = (s * x + c * y + ty - field.y0) * field.perCell;
    const float size = radius * field.perCell;
    if (rx < -size || ry < -size || rx > right + size || ry > top + size) return true;
    const int ni = std::clamp(static_cast<int>(rx + 0.5f), 0, field.nx - 1);
    const int nj = std::clamp(static_cast<int>(ry + 0.5f), 0, field.ny - 1);
    const float off =
        std::max(std::abs(rx - static_cast<float>(ni)), std::abs(ry - static_cast<float>(nj)));
    return field.at(ni, nj) > farthest + radius + kRootTwo * off * field.cell;
  };
  if (allFar(0, 0, other.radius)) return fill(group, end);
  for (const PackShape::Run& run : other.runs) {
    if (allFar(run.x, run.y, run.radius)) continue;
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
      const float away = lower + v * (upper - lower);
      if (away >= farthest) continue;
      float nx = (d10 - d00) * (1 - v) + (d11 - d01) * v, ny = upper - lower;
      const float norm = std::sqrt(nx * nx + ny * ny);
      if (norm < 1e-12f) continue;
      nx /= norm, ny /= norm;
      const float wx = a.cos * nx - a.sin * ny, wy = a.sin * nx + a.cos * ny;
      if (away >= gap_ * (std::abs(wx) + std::abs(wy)) + skin) continue;
      columns_.set(end++, p, nx, ny, away - nx * qx - ny * qy);
    }
  }
  fill(group, end);
}

void Contacts::findAtWalls(Group& group) {
  const Index index = group.points;
  const Frame& frame = frames_[index];
  const PackShape& shape = shapes_[index];
  const float near = wall_ - static_cast<float>(skin_);
  if (std::max(std::abs(frame.x), std::abs(frame.y)) + shape.radius <= near) return;
  std::size_t end = group.begin;
  for (const PackShape::Run& run : shape.runs) {
    const float rx = frame.cos * run.x - frame.sin * run.y + frame.x;
    const float ry = frame.sin * run.x + frame.cos * run.y + frame.y;
    if (std::max(std::abs(rx), std::abs(ry)) + run.radius <= near) continue;
    for (unsigned k = run.begin; k < run.end; ++k) {
      const PackShape::Point& p = shape.points[k];
      const float x = frame.cos * p.x - frame.sin * p.y + frame.x;
      const float y = frame.sin * p.x + frame.cos * p.y + frame.y;
      if (std::max(std::abs(x), std::abs(y)) > near) columns_.set(end++, p, 0, 0, 0);
    }
  }
  fill(group, end);
}

void Contacts::Columns::set(std::size_t i, const PackShape::Point& p, float normalX, float normalY,
                            float from) {
  x[i] = p.x, y[i] = p.y, length[i] = p.length;
  nx[i] = normalX, ny[i] = normalY, at[i] = from;
}

void Contacts::Columns::resize(std::size_t count) {
  for (std::vector<float>* column : {&x, &y, &length, &nx, &ny, &at}) {
    if (column->size() < count) column->resize(count);
  }
}

/// Ends a group with points that stand for nothing, and so push nothing.
void Contacts::fill(Group& group, std::size_t end) {
  for (; (end - group.begin) % kFloatLanes != 0; ++end) columns_.set(end, {0, 0, 0}, 0, 0, 0);
  group.count = end - group.begin;
}

void Contacts::pushFromField(const Group& group) {
  const Frame &a = frames_[group.field], &b = frames_[group.points];
  const float c = a.cos * b.cos + a.sin * b.sin, s = a.cos * b.sin - a.sin * b.cos;
  const float dx = b.x - a.x, dy = b.y - a.y;
  const float tx = a.cos * dx + a.sin * dy, ty = a.cos * dy - a.sin * dx;
  FloatLanes fx{}, fy{}, torque{}, energy{}, side{}, deepest{};
  for (std::size_t k = group.begin; k < group.begin + group.count; k += kFloatLanes) {
    const FloatLanes x = loadLanes<FloatLanes>(&columns_.x[k]),
                     y = loadLanes<FloatLanes>(&columns_.y[k]);
    const FloatLanes nx = loadLanes<FloatLanes>(&columns_.nx[k]),
                     ny = loadLanes<FloatLanes>(&columns_.ny[k]);
    const FloatLanes qx = c * x - s * y + tx, qy = s * x + c * y + ty;
    const FloatLanes away = loadLanes<FloatLanes>(&columns_.at[k]) + nx * qx + ny * qy;
    const FloatLanes stretch =
        magnitude(a.cos * nx - a.sin * ny) + magnitude(a.sin * nx + a.cos * ny);
    const FloatLanes depth = larger(gap_ * stretch - away, FloatLanes{});
    const FloatLanes push = loadLanes<FloatLanes>(&columns_.length[k]) * pushOf(depth);
    deepest = larger(deepest, depth);
    energy += push * depth;
    side += push * stretch;
    fx += push * nx, fy += push * ny;
    torque += push * (qx * ny - qy * nx);
  }
  const float total = sumOf(energy);
  if (total == 0) return;
  const float depth = largestOf(deepest);
  const bool smaller = shapes_[group.field].area < shapes_[group.points].area;
  float& deepestOf = depths_[smaller ? group.field : group.points];
  deepestOf = std::max(deepestOf, depth);
  depth_ = std::max(depth_, depth);
  const float ownX = sumOf(fx), ownY = sumOf(fy), turn = sumOf(torque);
  const float wx = a.cos * ownX - a.sin * ownY, wy = a.sin * ownX + a.cos * ownY;
  ShapePush &onA = pushes_[group.field], &onB = pushes_[group.points];
  onA.x -= wx, onA.y -= wy, onA.torque -= turn;
  onB.x += wx, onB.y += wy, onB.torque += turn - (tx * ownY - ty * ownX);
  energy_ += total;
  sidePush_ -= gaps_.between * sumOf(side);
}

void Contacts::pushFromWalls(const Group& group) {
  const Frame& frame = frames_[group.points];
  FloatLanes fx{}, fy{}, torque{}, energy{}, side{}, deepest{};
  for (std::size_t k = group.begin; k < group.begin + group.count; k += kFloatLanes) {
    const FloatLanes px = loadLanes<FloatLanes>(&columns_.x[k]),
                     py = loadLanes<FloatLanes>(&columns_.y[k]);
    const FloatLanes x = frame.cos * px - frame.sin * py, y = frame.sin * px + frame.cos * py;
    const FloatLanes deepX = larger(magnitude(x + frame.x) - wall_, FloatLanes{});
    const FloatLanes deepY = larger(magnitude(y + frame.y) - wall_, FloatLanes{});
    // Twice the force: a wall has no field of its own to push with.
    const FloatLanes twice = 2 * loadLanes<FloatLanes>(&columns_.length[k]);
    const FloatLanes pushX = twice * pushOf(deepX), pushY = twice * pushOf(deepY);
    const FloatLanes forceX = x + frame.x > 0 ? -pushX : pushX;
    const FloatLanes forceY = y + frame.y > 0 ? -pushY : pushY;
    deepest = larger(deepest, larger(deepX, deepY));
    fx += forceX, fy += forceY;
    torque += x * forceY - y * forceX;
    energy += pushX * deepX + pushY * deepY;
    side += pushX + pushY;
  }
  const float depth = largestOf(deepest);
  depths_[group.points] = std::max(depths_[group.points], depth);
  depth_ = std::max(depth_, depth);
  ShapePush& push = pushes_[group.points];
  push.x += sumOf(fx), push.y += sumOf(fy), push.torque += sumOf(torque);
  energy_ += sumOf(energy);
  sidePush_ += (0.5 - gaps_.border) * sumOf(side);
}

}  // namespace chartflood
