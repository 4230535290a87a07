#pragma once
/// Building of sample surfaces from rows of vertices that are joined by strips of triangles.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Vertices from left to right as seen from outside.
using Row = std::vector<Index>;

/// A smooth curve in the half plane of radius (x) and height (y), for t in [0, 1].
using Profile = std::function<glm::dvec2(double)>;

class SampleSurface {
 public:
  /// \param edge wanted length of the triangles' edges
  explicit SampleSurface(double edge) : edge_(edge) {}

  double edge() const { return edge_; }
  /// Rows at this distance make triangles with three equal angles.
  double rowDistance() const;
  /// How many edges make up a length, at least `least`.
  std::size_t edgesFor(double length, std::size_t least = 1) const;
  /// How many rows make up a length, at least 1.
  std::size_t rowsFor(double length) const;

  Index add(const glm::dvec3& position);
  const glm::dvec3& at(Index vertex) const { return mesh_.positions[vertex]; }
  glm::dvec3& at(Index vertex) { return mesh_.positions[vertex]; }

  /// New vertices between two that exist, on a curve with curve(0) and curve(1) at those.
  /// \param staggered moves the inner vertices by half a step, for every second row
  Row between(Index first, Index last, std::size_t edges, bool staggered,
              const std::function<glm::dvec3(double)>& curve);
  /// The same on the straight line; the number of edges follows from its length.
  Row line(Index first, Index last, bool staggered);

  /// A closed row of vertices around the z axis, counter-clockwise from above; one vertex when the
  /// radius is 0.
  Row ring(double radius, double height, bool staggered);

  /// Fills the strip between two rows, `upper` lying above `lower` as seen from outside, always
  /// choosing the shorter edge. Rows may share their end vertices.
  void zip(std::span<const Index> lower, std::span<const Index> upper);
  /// The same between closed rows.
  void zipRings(std::span<const Index> lower, std::span<const Index> upper);
  /// Rings along a profile, from the present `ring` on (at profile(0)), outside lying to the right
  /// of the profile's direction. \returns the last ring
  Row revolve(Row ring, const Profile& profile);
  /// The same onto a last ring that exists.
  void revolveOnto(Row ring, const Profile& profile, std::span<const Index> last);

  InputMesh take() { return std::move(mesh_); }

 private:
  void addTriangle(Index a, Index b, Index c);
  Row revolveUpTo(Row ring, const Profile& profile, bool withEnd);

  double edge_;
  InputMesh mesh_;
  bool staggered_ = false;  ///< of the ring that was made last
};

/// Length of a profile.
double lengthOf(const Profile& profile);
/// Points that cut a profile into `pieces` of equal length, its ends included.
std::vector<double> equalSteps(const Profile& profile, std::size_t pieces);
/// Straight line and cubic Bezier curve.
Profile straight(glm::dvec2 from, glm::dvec2 to);
Profile bezier(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d);

}  // namespace chartflood
