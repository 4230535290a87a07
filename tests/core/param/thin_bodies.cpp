#include "tests/core/param/thin_bodies.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/support/test_meshes.h"

namespace chartflood::test {

namespace {

std::shared_ptr<const Mesh> turnedMesh(std::vector<glm::dvec3> positions, const Polygons& faces) {
  const auto turn = [](double& a, double& b, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), before = a;
    a = before * c - b * s;
    b = before * s + b * c;
  };
  for (glm::dvec3& p : positions) {
    turn(p.x, p.y, 0.3);
    turn(p.y, p.z, 1.1);
    turn(p.z, p.x, -0.7);
  }
  return meshOf(std::move(positions), faces);
}

}  // namespace

std::shared_ptr<const Mesh> thinBody(const ThinBody& body) {
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<Index>> rings;
  for (Index r = 0; r <= body.rings; ++r) {
    const double at = static_cast<double>(r) / body.rings;
    const double radius = r == body.rings ? body.tip / 2 : 0.5 + (body.tip / 2 - 0.5) * at;
    const Index corners = radius > 0 ? body.sides : 1;
    std::vector<Index>& ring = rings.emplace_back();
    for (Index i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / body.sides;
      ring.push_back(static_cast<Index>(positions.size()));
      positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), at * body.length);
    }
  }
  Polygons faces;
  for (Index r = 0; r < body.rings; ++r) {
    const auto &low = rings[r], &high = rings[r + 1];
    for (Index i = 0; i < body.sides; ++i) {
      const Index j = (i + 1) % body.sides;
      if (high.size() == 1) {
        faces.push_back({low[i], low[j], high[0]});
        continue;
      }
      faces.push_back({low[i], low[j], high[j]});
      faces.push_back({low[i], high[j], high[i]});
    }
  }
  if (body.closed) {
    faces.emplace_back(rings.front().rbegin(), rings.front().rend());
    if (rings.back().size() > 1) faces.push_back(rings.back());
  }
  return turnedMesh(std::move(positions), faces);
}

std::shared_ptr<const Mesh> thinStrip(Index columns, double length) {
  std::vector<glm::dvec3> positions;
  for (const double y : {0.0, 1.0}) {
    for (Index c = 0; c <= columns; ++c) positions.emplace_back(length * c / columns, y, 0);
  }
  Polygons faces;
  for (Index c = 0; c < columns; ++c) {
    const Index above = c + columns + 1;
    faces.push_back({c, c + 1, above + 1});
    faces.push_back({c, above + 1, above});
  }
  return turnedMesh(std::move(positions), faces);
}

std::shared_ptr<const Mesh> thinFan(Index points, double sag) {
  std::vector<glm::dvec3> positions;
  for (Index i = 0; i <= points; ++i) {
    const double x = static_cast<double>(i) / points;
    positions.emplace_back(x, -4 * sag * x * (1 - x), 0);
  }
  positions.emplace_back(1, 1, 0);
  positions.emplace_back(0, 1, 0);
  Polygons faces;
  for (Index i = 1; i + 1 < positions.size(); ++i) faces.push_back({0, i, i + 1});
  return turnedMesh(std::move(positions), faces);
}

}  // namespace chartflood::test
