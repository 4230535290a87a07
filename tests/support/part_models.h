#pragma once
/// Models of several parts, put together from simple bodies.

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "tests/support/test_meshes.h"

namespace chartflood::test {

/// Parts are separate: none shares a vertex with another.
class PartModel {
 public:
  /// Closed, of triangles; half as many rows as there are `around`.
  void addBall(const glm::dvec3& center, double radius, Index around);
  /// A closed or open surface of revolution around z. Where a radius is 0 there is a pole.
  /// \param profile radius and height, from below to above on the outside
  void addRevolved(const glm::dvec3& base, std::span<const glm::dvec2> profile, Index around);
  /// A box of triangles, two for each of the n x n squares of a side.
  void addBox(const glm::dvec3& corner, const glm::dvec3& size, Index n = 1);
  void addTetrahedron(const glm::dvec3& center, double size);
  /// Triangles around one vertex, not closed.
  void addFan(const glm::dvec3& center, double radius, Index triangles);
  /// A flat square of n x n squares of two triangles.
  void addGrid(const glm::dvec3& corner, double size, Index n);
  /// A prism with caps of triangles: the outline in x and y, counter-clockwise, seen from its first
  /// corner.
  void addPrism(const glm::dvec3& base, std::span<const glm::dvec2> outline, double height);

  std::shared_ptr<const Mesh> mesh() const { return meshOf(positions_, faces_); }

 private:
  Index add(const glm::dvec3& position);
  void quad(Index a, Index b, Index c, Index d);

  std::vector<glm::dvec3> positions_;
  Polygons faces_;
};

}  // namespace chartflood::test
