#include "core/model/needless_corners.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "core/base/parallel.h"
#include "core/model/position_table.h"

namespace chartflood {

namespace {

constexpr std::size_t kPointEdgeBlock = 1 << 15;

/// Ends of an edge, the smaller vertex first, and the corner at which it ends.
struct PointEdge {
  Index least, most;
  std::size_t corner;
};

/// Edges of no length between different vertices.
std::vector<PointEdge> pointEdges(const InputMesh& input) {
  std::vector<PointEdge> edges;
  std::mutex mutex;
  parallelBlocks(input.faceCount(), kPointEdgeBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::span<const Index> face = input.face(f);
      const std::size_t first = static_cast<std::size_t>(face.data() - input.corners.data());
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::size_t to = i + 1 == face.size() ? 0 : i + 1;
        const Index a = face[i], b = face[to];
        if (a == b || !samePlace(input.positions[a], input.positions[b])) continue;
        std::lock_guard lock(mutex);
        edges.push_back({std::min(a, b), std::max(a, b), first + to});
      }
    }
  });
  std::sort(edges.begin(), edges.end(), [](const PointEdge& x, const PointEdge& y) {
    if (x.least != y.least) return x.least < y.least;
    return x.most != y.most ? x.most < y.most : x.corner < y.corner;
  });
  return edges;
}

/// Of edges between given places: how often faces run along them.
class PlaceEdges {
 public:
  void add(const glm::dvec3& a, const glm::dvec3& b) {
    uses_[keyOf(table_.indexOf(a), table_.indexOf(b))];
  }
  void count(const glm::dvec3& a, const glm::dvec3& b, int uses) {
    const Index from = table_.find(a), to = table_.find(b);
    if (from == kNone || to == kNone) return;
    const auto edge = uses_.find(keyOf(from, to));
    if (edge != uses_.end()) edge->second += uses;
  }
  int uses(const glm::dvec3& a, const glm::dvec3& b) const {
    const auto edge = uses_.find(keyOf(table_.find(a), table_.find(b)));
    return edge == uses_.end() ? 0 : edge->second;
  }

 private:
  static std::pair<Index, Index> keyOf(Index a, Index b) { return std::minmax(a, b); }

  PositionTable table_;
  std::map<std::pair<Index, Index>, int> uses_;
};

/// Keeps a triangle that would be left out for its edge of no length unless two other faces, its
/// neighbours, then meet in its place.
void keepLoneTriangles(const InputMesh& input, std::vector<std::size_t>& corners) {
  const auto place = [&](std::size_t f, std::size_t i) -> const glm::dvec3& {
    return input.positions[input.face(f)[i % input.face(f).size()]];
  };
  struct Thin {
    std::size_t corner, face, third;
  };
  std::vector<Thin> thin;
  for (const std::size_t corner : corners) {
    std::size_t face = corner / 3;
    if (!input.faceStart.empty()) {
      const auto after = std::upper_bound(input.faceStart.begin(), input.faceStart.end(), corner);
      face = static_cast<std::size_t>(after - input.faceStart.begin()) - 1;
    }
    if (input.face(face).size() != 3) continue;
    const std::size_t first =
        static_cast<std::size_t>(input.face(face).data() - input.corners.data());
    thin.push_back({corner, face, corner - first + 1});
  }
  if (thin.empty()) return;
  PlaceEdges edges;
  for (const Thin& t : thin) edges.add(place(t.face, t.third), place(t.face, t.third + 1));
  for (std::size_t f = 0; f < input.faceCount(); ++f) {
    for (std::size_t i = 0; i < input.face(f).size(); ++i) {
      edges.count(place(f, i), place(f, i + 1), 1);
    }
  }
  for (const Thin& t : thin) {
    edges.count(place(t.face, t.third), place(t.face, t.third + 1), -2);
  }
  std::erase_if(corners, [&](std::size_t corner) {
    const auto t = std::lower_bound(thin.begin(), thin.end(), corner,
                                    [](const Thin& x, std::size_t c) { return x.corner < c; });
    if (t == thin.end() || t->corner != corner) return false;
    return edges.uses(place(t->face, t->third), place(t->face, t->third + 1)) != 2;
  });
}

}  // namespace

std::vector<std::size_t> needlessCorners(const InputMesh& input) {
  const std::vector<PointEdge> edges = pointEdges(input);
  std::vector<std::size_t> corners;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end].least == edges[i].least &&
           edges[end].most == edges[i].most) {
      ++end;
    }
    if (end - i == 1) corners.push_back(edges[i].corner);
  }
  std::sort(corners.begin(), corners.end());
  keepLoneTriangles(input, corners);
  return corners;
}

}  // namespace chartflood
