#include "core/gauss/sector_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/gauss/sharp_edges.h"

namespace chartflood {

namespace {

constexpr std::size_t kSectorBlock = 1 << 13;
constexpr std::size_t kParallelTriangles = 50000;  // from which sums are made in parts
constexpr std::size_t kSectorParts = 4;

/// Edge vectors of a corner: to the next and to the previous vertex of the triangle.
struct Corner {
  glm::dvec3 next, previous;
};

Corner cornerAt(const Mesh& mesh, Index side) {
  const auto positions = mesh.positions();
  const glm::dvec3& here = positions[mesh.sideStart(side)];
  return {positions[mesh.sideEnd(side)] - here,
          positions[mesh.sideStart(Mesh::previousSide(side))] - here};
}

/// False for sums that vanish or are beyond all numbers.
bool normalised(const glm::dvec3& sum, glm::dvec3& normal) {
  const double length = glm::length(sum);
  if (!(length > 0) || !std::isfinite(length)) return false;
  normal = sum / length;
  return true;
}

/// For sums that vanish: plain unit normals, then any, then upwards.
glm::dvec3 fallbackNormal(const Mesh& mesh, std::span<const Index> sides) {
  glm::dvec3 sum(0), any(0, 0, 1);
  for (const Index side : sides) {
    if (mesh.degenerate(side / 3)) continue;
    const Corner c = cornerAt(mesh, side);
    any = glm::normalize(glm::cross(c.next, c.previous));
    sum += any;
  }
  const double length = glm::length(sum);
  return length > 1e-12 ? sum / length : any;
}

glm::dvec3 sectorNormal(const Mesh& mesh, std::span<const Index> sides) {
  glm::dvec3 sum(0), normal;
  for (const Index side : sides) {
    if (mesh.degenerate(side / 3)) continue;
    const Corner c = cornerAt(mesh, side);
    const double weight = glm::dot(c.next, c.next) * glm::dot(c.previous, c.previous);
    if (weight > 0) sum += glm::cross(c.next, c.previous) * (1 / weight);
  }
  return normalised(sum, normal) ? normal : fallbackNormal(mesh, sides);
}

/// Sides that leave a vertex, counter-clockwise.
void collectFan(const Mesh& mesh, Index vertex, std::vector<Index>& sides) {
  sides.clear();
  const Index first = mesh.vertexSide()[vertex];
  Index side = first;
  do {
    sides.push_back(side);
    side = mesh.turn(side);
  } while (side != kNone && side != first);
}

/// Sums over whole fans, triangle by triangle: in memory's order, and every triangle once. The mesh
/// is cut in parts that are the same for any number of threads, and so are the sums.
class FanSums {
 public:
  explicit FanSums(const Mesh& mesh) : mesh_(mesh) {
    const std::size_t triangles = mesh.triangleCount();
    parts_.resize(triangles >= kParallelTriangles ? kSectorParts : 1);
    parallelFor(parts_.size(), [&](std::size_t p) {
      addUp(triangles * p / parts_.size(), triangles * (p + 1) / parts_.size(), parts_[p]);
    });
  }

  glm::dvec3 at(Index vertex) const {
    glm::dvec3 sum(0);
    for (const Part& part : parts_) {
      const std::size_t place = vertex - part.first;  // huge where the part begins behind it
      if (place < part.sum.size()) sum += part.sum[place];
    }
    return sum;
  }

 private:
  /// Sums of the vertices from `first` on, as many as the part reaches.
  struct Part {
    std::size_t first = 0;
    std::vector<glm::dvec3> sum;
  };

  void addUp(std::size_t begin, std::size_t end, Part& part) const {
    const auto triangles = mesh_.triangles().subspan(begin, end - begin);
    Index least = kNone, most = 0;
    for (const auto& triangle : triangles) {
      for (const Index v : triangle) {
        least = std::min(least, v);
        most = std::max(most, v);
      }
    }
    if (triangles.empty()) return;
    part.first = least;
    part.sum.assign(std::size_t{most} - least + 1, glm::dvec3(0));
    for (std::size_t t = begin; t < end; ++t) {
      if (!mesh_.degenerate(static_cast<Index>(t))) addTriangle(mesh_.triangles()[t], part);
    }
  }

  void addTriangle(const std::array<Index, 3>& v, Part& part) const {
    const auto positions = mesh_.positions();
    const glm::dvec3 a = positions[v[1]] - positions[v[0]];
    const glm::dvec3 b = positions[v[2]] - positions[v[1]];
    const glm::dvec3 c = positions[v[0]] - positions[v[2]];
    const double aa = glm::dot(a, a), bb = glm::dot(b, b), cc = glm::dot(c, c);
    const glm::dvec3 normal = glm::cross(a, b);
    const auto add = [&](Index vertex, double weight) {
      if (weight > 0) part.sum[vertex - part.first] += normal * (1 / weight);
    };
    add(v[0], aa * cc);
    add(v[1], aa * bb);
    add(v[2], bb * cc);
  }

  const Mesh& mesh_;
  std::vector<Part> parts_;
};

/// Splits the fan of one vertex at its sharp edges and appends its sectors.
void splitVertex(const Mesh& mesh, std::span<const std::uint8_t> sharp, Index vertex,
                 std::vector<Index>& fan, SectorNormals& out) {
  const bool interior = mesh.opposite()[fan.front()] != kNone;
  if (interior) {
    const auto crease = std::find_if(fan.begin(), fan.end(), [&](Index s) { return sharp[s]; });
    std::rotate(fan.begin(), crease, fan.end());
  }
  const Index first = static_cast<Index>(out.sector.size());
  for (std::size_t begin = 0; begin < fan.size();) {
    std::size_t end = begin + 1;
    while (end < fan.size() && !sharp[fan[end]]) ++end;
    const std::span<const Index> sides(fan.data() + begin, end - begin);
    for (const Index side : sides) out.sideSector[side] = static_cast<Index>(out.sector.size());
    out.sector.push_back(sectorNormal(mesh, sides));
    begin = end;
  }
  out.splits.push_back({vertex, first, static_cast<Index>(out.sector.size()) - first, interior});
}

}  // namespace

SectorNormals computeSectorNormals(const Mesh& mesh, std::span<const std::uint8_t> sharpSides) {
  SectorNormals out;
  const std::size_t vertices = mesh.vertexCount();
  out.vertex.resize(vertices, glm::dvec3(0, 0, 1));
  // Sharp edges at each vertex; more than enough in 8 bits, as only 0, 1 and "more" matter.
  std::vector<std::uint8_t> sharpCount(vertices, 0);
  bool anySharp = false;
  for (std::size_t s = 0; s < sharpSides.size(); ++s) {
    if (!sharpSides[s]) continue;
    anySharp = true;
    // Each vertex counts the sides that leave it: once per interior edge.
    std::uint8_t& count = sharpCount[mesh.sideStart(static_cast<Index>(s))];
    if (count < 2) ++count;
  }
  const auto isBorder = [&](Index vertex) {
    return mesh.opposite()[mesh.vertexSide()[vertex]] == kNone;
  };
  const auto isSplit = [&](Index vertex) {
    return sharpCount[vertex] >= 2 || (sharpCount[vertex] == 1 && isBorder(vertex));
  };
  const FanSums sums(mesh);
  parallelBlocks(vertices, kSectorBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> fan;
    for (std::size_t i = begin; i < end; ++i) {
      const Index vertex = static_cast<Index>(i);
      if (mesh.vertexSide()[vertex] == kNone || isSplit(vertex)) continue;
      if (normalised(sums.at(vertex), out.vertex[i])) continue;
      collectFan(mesh, vertex, fan);
      out.vertex[i] = fallbackNormal(mesh, fan);
    }
  });
  if (!anySharp) return out;
  out.sideSector.assign(3 * mesh.triangleCount(), kNone);
  std::vector<Index> fan;
  for (Index vertex = 0; vertex < vertices; ++vertex) {
    if (mesh.vertexSide()[vertex] == kNone || !isSplit(vertex)) continue;
    collectFan(mesh, vertex, fan);
    splitVertex(mesh, sharpSides, vertex, fan, out);
  }
  return out;
}

CornerNormals computeCornerNormals(const Mesh& mesh, double sharpAngle) {
  const SectorNormals sectors = computeSectorNormals(mesh, findSharpSides(mesh, sharpAngle));
  CornerNormals out;
  out.normal.resize(3 * mesh.triangleCount());
  parallelBlocks(out.normal.size(), 3 * kSectorBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      out.normal[s] = glm::vec3(sectors.at(mesh, static_cast<Index>(s)));
    }
  });
  return out;
}

}  // namespace chartflood
