#include "core/gauss/spherical_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "core/gauss/winding_area.h"

namespace chartflood {

namespace {

constexpr double kFullSphere = 4 * std::numbers::pi;
/// Of both, tangents of a triangle's area: two of its corners are opposite each other.
constexpr double kUndefined = 1e-12;

/// Where the arcs a-b and c-d cross in their interiors; false when they do not.
bool properCrossing(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                    const glm::dvec3& d, glm::dvec3& crossing) {
  const glm::dvec3 ab = glm::cross(a, b), cd = glm::cross(c, d);
  const double sa = glm::dot(a, cd), sb = glm::dot(b, cd);
  const double sc = glm::dot(c, ab), sd = glm::dot(d, ab);
  const bool front = sa > 0 && sb < 0 && sc < 0 && sd > 0;
  const bool back = sa < 0 && sb > 0 && sc > 0 && sd < 0;
  if (!front && !back) return false;
  const glm::dvec3 along = glm::cross(ab, cd);
  const double length = glm::length(along);
  if (!(length > 0)) return false;
  crossing = along * ((front ? 1.0 : -1.0) / length);
  return true;
}

constexpr double kNearlyOpposite = -0.9999;
/// Areas that differ by less are equal; directions, too.
constexpr double kEqual = 1e-9;

double fanArea(std::span<const glm::dvec3> corners) {
  double area = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area += signedTriangleArea(corners[0], corners[i - 1], corners[i]);
  }
  return area;
}

/// Of a loop that does not cross itself: the smaller side.
PolygonArea simpleArea(double fan) {
  double area = std::remainder(fan, kFullSphere);
  if (area < kEqual - kFullSphere / 2) area += kFullSphere;  // half the sphere either way
  return {std::abs(area), area};
}

/// Two triangles where two of the sides cross, of which a quadrilateral has at most one pair. That
/// is so up to the place where the crossing reaches a corner and one triangle vanishes, so that
/// nothing hangs on how close calls are decided.
PolygonArea quadArea(std::span<const glm::dvec3> q) {
  glm::dvec3 x(0);
  double one = 0, other = 0;
  if (properCrossing(q[2], q[3], q[0], q[1], x)) {
    one = signedTriangleArea(q[1], q[2], x);
    other = signedTriangleArea(q[0], x, q[3]);
  } else if (properCrossing(q[3], q[0], q[1], q[2], x)) {
    one = signedTriangleArea(q[2], q[3], x);
    other = signedTriangleArea(q[0], q[1], x);
  } else {
    return simpleArea(fanArea(q));
  }
  return {std::abs(one) + std::abs(other), one + other};
}

/// Whether the end points of one arc lie clearly on one side of the other's circle.
bool onOneSide(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal) {
  const double least = kEqual * glm::length(normal);
  const double sa = glm::dot(a, normal), sb = glm::dot(b, normal);
  return (sa > least && sb > least) || (sa < -least && sb < -least);
}

/// True when all sides keep clear of those they have no corner with.
bool isClearlySimple(std::span<const glm::dvec3> corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % n];
    const glm::dvec3 ab = glm::cross(a, b);
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      const glm::dvec3 &c = corners[j], &d = corners[(j + 1) % n];
      if (!onOneSide(c, d, ab) && !onOneSide(a, b, glm::cross(c, d))) return false;
    }
  }
  return true;
}

/// Whether sides or the diagonals of the fan join corners that are nearly opposite.
bool hasOpposite(std::span<const glm::dvec3> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& next = corners[i + 1 < corners.size() ? i + 1 : 0];
    if (glm::dot(corners[i], next) < kNearlyOpposite) return true;
    if (glm::dot(corners[0], corners[i]) < kNearlyOpposite) return true;
  }
  return false;
}

/// Opposite corners have no shorter arc; theirs goes by a place that hangs on nothing but the two.
std::vector<glm::dvec3> withDetours(std::span<const glm::dvec3> corners) {
  const glm::dvec3 by(0.3142, 0.8153, -0.4861);  // in no plane that models are built along
  std::vector<glm::dvec3> all;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    all.push_back(a);
    if (glm::length(a + b) < kEqual) all.push_back(glm::normalize(by - glm::dot(by, a) * a));
  }
  return all;
}

}  // namespace

double signedTriangleArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double volume = glm::dot(a, glm::cross(b, c));
  const double base = 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a);
  // Nearly all triangles of a mesh are small: their arc tangent by its series, exact to 1e-17.
  if (base > 0 && std::abs(volume) < 0.05 * base) {
    const double x = volume / base, y = x * x;
    return 2 * x *
           (1 - y * (1.0 / 3 -
                     y * (1.0 / 5 - y * (1.0 / 7 - y * (1.0 / 9 - y * (1.0 / 11 - y / 13))))));
  }
  if (std::max(std::abs(volume), std::abs(base)) < kUndefined) return 0;
  return 2 * std::atan2(volume, base);
}

PolygonArea polygonArea(std::span<const glm::dvec3> corners) {
  const std::size_t n = corners.size();
  if (n < 3) return {};
  if (n == 3) return simpleArea(fanArea(corners));
  if (hasOpposite(corners)) return windingArea(withDetours(corners));
  if (n == 4) return quadArea(corners);
  return isClearlySimple(corners) ? simpleArea(fanArea(corners)) : windingArea(corners);
}

}  // namespace chartflood
