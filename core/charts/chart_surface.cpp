#include "core/charts/chart_surface.h"

#include <glm/geometric.hpp>

#include "core/base/check.h"

namespace chartflood {

namespace {

/// The first side of the fan around the start of `side`, clockwise from it; `side` itself in a
/// closed fan.
Index firstOfFan(const ChartSurface& s, Index side) {
  for (Index back = side;;) {
    const Index other = s.opposite[back];
    if (other == kNone) return back;
    back = ChartSurface::nextSide(other);
    if (back == side) return side;
  }
}

/// Makes `vertex` the corner of all triangles in the fan around the start of `side`.
void giveFan(ChartSurface& s, Index side, Index vertex, std::vector<bool>& visited) {
  const Index first = firstOfFan(s, side);
  Index turn = first;
  do {
    visited[turn] = true;
    s.triangles[turn / 3][turn % 3] = vertex;
    turn = s.opposite[ChartSurface::previousSide(turn)];
  } while (turn != kNone && turn != first);
}

/// Triangles, diagonals and neighbours of every chart; vertices are still those of the mesh.
std::vector<ChartSurface> cutOut(const Mesh& mesh, std::span<const Index> label,
                                 std::size_t chartCount) {
  std::vector<ChartSurface> surfaces(chartCount);
  std::vector<Index> local(mesh.triangleCount(), kNone);
  const auto chartOf = [&](Index triangle) { return label[mesh.faceOf(triangle)]; };
  std::vector<std::size_t> size(chartCount, 0);
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (chartOf(t) != kNone) ++size[chartOf(t)];
  }
  for (std::size_t c = 0; c < chartCount; ++c) {
    surfaces[c].meshTriangle.reserve(size[c]);
    surfaces[c].triangles.reserve(size[c]);
  }
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (chartOf(t) == kNone) continue;
    ChartSurface& s = surfaces[chartOf(t)];
    local[t] = static_cast<Index>(s.meshTriangle.size());
    s.meshTriangle.push_back(t);
    s.triangles.push_back(mesh.triangles()[t]);
  }
  for (ChartSurface& s : surfaces) {
    s.opposite.resize(3 * s.triangleCount(), kNone);
    if (!mesh.facesAreTriangles()) s.diagonal.resize(s.opposite.size(), false);
    for (Index side = 0; side < s.opposite.size(); ++side) {
      const Index t = s.meshTriangle[side / 3];
      const Index other = mesh.opposite()[s.meshSide(side)];
      if (other == kNone || chartOf(other / 3) != chartOf(t)) continue;
      s.opposite[side] = 3 * local[other / 3] + other % 3;
      if (!s.diagonal.empty()) s.diagonal[side] = mesh.isDiagonal(s.meshSide(side));
    }
  }
  return surfaces;
}

/// Gives every fan of a surface with the mesh's vertices one of its own.
void numberVertices(const Mesh& mesh, ChartSurface& s) {
  std::vector<bool> visited(s.opposite.size(), false);
  for (Index side = 0; side < s.opposite.size(); ++side) {
    if (visited[side]) continue;
    const Index vertex = static_cast<Index>(s.positions.size());
    const Index meshVertex = s.sideStart(side);
    s.meshVertex.push_back(meshVertex);
    s.positions.push_back(mesh.positions()[meshVertex]);
    giveFan(s, side, vertex, visited);
  }
  // Charts of large models stay for long.
  s.meshVertex.shrink_to_fit();
  s.positions.shrink_to_fit();
}

}  // namespace

std::vector<ChartSurface> extractCharts(const Mesh& mesh, std::span<const Index> label,
                                        std::size_t chartCount) {
  CF_CHECK(label.size() == mesh.faceCount());
  std::vector<ChartSurface> surfaces = cutOut(mesh, label, chartCount);
  for (ChartSurface& surface : surfaces) numberVertices(mesh, surface);
  return surfaces;
}

void openAlong(ChartSurface& s, std::span<const Index> sides) {
  std::vector<bool> touched(s.vertexCount(), false);
  for (const Index side : sides) {
    const Index other = s.opposite[side];
    if (other == kNone) continue;
    CF_CHECK(!s.isDiagonal(side));
    s.opposite[side] = s.opposite[other] = kNone;
    touched[s.sideStart(side)] = touched[s.sideEnd(side)] = true;
  }
  // The first fan that is met keeps the number of its vertex.
  std::vector<bool> kept(s.vertexCount(), false), visited(s.opposite.size(), false);
  for (Index side = 0; side < s.opposite.size(); ++side) {
    const Index old = s.sideStart(side);
    if (visited[side] || old >= touched.size() || !touched[old]) continue;
    Index vertex = old;
    if (kept[old]) {
      vertex = static_cast<Index>(s.positions.size());
      const glm::dvec3 position = s.positions[old];
      s.positions.push_back(position);
      s.meshVertex.push_back(s.meshVertex[old]);
    }
    kept[old] = true;
    giveFan(s, side, vertex, visited);
  }
}

std::vector<std::vector<Index>> boundaryLoops(const ChartSurface& s) {
  std::vector<std::vector<Index>> loops;
  std::vector<bool> seen(s.opposite.size(), false);
  for (Index start = 0; start < s.opposite.size(); ++start) {
    if (s.opposite[start] != kNone || seen[start]) continue;
    std::vector<Index>& loop = loops.emplace_back();
    for (Index side = start; !seen[side];) {
      seen[side] = true;
      loop.push_back(side);
      // Turn about the side's end to the next boundary side.
      side = ChartSurface::nextSide(side);
      while (s.opposite[side] != kNone) side = ChartSurface::nextSide(s.opposite[side]);
    }
  }
  return loops;
}

ChartTopology topologyOf(const ChartSurface& s) {
  ChartTopology topology;
  std::size_t boundarySides = 0;
  for (const Index other : s.opposite) boundarySides += other == kNone ? 1 : 0;
  const std::size_t edges = (s.opposite.size() + boundarySides) / 2;
  topology.euler = static_cast<long>(s.vertexCount()) - static_cast<long>(edges) +
                   static_cast<long>(s.triangleCount());
  topology.boundaryLoops = boundaryLoops(s).size();
  std::vector<bool> reached(s.triangleCount(), false);
  std::vector<Index> stack;
  for (Index t = 0; t < s.triangleCount(); ++t) {
    if (reached[t]) continue;
    ++topology.pieces;
    reached[t] = true;
    stack.push_back(t);
    while (!stack.empty()) {
      const Index at = stack.back();
      stack.pop_back();
      for (Index side = 3 * at; side < 3 * at + 3; ++side) {
        const Index other = s.opposite[side];
        if (other == kNone || reached[other / 3]) continue;
        reached[other / 3] = true;
        stack.push_back(other / 3);
      }
    }
  }
  return topology;
}

double sideLength(const ChartSurface& s, Index side) {
  return glm::length(s.positions[s.sideEnd(side)] - s.positions[s.sideStart(side)]);
}

}  // namespace chartflood
