#include "core/gauss/sector_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/gauss/sharp_edges.h"

namespace chartflood {

namespace {

constexpr std::size_t kSectorBlock = 1 << 13;

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

/// Adds up the corners of one sector.
class SectorSum {
 public:
  void add(const Mesh& mesh, Index side) {
    if (mesh.degenerate(side / 3)) return;
    const Corner c = cornerAt(mesh, side);
    const double weight = glm::dot(c.next, c.next) * glm::dot(c.previous, c.previous);
    if (weight > 0) sum_ += glm::cross(c.next, c.previous) / weight;
  }
  bool normalised(glm::dvec3& normal) const {
    const double length = glm::length(sum_);
    if (!(length > 0) || !std::isfinite(length)) return false;
    normal = sum_ / length;
    return true;
  }

 private:
  glm::dvec3 sum_{0};
};

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
  SectorSum sum;
  for (const Index side : sides) sum.add(mesh, side);
  glm::dvec3 normal;
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

/// The whole fan as one sector, without collecting it first.
bool smoothNormal(const Mesh& mesh, Index first, glm::dvec3& normal) {
  SectorSum sum;
  Index side = first;
  do {
    sum.add(mesh, side);
    side = mesh.turn(side);
  } while (side != kNone && side != first);
  return sum.normalised(normal);
}

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
  parallelBlocks(vertices, kSectorBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> fan;
    for (std::size_t i = begin; i < end; ++i) {
      const Index vertex = static_cast<Index>(i);
      const Index first = mesh.vertexSide()[vertex];
      if (first == kNone || isSplit(vertex)) continue;
      if (smoothNormal(mesh, first, out.vertex[i])) continue;
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
