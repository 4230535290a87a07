#include "core/model/build_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/model/glue_edges.h"
#include "core/model/orient_faces.h"
#include "core/model/triangulate_faces.h"
#include "core/model/weld_borders.h"

namespace chartflood {

namespace {

constexpr std::size_t kMeshBlock = 1 << 14;

/// What gluing found, counted for the import report.
struct Findings {
  TriangulationFindings triangulation;
  std::size_t nonManifoldEdges = 0;
  std::size_t flippedEdges = 0;
  std::size_t turnedFaces = 0;
  std::size_t joinedVertices = 0;
  std::size_t splitVertices = 0;
  std::size_t degenerateTriangles = 0;
  std::size_t loneFaces = 0;
  std::size_t isolatedVertices = 0;
  std::vector<Index> brokenTriangles;  ///< with an edge that could not be glued
};

/// Moves the used vertices to the centre of their bounding box and scales its diagonal to 1.
/// \returns how many are not used
std::size_t normalise(const InputMesh& input, MeshData& d) {
  const std::size_t count = input.positions.size();
  std::vector<bool> used(count, false);
  for (const auto& triangle : d.triangles) {
    for (const Index v : triangle) used[v] = true;
  }
  constexpr double inf = std::numeric_limits<double>::infinity();
  glm::dvec3 low(inf), high(-inf);
  for (std::size_t v = 0; v < count; ++v) {
    if (!used[v]) continue;
    const glm::dvec3& p = input.positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw ReadError(input.file, "vertex " + std::to_string(v + 1) +
                                      " has a coordinate that is not a finite number");
    }
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 extent = high - low;
  const double largest = std::max({extent.x, extent.y, extent.z});
  if (!std::isfinite(largest)) {
    throw ReadError(input.file, "its coordinates are too large to compute with");
  }
  d.center = low * 0.5 + high * 0.5;
  // Through the largest extent, so that neither tiny nor huge meshes lose their squares.
  d.scale = largest > 0 ? largest * glm::length(extent / largest) : 1.0;
  if (!std::isfinite(d.scale) || d.scale < std::numeric_limits<double>::min()) {
    // Denormal or overflowing diagonals: the largest extent is as good a unit.
    d.scale = largest > 0 ? largest : 1.0;
  }
  d.positions.resize(count);
  parallelBlocks(count, kMeshBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      d.positions[v] = used[v] ? (input.positions[v] - d.center) / d.scale : glm::dvec3(0);
    }
  });
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

/// Glues what belongs together, by vertices, then by places, then with faces turned over.
/// \returns whether vertices of the input were joined
bool glue(const InputMesh& input, double weld, MeshData& d, Findings& found) {
  GlueFindings edges = glueEdges(d, input.positions.size());
  const bool joined = weld >= 0 && weldBorders(d, input.positions, weld, edges);
  std::sort(d.slits.begin(), d.slits.end());
  found.turnedFaces = orientFaces(d, edges.conflicts);
  found.nonManifoldEdges = edges.nonManifoldEdges;
  found.flippedEdges = edges.conflicts.size();
  for (const Index side : edges.nonManifoldSides) found.brokenTriangles.push_back(side / 3);
  for (const auto& [a, b] : edges.conflicts) {
    found.brokenTriangles.push_back(a / 3);
    found.brokenTriangles.push_back(b / 3);
  }
  return joined;
}

/// Walks the fan of triangles around the start of a side, from `first` on.
template <class Visit>
void aroundFan(const MeshData& d, Index first, const Visit& visit) {
  Index side = first;
  do {
    visit(side);
    side = d.opposite[Mesh::previousSide(side)];
  } while (side != kNone && side != first);
}

/// The vertex of a fan: the smallest of its corners' that no fan has yet; kNone when all are given.
Index freeVertex(const MeshData& d, Index first) {
  Index vertex = kNone;
  aroundFan(d, first, [&](Index side) {
    const Index corner = d.triangles[side / 3][side % 3];
    if (d.vertexSide[corner] == kNone) vertex = std::min(vertex, corner);
  });
  return vertex;
}

/// One more vertex at the place of another.
Index copyVertex(MeshData& d, Index of) {
  if (d.inputVertex.empty()) {
    d.inputVertex.resize(d.positions.size());
    for (std::size_t v = 0; v < d.positions.size(); ++v) d.inputVertex[v] = static_cast<Index>(v);
  }
  const glm::dvec3 position = d.positions[of];
  d.positions.push_back(position);
  d.inputVertex.push_back(d.inputVertex[of]);
  d.vertexSide.push_back(kNone);
  return static_cast<Index>(d.positions.size() - 1);
}

/// Gives every fan of triangles a vertex of its own, and each vertex the first side of its fan.
/// \param joined fans may have corners of several vertices
void splitFans(bool joined, MeshData& d, Findings& found) {
  const std::size_t sides = d.opposite.size(), inputs = d.positions.size();
  d.vertexSide.assign(inputs, kNone);
  if (joined) d.standIn.assign(inputs, kNone);
  std::vector<bool> visited(sides, false);
  const auto turnBack = [&](Index side) {
    const Index other = d.opposite[side];
    return other == kNone ? kNone : Mesh::nextSide(other);
  };
  for (Index s = 0; s < sides; ++s) {
    if (visited[s]) continue;
    Index first = s;
    for (Index back = turnBack(s); back != kNone && back != s; back = turnBack(back)) first = back;
    if (turnBack(first) != kNone) first = s;  // a closed fan starts where it was met
    Index vertex = d.triangles[s / 3][s % 3];
    if (joined) {
      const Index free = freeVertex(d, first);
      if (free != kNone) vertex = free;
    }
    if (d.vertexSide[vertex] != kNone) {
      ++found.splitVertices;
      vertex = copyVertex(d, vertex);
    }
    d.vertexSide[vertex] = first;
    aroundFan(d, first, [&](Index side) {
      visited[side] = true;
      Index& corner = d.triangles[side / 3][side % 3];
      if (joined && corner < inputs && d.standIn[corner] == kNone) {
        d.standIn[corner] = d.inputVertex.empty() ? vertex : d.inputVertex[vertex];
      }
      corner = vertex;
    });
  }
  for (Index v = 0; v < d.standIn.size(); ++v) {
    if (d.standIn[v] == kNone) d.standIn[v] = v;
    if (d.standIn[v] != v) ++found.joinedVertices;
  }
}

void measure(MeshData& d, Findings& found) {
  const std::size_t count = d.triangles.size();
  d.triangleArea.resize(count);
  d.degenerate.assign(count, false);
  for (std::size_t t = 0; t < count; ++t) {
    const glm::dvec3& a = d.positions[d.triangles[t][0]];
    const glm::dvec3& b = d.positions[d.triangles[t][1]];
    const glm::dvec3& c = d.positions[d.triangles[t][2]];
    const glm::dvec3 ab = b - a, ac = c - a, bc = c - b;
    const double twice = glm::length(glm::cross(ab, ac));
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    d.triangleArea[t] = 0.5 * twice;
    d.surfaceArea += 0.5 * twice;
    if (twice <= 1e-10 * longest) {
      d.degenerate[t] = true;
      ++found.degenerateTriangles;
    }
  }
}

void findComponents(MeshData& d) {
  d.faceComponent.assign(d.faceCount, kNone);
  const auto faceOf = [&](Index t) { return d.faceOfTriangle.empty() ? t : d.faceOfTriangle[t]; };
  const auto begin = [&](Index f) { return d.triangleBegin.empty() ? f : d.triangleBegin[f]; };
  std::vector<Index> stack;
  for (Index seed = 0; seed < d.faceCount; ++seed) {
    if (d.faceComponent[seed] != kNone) continue;
    const Index component = static_cast<Index>(d.componentCount++);
    d.faceComponent[seed] = component;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index face = stack.back();
      stack.pop_back();
      for (Index side = 3 * begin(face); side < 3 * begin(face + 1); ++side) {
        if (d.opposite[side] == kNone) continue;
        const Index next = faceOf(d.opposite[side] / 3);
        if (d.faceComponent[next] != kNone) continue;
        d.faceComponent[next] = component;
        stack.push_back(next);
      }
    }
  }
}

void countEdgesAndLoops(MeshData& d) {
  const std::size_t sides = d.opposite.size();
  std::vector<bool> seen(sides, false);
  std::size_t borders = 0;
  for (Index s = 0; s < sides; ++s) {
    if (d.opposite[s] != kNone) continue;
    ++borders;
    if (seen[s]) continue;
    ++d.boundaryLoopCount;
    for (Index side = s; !seen[side];) {
      seen[side] = true;
      // The side that leaves a border vertex along the border is the first of its fan.
      side = d.vertexSide[d.triangles[side / 3][(side + 1) % 3]];
    }
  }
  d.edgeCount = (sides + borders) / 2;
}

/// Parts of one face that an edge which could not be glued has left alone.
std::size_t countLoneFaces(const MeshData& d, std::span<const Index> brokenTriangles) {
  if (brokenTriangles.empty()) return 0;
  std::vector<Index> size(d.componentCount, 0);
  for (const Index component : d.faceComponent) ++size[component];
  std::size_t lone = 0;
  for (const Index t : brokenTriangles) {
    Index& faces = size[d.faceComponent[d.faceOfTriangle.empty() ? t : d.faceOfTriangle[t]]];
    lone += faces == 1 ? 1 : 0;
    if (faces == 1) faces = 0;  // counted
  }
  return lone;
}

void report(const Findings& found, MeshData& d) {
  const auto add = [&](const char* what, std::size_t count, const char* one, const char* many) {
    if (count > 0) d.repairs.push_back({what, count, counted(count, one, many) + "."});
  };
  add("dropped-triangles", found.triangulation.droppedTriangles,
      "triangle repeats a corner and was dropped", "triangles repeat a corner and were dropped");
  add("dropped-faces", found.triangulation.emptyFaces,
      "face has fewer than three corners and was left out",
      "faces have fewer than three corners and were left out");
  add("welded-vertices", found.joinedVertices,
      "vertex was joined with another at the same place; exports keep it",
      "vertices were joined with others at the same places; exports keep them");
  add("turned-faces", found.turnedFaces,
      "face runs against its neighbours and was turned over; exports keep it as it is",
      "faces run against their neighbours and were turned over; exports keep them as they are");
  add("non-manifold-edges", found.nonManifoldEdges,
      "edge belongs to more than two faces and was split into borders",
      "edges belong to more than two faces and were split into borders");
  add("inconsistent-edges", found.flippedEdges,
      "edge joins faces of opposite orientation and was split into borders",
      "edges join faces of opposite orientation and were split into borders");
  add("lone-faces", found.loneFaces, "face is a part of its own because such edges surround it",
      "faces are parts of their own because such edges surround them");
  add("split-vertices", found.splitVertices, "vertex was copied so that each fan has its own",
      "vertices were copied so that each fan has its own");
  add("degenerate-triangles", found.degenerateTriangles,
      "triangle has no area and follows its neighbours",
      "triangles have no area and follow their neighbours");
  add("isolated-vertices", found.isolatedVertices, "vertex is used by no face",
      "vertices are used by no face");
}

}  // namespace

std::shared_ptr<const Mesh> buildMesh(std::shared_ptr<const InputMesh> input, double weld) {
  MeshData d;
  Findings found;
  found.triangulation = triangulateFaces(*input, weld >= 0, d);
  found.isolatedVertices = normalise(*input, d);
  const bool joined = glue(*input, weld, d, found);
  splitFans(joined, d, found);
  measure(d, found);
  findComponents(d);
  countEdgesAndLoops(d);
  found.loneFaces = countLoneFaces(d, found.brokenTriangles);
  d.repairs = input->repairs;
  // Readers may have named isolated vertices already.
  if (std::any_of(d.repairs.begin(), d.repairs.end(),
                  [](const Repair& r) { return r.what == "isolated-vertices"; })) {
    found.isolatedVertices = 0;
  }
  report(found, d);
  d.input = std::move(input);
  return std::make_shared<const Mesh>(std::move(d));
}

}  // namespace chartflood
