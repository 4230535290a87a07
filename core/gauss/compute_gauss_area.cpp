#include "core/gauss/compute_gauss_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/gauss/sector_normals.h"
#include "core/gauss/sharp_edges.h"
#include "core/gauss/spherical_polygon.h"

namespace chartflood {

namespace {

constexpr std::size_t kSumBlock = 1 << 13;

double sumOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum;
}

/// Fills `area[i] = |value(i)|` in parallel and returns the sum of the signed values, added up
/// block by block.
template <class Signed>
double signedPass(std::size_t count, const Signed& value) {
  const std::size_t blocks = (count + kSumBlock - 1) / kSumBlock;
  std::vector<double> partial(blocks, 0);
  parallelFor(blocks, [&](std::size_t block) {
    const std::size_t last = std::min((block + 1) * kSumBlock, count);
    for (std::size_t i = block * kSumBlock; i < last; ++i) partial[block] += value(i);
  });
  return sumOf(partial);
}

double triangleAreas(const Mesh& mesh, const SectorNormals& sectors, GaussArea& out) {
  out.triangle.resize(mesh.triangleCount());
  return signedPass(mesh.triangleCount(), [&](std::size_t t) {
    const Index s = static_cast<Index>(3 * t);
    const double area =
        signedTriangleArea(sectors.at(mesh, s), sectors.at(mesh, s + 1), sectors.at(mesh, s + 2));
    out.triangle[t] = std::abs(area);
    return area;
  });
}

double edgeAreas(const Mesh& mesh, const SectorNormals& sectors,
                 const std::vector<std::uint8_t>& sharp, GaussArea& out) {
  const auto opposite = mesh.opposite();
  for (Index s = 0; s < sharp.size(); ++s) {
    if (sharp[s] && s < opposite[s]) out.sharpEdges.push_back(s);
  }
  out.edge.resize(out.sharpEdges.size());
  return signedPass(out.sharpEdges.size(), [&](std::size_t i) {
    const Index left = out.sharpEdges[i], right = opposite[left];
    const std::array<glm::dvec3, 4> quad = {
        sectors.at(mesh, Mesh::nextSide(left)), sectors.at(mesh, left),
        sectors.at(mesh, Mesh::nextSide(right)), sectors.at(mesh, right)};
    const PolygonArea area = polygonArea(quad);
    out.edge[i] = area.absolute;
    return area.signedArea;
  });
}

double cornerAreas(const SectorNormals& sectors, GaussArea& out) {
  std::vector<SectorNormals::Split> corners;
  for (const SectorNormals::Split& split : sectors.splits) {
    if (split.interior && split.sectorCount >= 3) corners.push_back(split);
  }
  out.corners.resize(corners.size());
  out.corner.resize(corners.size());
  return signedPass(corners.size(), [&](std::size_t i) {
    const std::span<const glm::dvec3> polygon(sectors.sector.data() + corners[i].firstSector,
                                              corners[i].sectorCount);
    out.corners[i] = corners[i].vertex;
    const PolygonArea area = polygonArea(polygon);
    out.corner[i] = area.absolute;
    return area.signedArea;
  });
}

/// Largest Gauss area over area. Edges and vertices take the smallest adjacent triangle.
double largestCurvature(const Mesh& mesh, const GaussArea& gauss) {
  const double floor = smallestArea(mesh);
  const auto area = mesh.triangleArea();
  const auto opposite = mesh.opposite();
  double largest = 0;
  const FaceValues face = faceGaussArea(mesh, gauss);
  std::vector<double> ofBlock((mesh.faceCount() + kSumBlock - 1) / kSumBlock, 0);
  parallelBlocks(mesh.faceCount(), kSumBlock, [&](std::size_t begin, std::size_t end) {
    double most = 0;
    for (Index f = static_cast<Index>(begin); f < end; ++f) {
      double faceArea = 0;
      for (Index t = mesh.triangleBegin(f); t < mesh.triangleBegin(f + 1); ++t) faceArea += area[t];
      most = std::max(most, face[f] / std::max(floor, faceArea));
    }
    ofBlock[begin / kSumBlock] = most;
  });
  for (const double most : ofBlock) largest = std::max(largest, most);
  for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
    const Index left = gauss.sharpEdges[i] / 3, right = opposite[gauss.sharpEdges[i]] / 3;
    if (mesh.faceOf(left) == mesh.faceOf(right)) continue;
    largest = std::max(largest, gauss.edge[i] / std::max(floor, std::min(area[left], area[right])));
  }
  for (std::size_t i = 0; i < gauss.corners.size(); ++i) {
    double smallest = std::numeric_limits<double>::infinity();
    const Index first = mesh.vertexSide()[gauss.corners[i]];
    Index side = first;
    do {
      smallest = std::min(smallest, area[side / 3]);
      side = mesh.turn(side);
    } while (side != first);
    largest = std::max(largest, gauss.corner[i] / std::max(floor, smallest));
  }
  return largest > 0 ? largest : 1;
}

}  // namespace

double smallestArea(const Mesh& mesh) {
  const double mean = mesh.surfaceArea() / static_cast<double>(mesh.triangleCount());
  // A mesh without any area has nothing to compare with.
  return mean > 0 ? 1e-9 * mean : 1.0;
}

GaussArea computeGaussArea(const Mesh& mesh, double sharpAngle) {
  GaussArea out;
  out.sharpAngle = sharpAngle;
  const std::vector<std::uint8_t> sharp = findSharpSides(mesh, sharpAngle);
  const SectorNormals sectors = computeSectorNormals(mesh, sharp);
  out.signedTotal = triangleAreas(mesh, sectors, out);
  out.signedTotal += edgeAreas(mesh, sectors, sharp, out);
  out.signedTotal += cornerAreas(sectors, out);
  out.triangleTotal = sumOf(out.triangle);
  out.edgeTotal = sumOf(out.edge);
  out.cornerTotal = sumOf(out.corner);
  out.maxCurvature = largestCurvature(mesh, out);
  return out;
}

FaceValues faceGaussArea(const Mesh& mesh, const GaussArea& gauss) {
  if (mesh.facesAreTriangles()) return FaceValues(std::span<const double>(gauss.triangle));
  std::vector<double> face(mesh.faceCount(), 0);
  for (Index t = 0; t < mesh.triangleCount(); ++t) face[mesh.faceOf(t)] += gauss.triangle[t];
  for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
    const Index left = gauss.sharpEdges[i];
    const Index f = mesh.faceOf(left / 3);
    if (f == mesh.faceOf(mesh.opposite()[left] / 3)) face[f] += gauss.edge[i];
  }
  return FaceValues(std::move(face));
}

}  // namespace chartflood
