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
constexpr double kCancelled = 1e-10;  // of its vectors' lengths: a sum that vanishes

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

/// A sum of vectors and of their lengths. What rounding leaves of vectors that cancel hangs on
/// their order and is no direction.
struct NormalSum {
  glm::dvec3 sum{0};
  double lengths = 0;

  void add(const glm::dvec3& vector, double length) {
    sum += vector;
    lengths += length;
  }
  /// False for sums that vanish or are beyond all numbers.
  bool normalised(glm::dvec3& normal) const {
    const double length = glm::length(sum);
    if (!(length > kCancelled * lengths) || !std::isfinite(length)) return false;
    normal = sum / length;
    return true;
  }
};

/// For sums that vanish: plain unit normals, then the one that looks most to a side that no model
/// is built along, then upwards.
glm::dvec3 fallbackNormal(const Mesh& mesh, std::span<const Index> sides) {
  const glm::dvec3 aside(0.2617, 0.4189, 0.8693);
  NormalSum sum;
  glm::dvec3 any(0, 0, 1), normal;
  double most = -2;
  for (const Index side : sides) {
    if (mesh.degenerate(side / 3)) continue;
    const Corner c = cornerAt(mesh, side);
    const glm::dvec3 unit = glm::normalize(glm::cross(c.next, c.previous));
    sum.add(unit, 1);
    if (glm::dot(unit, aside) <= most) continue;
    most = glm::dot(unit, aside);
    any = unit;
  }
  return sum.normalised(normal) ? normal : any;
}

glm::dvec3 sectorNormal(const Mesh& mesh, std::span<const Index> sides) {
  NormalSum sum;
  glm::dvec3 normal;
  for (const Index side : sides) {
    if (mesh.degenerate(side / 3)) continue;
    const Corner c = cornerAt(mesh, side);
    const double weight = glm::dot(c.next, c.next) * glm::dot(c.previous, c.previous);
    if (!(weight > 0)) continue;
    const glm::dvec3 vector = glm::cross(c.next, c.previous) * (1 / weight);
    sum.add(vector, glm::length(vector));
  }
  return sum.normalised(normal) ? normal : fallbackNormal(mesh, sides);
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

  NormalSum at(Index vertex) const {
    NormalSum sum;
    for (const Part& part : parts_) {
      const std::size_t place = vertex - part.first;  // huge where the part begins behind it
      if (place < part.sum.size()) sum.add(part.sum[place].sum, part.sum[place].lengths);
    }
    return sum;
  }

 private:
  /// Sums of the vertices from `first` on, as many as the part reaches.
  struct Part {
    std::size_t first = 0;
    std::vector<NormalSum> sum;
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
    part.sum.assign(std::size_t{most} - least + 1, NormalSum{});
    for (std::size_t t = begin; t < end; ++t) {
      if (!mesh_.degenerate(static_cast<Index>(t))) addTriangle(t, part);
    }
  }

  void addTriangle(std::size_t triangle, Part& part) const {
    const auto& v = mesh_.triangles()[triangle];
    const auto positions = mesh_.positions();
    const glm::dvec3 a = positions[v[1]] - positions[v[0]];
    const glm::dvec3 b = positions[v[2]] - positions[v[1]];
    const glm::dvec3 c = positions[v[0]] - positions[v[2]];
    const double aa = glm::dot(a, a), bb = glm::dot(b, b), cc = glm::dot(c, c);
    const glm::dvec3 normal = glm::cross(a, b);
    const double length = 2 * mesh_.triangleArea()[triangle];
    const auto add = [&](Index vertex, double weight) {
      if (!(weight > 0)) return;
      part.sum[vertex - part.first].add(normal * (1 / weight), length * (1 / weight));
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
      if (sums.at(vertex).normalised(out.vertex[i])) continue;
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
