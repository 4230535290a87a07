#include "app/host/state/hint_stroke.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr std::size_t kFarthest = 400;  // vertices that a search for a path looks at

/// Calls visit(side) for every side that starts at a vertex.
template <class Visit>
void forSidesAt(const Mesh& mesh, Index vertex, const Visit& visit) {
  const Index first = mesh.vertexSide()[vertex];
  for (Index s = first; s != kNone;) {
    visit(s);
    s = mesh.turn(s);
    if (s == first) return;
  }
}

/// Ends of the edges at a vertex; on a border the last one is the end of no side that starts there.
std::vector<Index> neighbours(const Mesh& mesh, Index vertex) {
  std::vector<Index> ends;
  forSidesAt(mesh, vertex, [&](Index s) {
    ends.push_back(mesh.sideEnd(s));
    const Index last = Mesh::previousSide(s);
    if (mesh.opposite()[last] == kNone) ends.push_back(mesh.sideStart(last));
  });
  return ends;
}

/// Vertices behind `from` up to `to` on the shortest path; empty when `to` is far.
std::vector<Index> pathBetween(const Mesh& mesh, Index from, Index to) {
  std::map<Index, std::pair<double, Index>> reached{{from, {0, kNone}}};
  std::vector<std::pair<double, Index>> heap{{0, from}};
  const auto later = std::greater<std::pair<double, Index>>();
  for (std::size_t steps = 0; !heap.empty() && steps < kFarthest; ++steps) {
    std::pop_heap(heap.begin(), heap.end(), later);
    const auto [distance, vertex] = heap.back();
    heap.pop_back();
    if (vertex == to) {
      std::vector<Index> path;
      for (Index v = to; v != from; v = reached[v].second) path.push_back(v);
      std::reverse(path.begin(), path.end());
      return path;
    }
    if (distance > reached[vertex].first) continue;
    for (const Index next : neighbours(mesh, vertex)) {
      const double there =
          distance + glm::length(mesh.positions()[vertex] - mesh.positions()[next]);
      const auto known = reached.find(next);
      if (known != reached.end() && known->second.first <= there) continue;
      reached[next] = {there, vertex};
      heap.emplace_back(there, next);
      std::push_heap(heap.begin(), heap.end(), later);
    }
  }
  return {};
}

}  // namespace

std::string hintBrushId(HintBrush brush) {
  return brush == HintBrush::Cut ? "cut" : brush == HintBrush::Never ? "never" : "erase";
}

HintBrush hintBrushFromId(const std::string& id) {
  return id == "cut" ? HintBrush::Cut : id == "never" ? HintBrush::Never : HintBrush::Erase;
}

void leadStroke(const Mesh& mesh, HintStroke& stroke, Index vertex) {
  if (stroke.vertices.empty()) {
    stroke.vertices.push_back(vertex);
    return;
  }
  if (stroke.vertices.back() == vertex) return;
  const std::vector<Index> path = pathBetween(mesh, stroke.vertices.back(), vertex);
  if (path.empty() && stroke.vertices.size() == 1) stroke.vertices = {vertex};
  stroke.vertices.insert(stroke.vertices.end(), path.begin(), path.end());
}

Index nearestCorner(const Mesh& mesh, Index triangle, const glm::dvec3& point) {
  const auto& corners = mesh.triangles()[triangle];
  return *std::min_element(corners.begin(), corners.end(), [&](Index a, Index b) {
    return glm::length(mesh.positions()[a] - point) < glm::length(mesh.positions()[b] - point);
  });
}

std::vector<Index> sidesAlong(const Mesh& mesh, std::span<const Index> vertices) {
  std::vector<Index> sides;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    Index found = kNone;
    forSidesAt(mesh, vertices[i], [&](Index s) {
      if (mesh.sideEnd(s) == vertices[i + 1]) found = s;
    });
    if (found == kNone) {
      forSidesAt(mesh, vertices[i + 1], [&](Index s) {
        if (mesh.sideEnd(s) == vertices[i]) found = s;
      });
    }
    if (found != kNone) sides.push_back(found);
  }
  return sides;
}

std::vector<Index> hintSides(const Mesh& mesh, const EdgeHints& hints, HintKind kind) {
  std::vector<Index> sides;
  if (hints.empty()) return sides;
  for (Index s = 0; s < 3 * mesh.triangleCount(); ++s) {
    if (mesh.edgeOfSide(s) != s && mesh.opposite()[s] != kNone) continue;
    const Index from = mesh.inputVertex(mesh.sideStart(s)), to = mesh.inputVertex(mesh.sideEnd(s));
    const EdgeHint edge{std::min(from, to), std::max(from, to), kind};
    const auto hint = std::lower_bound(hints.begin(), hints.end(), edge);
    if (hint != hints.end() && *hint == edge) sides.push_back(s);
  }
  return sides;
}

}  // namespace chartflood
