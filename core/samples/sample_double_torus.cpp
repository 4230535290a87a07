/// The double torus: a slab with two holes of unit cubes, pulled onto a smooth implicit surface and
/// evened out by flipping edges and moving vertices along the surface.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/samples/sample_blocks.h"
#include "core/samples/sample_shapes.h"

namespace chartflood {

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using OpenMesh::Vec3d;

/// Two tori side by side whose tubes melt together in the middle.
constexpr double kCentre = 0.86, kLarge = 0.75, kSmall = 0.3, kMelt = 0.09;

/// Distance from one torus and its gradient.
double torus(const Vec3d& p, double centre, Vec3d& gradient) {
  const double x = p[0] - centre, around = std::sqrt(x * x + p[1] * p[1]), q = around - kLarge;
  const double distance = std::max(std::sqrt(q * q + p[2] * p[2]), 1e-12);
  const double share = q / (distance * std::max(around, 1e-12));
  gradient = Vec3d(share * x, share * p[1], p[2] / distance);
  return distance - kSmall;
}

/// The implicit function, 0 on the surface and positive outside, and its gradient.
double doubleTorus(const Vec3d& p, Vec3d& gradient) {
  Vec3d left, right;
  const double a = torus(p, -kCentre, left), b = torus(p, kCentre, right);
  const double nearest = std::min(a, b);
  const double weightA = std::exp((nearest - a) / kMelt), weightB = std::exp((nearest - b) / kMelt);
  gradient = (left * weightA + right * weightB) / (weightA + weightB);
  return nearest - kMelt * std::log(weightA + weightB);
}

/// Moves a point onto the surface, from near it in a step or two.
void project(Vec3d& p, int steps) {
  Vec3d gradient;
  for (int i = 0; i < steps; ++i) {
    const double value = doubleTorus(p, gradient);
    p -= gradient * (value / std::max(gradient.sqrnorm(), 1e-6));
  }
}

Surface surfaceOf(const InputMesh& blocks) {
  Surface surface;
  std::vector<Surface::VertexHandle> vertices;
  for (const glm::dvec3& p : blocks.positions) {
    // Five by three cells around the two holes.
    Vec3d point((p.x - 2.5) * 0.76, (p.y - 1.5) * 0.7, (p.z - 0.5) * 0.6);
    project(point, 8);
    vertices.push_back(surface.add_vertex(point));
  }
  for (std::size_t f = 0; f < blocks.faceCount(); ++f) {
    const std::span<const Index> face = blocks.face(f);
    const auto added = surface.add_face(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
    CF_CHECK(added.is_valid());
  }
  return surface;
}

/// Cotangent of the angle that a side's triangle has opposite to it.
double oppositeCotangent(const Surface& surface, OpenMesh::SmartHalfedgeHandle side) {
  const Vec3d apex = surface.point(side.next().to());
  const Vec3d a = surface.point(side.from()) - apex, b = surface.point(side.to()) - apex;
  return (a | b) / std::max((a % b).norm(), 1e-300);
}

/// Flips edges whose opposite angles add up to more than 180 degrees (Delaunay).
void flipEdges(Surface& surface) {
  for (const auto edge : surface.edges()) {
    const double sum =
        oppositeCotangent(surface, edge.h0()) + oppositeCotangent(surface, edge.h1());
    if (sum < -1e-9 && surface.is_flip_ok(edge)) surface.flip(edge);
  }
}

/// Moves every vertex towards the middle of its neighbours, along the surface. With `evenAreas`
/// neighbours with large triangles around them pull harder, else all alike, which evens angles.
void spreadVertices(Surface& surface, bool evenAreas) {
  std::vector<Vec3d> moved(surface.n_vertices());
  std::vector<double> area(surface.n_vertices(), 0.0);
  for (const auto face : surface.faces()) {
    const double size = surface.calc_face_area(face);
    for (const auto vertex : face.vertices()) area[static_cast<std::size_t>(vertex.idx())] += size;
  }
  for (const auto vertex : surface.vertices()) {
    Vec3d middle(0, 0, 0);
    double weights = 0;
    for (const auto neighbour : vertex.vertices()) {
      const double weight = evenAreas ? area[static_cast<std::size_t>(neighbour.idx())] : 1.0;
      middle += surface.point(neighbour) * weight;
      weights += weight;
    }
    Vec3d point = surface.point(vertex);
    Vec3d gradient;
    doubleTorus(point, gradient);
    const Vec3d normal = gradient.normalized(), step = middle / weights - point;
    point += 0.6 * (step - normal * (normal | step));
    project(point, 1);
    moved[static_cast<std::size_t>(vertex.idx())] = point;
  }
  for (const auto vertex : surface.vertices()) {
    surface.set_point(vertex, moved[static_cast<std::size_t>(vertex.idx())]);
  }
}

InputMesh inputOf(const Surface& surface) {
  InputMesh mesh;
  for (const auto vertex : surface.vertices()) {
    const Vec3d& p = surface.point(vertex);
    mesh.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto face : surface.faces()) {
    for (const auto vertex : face.vertices()) {
      mesh.corners.push_back(static_cast<Index>(vertex.idx()));
    }
  }
  return mesh;
}

/// Five by three cubes without two holes.
InputMesh blocksOf(double edge) {
  std::vector<std::array<int, 3>> cells;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const bool hole = y == 1 && (x == 1 || x == 3);
      if (!hole) cells.push_back({x, y, 0});
    }
  }
  return makeBlocks(cells, edge / 0.69);
}

/// How often each triangle is cut in four: surfaces are evened out while coarse, because a vertex
/// feels only its neighbours in each round. \param edge becomes that of the coarse surface
int cutsFor(double& edge) {
  constexpr double kCoarse = 0.035;
  int cuts = 0;
  for (; edge < kCoarse; edge *= 2) ++cuts;
  return cuts;
}

}  // namespace

std::size_t countDoubleTorus(double edge) {
  const int cuts = cutsFor(edge);
  return blocksOf(edge).faceCount() << (2 * cuts);
}

InputMesh makeDoubleTorus(double edge) {
  const int cuts = cutsFor(edge);
  Surface surface = surfaceOf(blocksOf(edge));
  constexpr int kRounds = 60, kAngleRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    if (round % 3 == 0) flipEdges(surface);
    spreadVertices(surface, round < kRounds - kAngleRounds);
  }
  flipEdges(surface);
  OpenMesh::Subdivider::Uniform::LoopT<Surface> cutInFour;
  if (cuts > 0) cutInFour(surface, static_cast<std::size_t>(cuts));
  for (const auto vertex : surface.vertices()) {
    Vec3d point = surface.point(vertex);
    project(point, 4);
    surface.set_point(vertex, point);
  }
  return inputOf(surface);
}

}  // namespace chartflood
