#include "core/pack/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace chartflood {

namespace {

/// Parts of a layout unit in which distances are counted.
constexpr float kPerRoom = 8192;
constexpr short kFarAway = 32767;
/// Overlap is dear, and so is, a little, being far from everything: costs of a distance that is
/// missing or to spare, and the most that counts of either.
constexpr short kOverlapCost = 2, kPerSnugCost = 8;
constexpr short kMostOverlap = 348, kSnugReach = 655;
/// Most points of a shape that are looked at; their costs add up to what a short holds.
constexpr std::size_t kMostPoints = 47;
static_assert(kMostPoints * kOverlapCost * kMostOverlap < 32767);
/// Where overlap is barred, one point of it costs more than all others far from everything.
constexpr short kPerBarredSnug = 64;
static_assert(kMostPoints * kSnugReach / kPerBarredSnug < kOverlapCost * kMostOverlap);

constexpr int kLanes = static_cast<int>(kShortLanes);
constexpr int kMostCells = 1024;

short roomOf(double distance) {
  return static_cast<short>(std::clamp(distance * kPerRoom, -32767.0, 32767.0));
}

/// A bounded number of a shape's points, in an order that sees all sides early.
std::vector<PackShape::Point> spreadPoints(const PackShape& shape) {
  constexpr std::size_t kStride = 19;  // a prime, as the most is: every point comes once
  const std::size_t count = std::min(shape.points.size(), kMostPoints);
  const std::size_t stride = count % kStride == 0 ? 1 : kStride;
  std::vector<PackShape::Point> points;
  points.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    points.push_back(shape.points[k * stride % count * shape.points.size() / count]);
  }
  return points;
}

}  // namespace

/// A shape at one turn, in cells: where its points lie from its centre, and the box around them.
struct FreeSpace::Stamp {
  int offsets[kMostPoints];
  std::size_t count = 0;
  int deepest = 0, deepestI = 0, deepestJ = 0;
  int left = 0, right = 0, bottom = 0, top = 0;

  Stamp(const PackShape& shape, std::span<const PackShape::Point> points, double angle, double cell,
        int stride) {
    const float c = static_cast<float>(std::cos(angle) / cell);
    const float s = static_cast<float>(std::sin(angle) / cell);
    int i = 0, j = 0;
    const auto offsetOf = [&](const PackShape::Point& p) {
      i = static_cast<int>(std::floor(c * p.x - s * p.y + 0.5f));
      j = static_cast<int>(std::floor(s * p.x + c * p.y + 0.5f));
      left = std::min(left, i), right = std::max(right, i);
      bottom = std::min(bottom, j), top = std::max(top, j);
      return j * stride + i;
    };
    deepest = offsetOf(shape.deepest);
    deepestI = i, deepestJ = j;
    for (const PackShape::Point& p : points) offsets[count++] = offsetOf(p);
  }
};

FreeSpace::FreeSpace(double side, double gap, double border, double cell, Overlap overlap)
    : cells_(std::clamp(static_cast<int>(side / cell) / kLanes * kLanes, kLanes, kMostCells)),
      stride_(cells_ + 2 * kFrame), side_(side), cell_(side / cells_), need_(roomOf(gap * 1.27)),
      leastOverlap_(overlap == Overlap::Barred ? kMostOverlap : 0) {
  const std::size_t count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_);
  room_.resize(count + kShortLanes);  // all lanes are read at once: the last ones, and beyond
  cost_.resize(count + kShortLanes);
  std::vector<short> byCells(static_cast<std::size_t>(stride_));
  for (int i = 0; i < stride_; ++i) {
    // The sides need less space than shapes do.
    byCells[static_cast<std::size_t>(i)] =
        roomOf((std::min(i, stride_ - 1 - i) - kFrame + 0.5) * cell_ - border + gap);
  }
  short* room = room_.data();
  for (const short row : byCells) {
    for (const short column : byCells) *room++ = std::min(row, column);
  }
  for (std::size_t at = 0; at < room_.size(); at += kShortLanes) findCosts(at);
  const std::size_t blocks = static_cast<std::size_t>(stride_ / kLanes);
  spans_.resize(blocks * blocks);
  open_.resize(blocks);
  findSpans(0, stride_, 0, stride_);
}

Footprint FreeSpace::footprint(const PackShape& shape, const Pose& pose) const {
  const DistanceField& field = shape.field;
  // Cells to nodes: u = u0 + c * i + s * j, v = v0 - s * i + c * j; nodes to cells the other way.
  const double perCell = cell_ / field.cell;
  const double c = perCell * std::cos(pose.angle), s = perCell * std::sin(pose.angle);
  const double x = (0.5 - kFrame) * cell_ - side_ / 2 - pose.x;
  const double y = (0.5 - kFrame) * cell_ - side_ / 2 - pose.y;
  const double u0 = (c * x + s * y) / cell_ - field.x0 / field.cell + 0.5;
  const double v0 = (c * y - s * x) / cell_ - field.y0 / field.cell + 0.5;
  double low[2] = {1.0 * stride_, 1.0 * stride_}, high[2] = {0, 0};
  for (const double u : {0 - u0, field.nx - u0}) {
    for (const double v : {0 - v0, field.ny - v0}) {
      const double at[2] = {(c * u - s * v) / (perCell * perCell),
                            (s * u + c * v) / (perCell * perCell)};
      for (int k = 0; k < 2; ++k)
        low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
    }
  }
  const auto cellOf = [this](double at) {
    return static_cast<int>(std::clamp<double>(at, 0, stride_));
  };
  Footprint print;
  print.left = cellOf(low[0]) / kLanes * kLanes, print.bottom = cellOf(low[1]);
  print.width = std::max(0, (cellOf(high[0] + 1) - print.left + kLanes - 1) / kLanes * kLanes);
  print.height = std::max(0, cellOf(high[1] + 1) - print.bottom);
  print.room.resize(static_cast<std::size_t>(print.width) * static_cast<std::size_t>(print.height));
  const float perNodeU = static_cast<float>(c), perNodeV = static_cast<float>(-s);
  const float right = static_cast<float>(field.nx), top = static_cast<float>(field.ny);
  for (int j = 0; j < print.height; ++j) {
    const float u = static_cast<float>(u0 + c * print.left + s * (print.bottom + j));
    const float v = static_cast<float>(v0 - s * print.left + c * (print.bottom + j));
    short* row = &print.room[static_cast<std::size_t>(j * print.width)];
    for (int i = 0; i < print.width; ++i) {
      const float fu = u + perNodeU * static_cast<float>(i),
                  fv = v + perNodeV * static_cast<float>(i);
      const bool inside = fu >= 0 && fv >= 0 && fu < right && fv < top;
      row[i] = inside
                   ? static_cast<short>(std::min(
                         kPerRoom * field.at(static_cast<int>(fu), static_cast<int>(fv)), 32767.f))
                   : kFarAway;
    }
  }
  return print;
}

void FreeSpace::add(const Footprint& print) {
  for (int j = 0; j < print.height; ++j) {
    const std::size_t first = static_cast<std::size_t>((print.bottom + j) * stride_ + print.left);
    const short* row = &print.room[static_cast<std::size_t>(j * print.width)];
    for (int i = 0; i < print.width; i += kLanes) {
      const std::size_t at = first + static_cast<std::size_t>(i);
      const ShortLanes least =
          smaller(loadLanes<ShortLanes>(&room_[at]), loadLanes<ShortLanes>(row + i));
      std::memcpy(&room_[at], &least, sizeof least);
      findCosts(at);
    }
  }
  findSpans(print.left, print.left + print.width, print.bottom, print.bottom + print.height);
}

void FreeSpace::findSpans(int left, int right, int bottom, int top) {
  for (int row = bottom / kLanes * kLanes; row < top; row += kLanes) {
    for (int column = left; column < right; column += kLanes) {
      const short* cells = &room_[static_cast<std::size_t>(row * stride_ + column)];
      ShortLanes least = loadLanes<ShortLanes>(cells), most = least;
      for (int j = 1; j < kLanes; ++j) {
        const ShortLanes room = loadLanes<ShortLanes>(cells + j * stride_);
        least = smaller(least, room), most = larger(most, room);
      }
      Span span{least[0], most[0]};
      for (int lane = 1; lane < kLanes; ++lane) {
        span.least = std::min<short>(span.least, least[lane]);
        span.most = std::max<short>(span.most, most[lane]);
      }
      spans_[static_cast<std::size_t>((row / kLanes) * (stride_ / kLanes) + column / kLanes)] =
          span;
    }
  }
}

void FreeSpace::findCosts(std::size_t at) {
  const ShortLanes mostOverlap = ShortLanes{} + kMostOverlap, reach = ShortLanes{} + kSnugReach;
  // Far inside shapes, a distance less the gap may be less than what a short holds.
  const ShortLanes room = larger(loadLanes<ShortLanes>(&room_[at]), ShortLanes{} - short{16384});
  const ShortLanes free = room - need_;
  const ShortLanes snug = leastOverlap_ == 0 ? smaller(free, reach) / kPerSnugCost
                                             : smaller(free, reach) / kPerBarredSnug;
  const ShortLanes cost =
      free < 0 ? kOverlapCost * larger(smaller(-free, mostOverlap), ShortLanes{} + leastOverlap_)
               : snug;
  std::memcpy(&cost_[at], &cost, sizeof cost);
}

/// Sums of a stamp's costs at eight places side by side; stops where none can be below `best`.
ShortLanes FreeSpace::costOf(const Stamp& stamp, const short* costs, short best) {
  constexpr std::size_t kBetweenLooks = 6;
  ShortLanes cost{};
  for (std::size_t k = 0; k < stamp.count;) {
    const std::size_t end = std::min(k + kBetweenLooks, stamp.count);
    for (; k < end; ++k) cost += loadLanes<ShortLanes>(costs + stamp.offsets[k]);
    if (!anyOf(cost < best)) break;
  }
  return cost;
}

Pose FreeSpace::bestPose(const PackShape& shape, double firstAngle, int turns) {
  const std::vector<PackShape::Point> points = spreadPoints(shape);
  // Where the deepest point does not fit, by far, nothing else needs a look; nor where so much is
  // free around it that the shape lies snug to nothing.
  const float far = shape.radius + std::hypot(shape.deepest.x, shape.deepest.y);
  const Room room{roomOf(0.8 * shape.deepest.length),
                  roomOf(far + static_cast<float>(kSnugReach) / kPerRoom)};
  Best best;
  for (int turn = 0; turn < turns; ++turn) {
    const double angle = firstAngle + turn * 2 * std::numbers::pi / turns;
    lookAt(Stamp(shape, points, angle, cell_, stride_), angle, room, best);
  }
  return best.pose;
}

bool FreeSpace::fits(const PackShape& shape, const Pose& pose) const {
  const double c = std::cos(pose.angle), s = std::sin(pose.angle);
  const auto cellOf = [this](double at) {
    return std::clamp(static_cast<int>(std::floor((at + side_ / 2) / cell_)) + kFrame, 0,
                      stride_ - 1);
  };
  const auto free = [&](const PackShape::Point& p) {
    const int i = cellOf(pose.x + c * p.x - s * p.y), j = cellOf(pose.y + s * p.x + c * p.y);
    return room_[static_cast<std::size_t>(j * stride_ + i)] >= need_;
  };
  if (!std::all_of(shape.points.begin(), shape.points.end(), free)) return false;
  // What lies between the shape's points: a cell in both shapes has less than no room.
  const Footprint print = footprint(shape, pose);
  for (int j = 0; j < print.height; ++j) {
    const int at = (print.bottom + j) * stride_ + print.left;
    for (int i = 0; i < print.width; ++i) {
      const int own = print.room[static_cast<std::size_t>(j * print.width + i)];
      if (own + room_[static_cast<std::size_t>(at + i)] < 0) return false;
    }
  }
  return true;
}

void FreeSpace::lookAt(const Stamp& stamp, double angle, const Room& room, Best& best) {
  constexpr int kSlack = 2, kFirst = kFrame - kSlack;
  const int last = kFrame + cells_ + kSlack;
  const Places places{kFirst - stamp.left + stamp.deepestI, last - stamp.right + stamp.deepestI,
                      kFirst - stamp.bottom + stamp.deepestJ, last - stamp.top + stamp.deepestJ};
  if (places.left > places.right) return;
  for (int row = places.bottom / kLanes; row * kLanes <= places.top; ++row) {
    // Most of a square that fills up is no place for the deepest point: whole blocks are left out.
    open_.clear();
    for (int column = places.left / kLanes; column * kLanes <= places.right; ++column) {
      const Span& span = spans_[static_cast<std::size_t>(row * (stride_ / kLanes) + column)];
      if (span.most >= room.least && span.least <= room.most) open_.push_back(column * kLanes);
    }
    if (open_.empty()) continue;
    const int end = std::min(row * kLanes + kLanes - 1, places.top);
    for (int j = std::max(row * kLanes, places.bottom); j <= end; ++j) {
      lookAtRow(stamp, j, places, angle, room, best);
    }
  }
}

/// \param j row of the deepest point
void FreeSpace::lookAtRow(const Stamp& stamp, int j, const Places& places, double angle,
                          const Room& room, Best& best) {
  looks_ += open_.size();
  for (const int i : open_) {
    const int deepest = j * stride_ + i, at = deepest - stamp.deepest;
    const ShortLanes around = loadLanes<ShortLanes>(&room_[static_cast<std::size_t>(deepest)]);
    const ShortLanes fits = (around >= room.least) & (around <= room.most);
    if (!anyOf(fits)) continue;
    const ShortLanes cost = costOf(stamp, &cost_[static_cast<std::size_t>(at)], best.cost);
    if (!anyOf((cost < best.cost) & fits)) continue;
    const int begin = std::max(0, places.left - i), end = std::min(kLanes, places.right + 1 - i);
    for (int lane = begin; lane < end; ++lane) {
      if (fits[lane] == 0 || cost[lane] >= best.cost) continue;
      best.cost = cost[lane];
      best.pose = {(i + lane - stamp.deepestI - kFrame + 0.5) * cell_ - side_ / 2,
                   (j - stamp.deepestJ - kFrame + 0.5) * cell_ - side_ / 2, angle};
    }
  }
}

}  // namespace chartflood
