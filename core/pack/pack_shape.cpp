#include "core/pack/pack_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

using Polyline = std::vector<glm::dvec2>;

/// The loops of an outline, closed, about the shape's centre and in layout units.
std::vector<Polyline> loopsOf(const ChartOutline& outline, const glm::dvec2& center, double scale) {
  std::vector<Polyline> loops;
  glm::dvec2 last(NAN);
  for (const Segment2& segment : outline.segments) {
    if (segment[0] != last) loops.emplace_back(1, scale * (segment[0] - center));
    loops.back().push_back(scale * (segment[1] - center));
    last = segment[1];
  }
  return loops;
}

double distanceToChord(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 d = b - a;
  const double square = glm::dot(d, d);
  const double t = square > 0 ? std::clamp(glm::dot(p - a, d) / square, 0.0, 1.0) : 0;
  return glm::distance(p, a + t * d);
}

/// Douglas and Peucker's choice of points, without recursion.
Polyline simplified(const Polyline& line, double tolerance) {
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> stack;
  // A closed line begins and ends in one point: split it at the point farthest from there.
  const auto far = std::max_element(line.begin(), line.end(), [&](const auto& a, const auto& b) {
    return glm::distance(a, line.front()) < glm::distance(b, line.front());
  });
  const std::size_t middle = static_cast<std::size_t>(far - line.begin());
  kept[middle] = true;
  stack.emplace_back(0, middle);
  stack.emplace_back(middle, line.size() - 1);
  while (!stack.empty()) {
    const auto [begin, end] = stack.back();
    stack.pop_back();
    double worst = tolerance;
    std::size_t split = 0;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double d = distanceToChord(line[i], line[begin], line[end]);
      if (d > worst) worst = d, split = i;
    }
    if (split == 0) continue;
    kept[split] = true;
    stack.emplace_back(begin, split);
    stack.emplace_back(split, end);
  }
  Polyline result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) result.push_back(line[i]);
  }
  return result;
}

/// Points along a closed line: its corners, and more where they are farther apart than `spacing`.
void appendPoints(std::vector<PackShape::Point>& points, const Polyline& line, double spacing) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = glm::distance(line[i], line[i + 1]);
    const int parts = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    for (int k = 0; k < parts; ++k) {
      const glm::dvec2 p = line[i] + (line[i + 1] - line[i]) * (static_cast<double>(k) / parts);
      points.push_back(
          {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(spacing)});
    }
  }
}

/// Points inside, at least `spacing` from each other and half as much from the outline.
void appendInside(PackShape& shape, float spacing) {
  const DistanceField& field = shape.field;
  const int every = std::max(1, static_cast<int>(spacing / field.cell));
  for (int j = every / 2; j < field.ny; j += every) {
    for (int i = every / 2; i < field.nx; i += every) {
      if (field.at(i, j) > -0.5f * spacing) continue;
      shape.inside.push_back({field.x0 + static_cast<float>(i) * field.cell,
                              field.y0 + static_cast<float>(j) * field.cell, spacing});
    }
  }
}

void appendRuns(PackShape& shape, std::size_t begin) {
  constexpr std::size_t kRun = 8;
  for (; begin < shape.points.size(); begin += kRun) {
    const std::size_t end = std::min(begin + kRun, shape.points.size());
    float x = 0, y = 0, radius = 0;
    for (std::size_t i = begin; i < end; ++i) x += shape.points[i].x, y += shape.points[i].y;
    x /= static_cast<float>(end - begin), y /= static_cast<float>(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      radius = std::max(radius, std::hypot(shape.points[i].x - x, shape.points[i].y - y));
    }
    shape.runs.push_back({x, y, radius, static_cast<unsigned>(begin), static_cast<unsigned>(end)});
  }
}

/// Nearest segment of every node, spread from node to node.
class NearestSegment {
 public:
  NearestSegment(DistanceField& field, const std::vector<Segment2>& segments)
      : field_(field), nearest_(field.value.size(), kFree), square_(field.value.size(), INFINITY) {
    lines_.reserve(segments.size());
    for (const auto& [a, b] : segments) {
      const glm::dvec2 d = b - a;
      const double length = d.x * d.x + d.y * d.y;
      lines_.push_back({a, d, length > 0 ? 1 / length : 0});
    }
  }

  void run() {
    seed();
    for (int j = 0; j < field_.ny; ++j) sweepRow(j, -1);
    for (int j = field_.ny - 1; j >= 0; --j) sweepRow(j, 1);
    for (std::size_t i = 0; i < square_.size(); ++i) {
      field_.value[i] = static_cast<float>(std::sqrt(square_[i]));
    }
  }

 private:
  static constexpr unsigned kFree = 0xFFFFFFFFu;
  struct Line {
    glm::dvec2 from, way;
    double perSquare;  ///< 1 over the square of the length, or 0
  };

  void offer(int i, int j, unsigned segment) {
    if (segment == kFree) return;
    const std::size_t node = static_cast<std::size_t>(j) * static_cast<std::size_t>(field_.nx) +
                             static_cast<std::size_t>(i);
    if (nearest_[node] == segment) return;
    const Line& line = lines_[segment];
    const glm::dvec2& d = line.way;
    const double cell = field_.cell;
    const glm::dvec2 e(field_.x0 + i * cell - line.from.x, field_.y0 + j * cell - line.from.y);
    const double t = std::clamp((e.x * d.x + e.y * d.y) * line.perSquare, 0.0, 1.0);
    const double x = e.x - t * d.x, y = e.y - t * d.y;
    if (x * x + y * y < square_[node]) square_[node] = x * x + y * y, nearest_[node] = segment;
  }
  void seed() {
    for (unsigned k = 0; k < lines_.size(); ++k) {
      const auto& [a, way, perSquare] = lines_[k];
      const int steps = 1 + static_cast<int>(glm::length(way) / field_.cell);
      int lastI = -1, lastJ = -1;
      for (int s = 0; s <= steps; ++s) {
        const glm::dvec2 p = a + way * (static_cast<double>(s) / steps);
        const int i = static_cast<int>(std::floor((p.x - field_.x0) / field_.cell));
        const int j = static_cast<int>(std::floor((p.y - field_.y0) / field_.cell));
        if (i == lastI && j == lastJ) continue;
        lastI = i, lastJ = j;
        for (int y = std::max(0, j - 1); y <= std::min(field_.ny - 1, j + 2); ++y) {
          for (int x = std::max(0, i - 1); x <= std::min(field_.nx - 1, i + 2); ++x) {
            offer(x, y, k);
          }
        }
      }
    }
  }
  /// Takes over the segments of the row `j + dy` and of both neighbours in the row.
  void sweepRow(int j, int dy) {
    const auto of = [this](int x, int y) {
      return nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(field_.nx) +
                      static_cast<std::size_t>(x)];
    };
    const int from = j + dy;
    if (from >= 0 && from < field_.ny) {
      for (int i = 0; i < field_.nx; ++i) {
        for (int x = std::max(0, i - 1); x <= std::min(field_.nx - 1, i + 1); ++x) {
          offer(i, j, of(x, from));
        }
      }
    }
    for (int i = 1; i < field_.nx; ++i) offer(i, j, of(i - 1, j));
    for (int i = field_.nx - 2; i >= 0; --i) offer(i, j, of(i + 1, j));
  }

  DistanceField& field_;
  std::vector<Line> lines_;
  std::vector<unsigned> nearest_;
  std::vector<double> square_;
};

/// Turns the distances of the nodes that the segments wind around negative.
void signField(DistanceField& field, const std::vector<Segment2>& segments) {
  std::vector<std::vector<std::pair<double, int>>> crossings(static_cast<std::size_t>(field.ny));
  for (const auto& [a, b] : segments) {
    const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
    if (low == high) continue;
    const int begin = std::max(0, static_cast<int>(std::ceil((low - field.y0) / field.cell)));
    for (int j = begin; j < field.ny; ++j) {
      const double y = field.y0 + j * static_cast<double>(field.cell);
      if (y >= high) break;
      if (y < low) continue;
      const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
      crossings[static_cast<std::size_t>(j)].emplace_back(x, b.y > a.y ? 1 : -1);
    }
  }
  for (int j = 0; j < field.ny; ++j) {
    auto& row = crossings[static_cast<std::size_t>(j)];
    std::sort(row.begin(), row.end());
    std::size_t next = 0;
    int winding = 0;
    for (int i = 0; i < field.nx; ++i) {
      const double x = field.x0 + i * static_cast<double>(field.cell);
      for (; next < row.size() && row[next].first <= x; ++next) winding += row[next].second;
      float& value = field.value[static_cast<std::size_t>(j) * static_cast<std::size_t>(field.nx) +
                                 static_cast<std::size_t>(i)];
      if (winding != 0) value = -value;
    }
  }
}

}  // namespace

void fillField(DistanceField& field, const std::vector<Segment2>& segments) {
  field.perCell = 1 / field.cell;
  field.value.assign(static_cast<std::size_t>(field.nx) * static_cast<std::size_t>(field.ny), 0);
  NearestSegment(field, segments).run();
  signField(field, segments);
}

PackShape makeShape(const ChartOutline& outline, double scale, const ShapeDetail& detail) {
  PackShape shape;
  shape.center = circleCenter(outline.hull);
  shape.area = static_cast<float>(outline.area * scale * scale);
  constexpr double kBoxy = 0.9;
  const EnclosingBox box = smallestBox(outline.hull);
  shape.boxy = outline.area > kBoxy * box.size.x * box.size.y;
  shape.upright = box.angle;
  const EnclosingSquare square = smallestSquare(outline.hull);
  shape.square = square.side * scale;
  shape.inSquare = square.angle;
  for (std::size_t i = 0; i < outline.hull.size(); ++i) {
    const glm::dvec2& next = outline.hull[(i + 1) % outline.hull.size()];
    shape.around += static_cast<float>(glm::distance(outline.hull[i], next) * scale);
  }
  const std::vector<Polyline> loops = loopsOf(outline, shape.center, scale);
  double length = 0;
  std::vector<Segment2> segments;
  glm::dvec2 low(0), high(0);
  for (const Polyline& loop : loops) {
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
      segments.push_back({loop[i], loop[i + 1]});
      length += glm::distance(loop[i], loop[i + 1]);
      low = {std::min(low.x, loop[i].x), std::min(low.y, loop[i].y)};
      high = {std::max(high.x, loop[i].x), std::max(high.y, loop[i].y)};
    }
  }
  // Small shapes still need points all around.
  const double spacing = std::min<double>(detail.spacing, std::max(length / 16, 1e-9));
  for (const Polyline& loop : loops) {
    const std::size_t first = shape.points.size();
    appendPoints(shape.points, simplified(loop, std::min<double>(detail.tolerance, 0.1 * spacing)),
                 spacing);
    appendRuns(shape, first);
  }
  for (const PackShape::Point& p : shape.points) {
    shape.radius = std::max(shape.radius, std::hypot(p.x, p.y));
    shape.perimeter += p.length;
  }
  DistanceField& field = shape.field;
  const double size = std::max(high.x - low.x, high.y - low.y);
  field.cell = std::min(detail.cell, static_cast<float>(size / 10 + 0.1 * detail.reach + 1e-9));
  const double pad = detail.reach + 1.5 * field.cell;
  field.x0 = static_cast<float>(low.x - pad), field.y0 = static_cast<float>(low.y - pad);
  // Diagonal needles have large boxes.
  constexpr double kMostNodes = 1 << 18;
  const double boxArea = (high.x - low.x + 2 * pad) * (high.y - low.y + 2 * pad);
  field.cell = std::max(field.cell, static_cast<float>(std::sqrt(boxArea / kMostNodes)));
  field.nx = 2 + static_cast<int>((high.x - low.x + 2 * pad) / field.cell);
  field.ny = 2 + static_cast<int>((high.y - low.y + 2 * pad) / field.cell);
  fillField(field, segments);
  appendInside(shape, std::max(0.2f * std::sqrt(shape.area), 2 * field.cell));
  for (int j = 0; j < field.ny; ++j) {
    for (int i = 0; i < field.nx; ++i) {
      if (-field.at(i, j) <= shape.deepest.length) continue;
      shape.deepest = {field.x0 + static_cast<float>(i) * field.cell,
                       field.y0 + static_cast<float>(j) * field.cell, -field.at(i, j)};
    }
  }
  const std::size_t begin = shape.points.size();
  shape.points.insert(shape.points.end(), shape.inside.begin(), shape.inside.end());
  appendRuns(shape, begin);
  return shape;
}

}  // namespace chartflood
