#include "core/model/build_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace chartflood {

namespace {

constexpr std::size_t kMeshBlock = 1 << 14;

/// What gluing found, counted for the import report.
struct Findings {
  std::size_t droppedTriangles = 0;
  std::size_t emptyFaces = 0;
  std::size_t nonManifoldEdges = 0;
  std::size_t flippedEdges = 0;
  std::size_t splitVertices = 0;
  std::size_t degenerateTriangles = 0;
};

Index welded(const InputMesh& input, Index vertex) {
  return input.weld.empty() ? vertex : input.weld[vertex];
}

/// Fans every polygon from its first corner. `opposite` gets the diagonals of polygons, which glue
/// whatever else the mesh does at the same pair of vertices.
void triangulate(const InputMesh& input, MeshData& d, Findings& found) {
  const std::size_t inputFaces = input.faceCount();
  if (inputFaces > kNone / 4) throw ReadError(input.file, "it has too many faces");
  d.triangles.reserve(input.corners.size() / 3);
  bool identity = true;  // each input face is one triangle
  std::vector<Index> faceOfTriangle, triangleBegin, inputFace, polygon;
  std::vector<std::pair<Index, Index>> diagonals;
  const auto leaveIdentity = [&](std::size_t facesSoFar) {
    identity = false;
    faceOfTriangle.resize(facesSoFar);
    triangleBegin.resize(facesSoFar);
    inputFace.resize(facesSoFar);
    for (std::size_t i = 0; i < facesSoFar; ++i) {
      faceOfTriangle[i] = triangleBegin[i] = inputFace[i] = static_cast<Index>(i);
    }
  };
  for (std::size_t f = 0; f < inputFaces; ++f) {
    const std::span<const Index> corners = input.face(f);
    polygon.clear();
    for (const Index corner : corners) {
      CF_CHECK(corner < input.positions.size());
      polygon.push_back(welded(input, corner));
    }
    const std::size_t first = d.triangles.size();
    bool previousKept = false;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const Index a = polygon[0], b = polygon[i], c = polygon[i + 1];
      if (a == b || b == c || c == a) {
        ++found.droppedTriangles;
        // A corner listed twice in a row leaves the diagonal where it was.
        previousKept = previousKept && b == c;
        continue;
      }
      const Index triangle = static_cast<Index>(d.triangles.size());
      if (previousKept) diagonals.emplace_back(3 * (triangle - 1) + 2, 3 * triangle);
      d.triangles.push_back({a, b, c});
      previousKept = true;
    }
    const std::size_t made = d.triangles.size() - first;
    if (identity && made != 1) leaveIdentity(f);
    if (made == 0) {
      ++found.emptyFaces;
      continue;
    }
    if (!identity) {
      const Index face = static_cast<Index>(triangleBegin.size());
      triangleBegin.push_back(static_cast<Index>(first));
      inputFace.push_back(static_cast<Index>(f));
      faceOfTriangle.insert(faceOfTriangle.end(), made, face);
    }
  }
  if (d.triangles.empty()) {
    throw ReadError(input.file, input.faceCount() == 0
                                    ? "it has no faces"
                                    : "none of its faces has three different corners");
  }
  d.faceCount = identity ? d.triangles.size() : triangleBegin.size();
  if (!identity) {
    triangleBegin.push_back(static_cast<Index>(d.triangles.size()));
    const bool dropped = d.faceCount != inputFaces;
    const bool polygons = d.faceCount != d.triangles.size();
    if (dropped) d.inputFace = std::move(inputFace);
    if (polygons) {
      d.faceOfTriangle = std::move(faceOfTriangle);
      d.triangleBegin = std::move(triangleBegin);
    }
  }
  d.opposite.assign(3 * d.triangles.size(), kNone);
  for (const auto& [side, other] : diagonals) {
    d.opposite[side] = other;
    d.opposite[other] = side;
  }
}

/// Moves the used vertices to the centre of their bounding box and scales its diagonal to 1.
void normalise(const InputMesh& input, MeshData& d) {
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
}

/// Finds for each side the one across its edge: sides are counted into lists by their smaller
/// vertex, and each short list is searched for equal larger vertices.
void glueEdges(MeshData& d, std::size_t vertexCount, Findings& found) {
  struct Entry {
    Index larger;
    Index side;
  };
  const std::size_t sides = d.opposite.size();
  const auto endpoints = [&](std::size_t side) {
    const auto& t = d.triangles[side / 3];
    return std::pair<Index, Index>(t[side % 3], t[(side + 1) % 3]);
  };
  std::vector<Index> start(vertexCount + 1, 0);
  for (std::size_t s = 0; s < sides; ++s) {
    if (d.opposite[s] != kNone) continue;
    const auto [a, b] = endpoints(s);
    ++start[std::min(a, b) + 1];
  }
  for (std::size_t v = 0; v < vertexCount; ++v) start[v + 1] += start[v];
  std::vector<Entry> entries(start[vertexCount]);
  {
    std::vector<Index> next(start.begin(), start.end() - 1);
    for (std::size_t s = 0; s < sides; ++s) {
      if (d.opposite[s] != kNone) continue;
      const auto [a, b] = endpoints(s);
      entries[next[std::min(a, b)]++] = {std::max(a, b), static_cast<Index>(s)};
    }
  }
  const auto less = [](const Entry& x, const Entry& y) {
    return x.larger != y.larger ? x.larger < y.larger : x.side < y.side;
  };
  const std::size_t blocks = (vertexCount + kMeshBlock - 1) / kMeshBlock;
  std::vector<std::array<std::size_t, 3>> counts(blocks, {0, 0, 0});
  parallelFor(blocks, [&](std::size_t block) {
    const std::size_t last = std::min((block + 1) * kMeshBlock, vertexCount);
    for (std::size_t v = block * kMeshBlock; v < last; ++v) {
      Entry* const begin = entries.data() + start[v];
      Entry* const end = entries.data() + start[v + 1];
      std::sort(begin, end, less);
      for (Entry* run = begin; run < end;) {
        Entry* stop = run + 1;
        while (stop < end && stop->larger == run->larger) ++stop;
        ++counts[block][0];
        if (stop - run == 2) {
          const bool forward0 = d.triangles[run[0].side / 3][run[0].side % 3] == v;
          const bool forward1 = d.triangles[run[1].side / 3][run[1].side % 3] == v;
          if (forward0 != forward1) {
            d.opposite[run[0].side] = run[1].side;
            d.opposite[run[1].side] = run[0].side;
          } else {
            ++counts[block][2];
          }
        } else if (stop - run > 2) {
          ++counts[block][1];
        }
        run = stop;
      }
    }
  });
  for (const auto& c : counts) {
    found.nonManifoldEdges += c[1];
    found.flippedEdges += c[2];
  }
}

/// Gives every fan of triangles a vertex of its own, and each vertex the first side of its fan.
void splitFans(const InputMesh& input, MeshData& d, Findings& found) {
  const std::size_t sides = d.opposite.size();
  d.vertexSide.assign(d.positions.size(), kNone);
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
    const Index old = d.triangles[s / 3][s % 3];
    Index vertex = old;
    if (d.vertexSide[old] != kNone) {
      ++found.splitVertices;
      if (d.inputVertex.empty()) {
        d.inputVertex.resize(d.positions.size());
        for (std::size_t v = 0; v < d.positions.size(); ++v) {
          d.inputVertex[v] = static_cast<Index>(v);
        }
      }
      vertex = static_cast<Index>(d.positions.size());
      const glm::dvec3 position = d.positions[old];
      d.positions.push_back(position);
      d.inputVertex.push_back(d.inputVertex[old]);
      d.vertexSide.push_back(kNone);
    }
    d.vertexSide[vertex] = first;
    Index side = first;
    do {
      visited[side] = true;
      d.triangles[side / 3][side % 3] = vertex;
      side = d.opposite[Mesh::previousSide(side)];
    } while (side != kNone && side != first);
  }
  CF_CHECK(input.positions.size() <= d.positions.size());
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

void report(const Findings& found, std::size_t isolated, MeshData& d) {
  const auto add = [&](const char* what, std::size_t count, const char* one, const char* many) {
    if (count > 0) d.repairs.push_back({what, count, counted(count, one, many) + "."});
  };
  add("dropped-triangles", found.droppedTriangles, "triangle repeats a corner and was dropped",
      "triangles repeat a corner and were dropped");
  add("dropped-faces", found.emptyFaces, "face has fewer than three corners and was left out",
      "faces have fewer than three corners and were left out");
  add("non-manifold-edges", found.nonManifoldEdges,
      "edge belongs to more than two faces and was split into borders",
      "edges belong to more than two faces and were split into borders");
  add("inconsistent-edges", found.flippedEdges,
      "edge joins faces of opposite orientation and was split into borders",
      "edges join faces of opposite orientation and were split into borders");
  add("split-vertices", found.splitVertices, "vertex was copied so that each fan has its own",
      "vertices were copied so that each fan has its own");
  add("degenerate-triangles", found.degenerateTriangles,
      "triangle has no area and follows its neighbours",
      "triangles have no area and follow their neighbours");
  add("isolated-vertices", isolated, "vertex is used by no face", "vertices are used by no face");
}

}  // namespace

std::shared_ptr<const Mesh> buildMesh(std::shared_ptr<const InputMesh> input) {
  MeshData d;
  Findings found;
  triangulate(*input, d, found);
  normalise(*input, d);
  glueEdges(d, input->positions.size(), found);
  splitFans(*input, d, found);
  measure(d, found);
  findComponents(d);
  countEdgesAndLoops(d);
  std::size_t isolated = 0;
  for (std::size_t v = 0; v < input->positions.size(); ++v) {
    const bool alias = !input->weld.empty() && input->weld[v] != v;
    isolated += d.vertexSide[v] == kNone && !alias ? 1 : 0;
  }
  d.repairs = input->repairs;
  // Readers may have named isolated vertices already.
  const bool known = std::any_of(d.repairs.begin(), d.repairs.end(),
                                 [](const Repair& r) { return r.what == "isolated-vertices"; });
  report(found, known ? 0 : isolated, d);
  d.input = std::move(input);
  return std::make_shared<const Mesh>(std::move(d));
}

}  // namespace chartflood
