#include "core/param/coarse_chart.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr double kLeastTurn = 0.2;      // cosine between a triangle's normals before and after
constexpr double kLeastHeight = 0.02;   // of a triangle, over its longest edge
constexpr double kShortEdges = 1e-3;    // how much the way counts that a vertex moves
constexpr std::size_t kMostEdges = 16;  // at a vertex

/// Squared distances to planes, weighted with the areas they stand for.
struct Quadric {
  std::array<double, 6> square{};  // xx xy xz yy yz zz
  glm::dvec3 linear{0};
  double constant = 0;
  double area = 0;

  void add(const glm::dvec3& normal, const glm::dvec3& point, double weight) {
    const double d = -glm::dot(normal, point);
    const glm::dvec3 n = weight * normal;
    square[0] += n.x * normal.x;
    square[1] += n.x * normal.y;
    square[2] += n.x * normal.z;
    square[3] += n.y * normal.y;
    square[4] += n.y * normal.z;
    square[5] += n.z * normal.z;
    linear += d * n;
    constant += weight * d * d;
    area += weight;
  }
  void add(const Quadric& other) {
    for (std::size_t i = 0; i < square.size(); ++i) square[i] += other.square[i];
    linear += other.linear;
    constant += other.constant;
    area += other.area;
  }
  double at(const glm::dvec3& p) const {
    return p.x * (square[0] * p.x + 2 * (square[1] * p.y + square[2] * p.z)) +
           p.y * (square[3] * p.y + 2 * square[4] * p.z) + square[5] * p.z * p.z +
           2 * glm::dot(linear, p) + constant;
  }
};

class Coarsening {
 public:
  explicit Coarsening(const ChartSurface& chart)
      : chart_(chart), triangles_(chart.triangles), live_(chart.triangleCount()),
        gone_(chart.triangleCount(), false), around_(chart.vertexCount()),
        quadric_(chart.vertexCount()), fixed_(chart.vertexCount(), false),
        queued_(chart.vertexCount(), false), mark_(chart.vertexCount(), kNone) {
    for (Index t = 0; t < triangles_.size(); ++t) {
      const auto& v = triangles_[t];
      const glm::dvec3 cross = crossOf(v);
      const double length = glm::length(cross);
      for (int i = 0; i < 3; ++i) {
        around_[v[i]].push_back(t);
        if (length > 0) quadric_[v[i]].add(cross / length, place(v[i]), length / 6);
        if (chart.opposite[3 * t + static_cast<Index>(i)] != kNone) continue;
        fixed_[v[i]] = fixed_[v[(i + 1) % 3]] = true;
      }
    }
  }

  void run(std::size_t wanted) {
    for (Index v = 0; v < fixed_.size(); ++v) {
      if (!fixed_[v]) enqueue(v);
    }
    while (live_ > wanted && !queue_.empty()) {
      const auto [cost, vertex] = queue_.top();
      queue_.pop();
      // Costs only grow while vertices around go: they are looked at again when it is their turn.
      const double now = bestTarget(vertex, false).first;
      if (now > cost * (1 + 1e-9) && !queue_.empty() && now > queue_.top().first) {
        queue_.push({now, vertex});
        continue;
      }
      queued_[vertex] = false;
      const Index target = bestTarget(vertex, true).second;
      if (target != kNone) collapse(vertex, target);
    }
  }

  ChartSurface result() const {
    ChartSurface coarse;
    std::vector<Index> number(fixed_.size(), kNone);
    for (Index t = 0; t < triangles_.size(); ++t) {
      if (gone_[t]) continue;
      std::array<Index, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = triangles_[t][i];
        if (number[v] == kNone) {
          number[v] = static_cast<Index>(coarse.positions.size());
          coarse.positions.push_back(place(v));
          coarse.meshVertex.push_back(v);
        }
        triangle[i] = number[v];
      }
      coarse.meshTriangle.push_back(static_cast<Index>(coarse.triangles.size()));
      coarse.triangles.push_back(triangle);
    }
    glue(coarse);
    return coarse;
  }

 private:
  using Entry = std::pair<double, Index>;

  const glm::dvec3& place(Index v) const { return chart_.positions[v]; }
  glm::dvec3 crossOf(const std::array<Index, 3>& t) const {
    return glm::cross(place(t[1]) - place(t[0]), place(t[2]) - place(t[0]));
  }

  /// The neighbour onto which an inner vertex moves at the least cost; with `allowed` only one onto
  /// which it may.
  std::pair<double, Index> bestTarget(Index vertex, bool allowed) {
    std::pair<double, Index> best{std::numeric_limits<double>::infinity(), kNone};
    for (const Index t : around_[vertex]) {
      const Index target = after(t, vertex);
      const glm::dvec3 way = place(target) - place(vertex);
      const double cost = quadric_[vertex].at(place(target)) + quadric_[target].at(place(target)) +
                          kShortEdges * quadric_[vertex].area * glm::dot(way, way);
      if (std::pair(cost, target) >= best) continue;
      if (!allowed || mayCollapse(vertex, target)) best = {cost, target};
    }
    return best;
  }

  /// The corner after a vertex in one of its triangles.
  Index after(Index triangle, Index vertex) const {
    const auto& t = triangles_[triangle];
    return t[0] == vertex ? t[1] : t[1] == vertex ? t[2] : t[0];
  }

  bool mayCollapse(Index vertex, Index target) {
    for (const Index t : around_[target]) {
      for (const Index v : triangles_[t]) mark_[v] = vertex;
    }
    std::size_t common = 0;
    for (const Index t : around_[vertex]) {
      const Index v = after(t, vertex);
      if (v != target && mark_[v] == vertex) ++common;
    }
    for (const Index t : around_[target]) {
      for (const Index v : triangles_[t]) mark_[v] = kNone;
    }
    if (common != 2 || around_[vertex].size() + around_[target].size() > kMostEdges + 4)
      return false;
    return std::all_of(around_[vertex].begin(), around_[vertex].end(),
                       [&](Index t) { return staysUpright(t, vertex, target); });
  }

  bool staysUpright(Index triangle, Index vertex, Index target) const {
    std::array<Index, 3> moved = triangles_[triangle];
    if (std::find(moved.begin(), moved.end(), target) != moved.end()) return true;
    const glm::dvec3 before = crossOf(moved);
    std::replace(moved.begin(), moved.end(), vertex, target);
    const glm::dvec3 now = crossOf(moved);
    const double length = glm::length(now);
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 edge = place(moved[(i + 1) % 3]) - place(moved[i]);
      longest = std::max(longest, glm::dot(edge, edge));
    }
    return length > kLeastHeight * longest &&
           glm::dot(before, now) >= kLeastTurn * glm::length(before) * length;
  }

  void collapse(Index vertex, Index target) {
    quadric_[target].add(quadric_[vertex]);
    for (const Index t : around_[vertex]) {
      auto& corners = triangles_[t];
      if (std::find(corners.begin(), corners.end(), target) == corners.end()) {
        std::replace(corners.begin(), corners.end(), vertex, target);
        around_[target].push_back(t);
        continue;
      }
      gone_[t] = true;
      --live_;
      for (const Index v : corners) {
        if (v != vertex) std::erase(around_[v], t);
      }
    }
    around_[vertex].clear();
    // Those that could not go before may now.
    for (const Index t : around_[target]) {
      for (const Index v : triangles_[t]) {
        if (!fixed_[v] && !queued_[v]) enqueue(v);
      }
    }
  }

  void enqueue(Index vertex) {
    queued_[vertex] = true;
    queue_.push({bestTarget(vertex, false).first, vertex});
  }

  /// Finds the side across each side.
  static void glue(ChartSurface& surface) {
    std::vector<std::pair<std::uint64_t, Index>> sides;
    surface.opposite.assign(3 * surface.triangleCount(), kNone);
    for (Index s = 0; s < surface.opposite.size(); ++s) {
      const Index a = surface.sideStart(s), b = surface.sideEnd(s);
      sides.emplace_back(std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), s);
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      if (sides[i].first != sides[i + 1].first) continue;
      surface.opposite[sides[i].second] = sides[i + 1].second;
      surface.opposite[sides[i + 1].second] = sides[i].second;
    }
  }

  const ChartSurface& chart_;
  std::vector<std::array<Index, 3>> triangles_;
  std::size_t live_;
  std::vector<bool> gone_;                  ///< triangles
  std::vector<std::vector<Index>> around_;  ///< triangles at each vertex
  std::vector<Quadric> quadric_;            ///< of each vertex
  std::vector<bool> fixed_;                 ///< on the boundary
  std::vector<bool> queued_;                ///< waits in the queue
  std::vector<Index> mark_;                 ///< of each vertex, kNone between uses
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

ChartSurface coarseChart(const ChartSurface& chart, std::size_t triangles) {
  Coarsening coarsening(chart);
  coarsening.run(triangles);
  return coarsening.result();
}

}  // namespace chartflood
