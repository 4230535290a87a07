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
#include "core/io/sample_blocks.h"
#include "core/io/sample_shapes.h"

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

/// Flips edges while that brings the four vertices around nearer to six neighbours each.
void flipEdges(Surface& surface) {
  for (const auto edge : surface.edges()) {
    const auto h = edge.h0();
    const auto excess = [](auto vertex) { return static_cast<int>(vertex.valence()) - 6; };
    const int a = excess(h.from()), b = excess(h.to());
    const int c = excess(h.next().to()), d = excess(h.opp().next().to());
    const auto square = [](int x) { return x * x; };
    const int before = square(a) + square(b) + square(c) + square(d);
    const int after = square(a - 1) + square(b - 1) + square(c + 1) + square(d + 1);
    if (after < before && surface.is_flip_ok(edge)) surface.flip(edge);
  }
}

/// Moves every vertex towards the middle of its neighbours, along the surface.
void spreadVertices(Surface& surface) {
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
      // Neighbours with large triangles around them pull harder, which makes areas equal.
      const double weight = area[static_cast<std::size_t>(neighbour.idx())];
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

void evenOut(Surface& surface, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    if (round % 6 == 0) flipEdges(surface);
    spreadVertices(surface);
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

}  // namespace

InputMesh makeDoubleTorus(double edge) {
  std::vector<std::array<int, 3>> cells;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const bool hole = y == 1 && (x == 1 || x == 3);
      if (!hole) cells.push_back({x, y, 0});
    }
  }
  // Coarse first, because vertices that are evened out spread by one neighbour a round.
  constexpr double kCoarse = 0.1;
  int halvings = 0;
  for (; edge < kCoarse; edge *= 2) ++halvings;
  Surface surface = surfaceOf(makeBlocks(cells, edge / 0.69));
  evenOut(surface, 120);
  for (; halvings > 0; --halvings) {
    OpenMesh::Subdivider::Uniform::LoopT<Surface> cutInFour;
    cutInFour(surface, 1);
    evenOut(surface, 12);
  }
  for (const auto vertex : surface.vertices()) {
    Vec3d point = surface.point(vertex);
    project(point, 4);
    surface.set_point(vertex, point);
  }
  return inputOf(surface);
}

}  // namespace chartflood
