#include "core/gauss/winding_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace chartflood {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
/// More events than needed do no harm, so arcs are taken for longer than they are.
constexpr double kArcSlack = 1e-9;
/// An arc whose circle's normal has less to the north lies along a meridian.
constexpr double kMeridian = 1e-140;
/// Areas that differ by less are equal.
constexpr double kEqualAreas = 1e-9;

/// North, and the direction of the first meridian: in no plane that models are built along.
struct Axes {
  glm::dvec3 x, y, north;
};

std::array<Axes, 3> axesCandidates() {
  const glm::dvec3 a = glm::normalize(glm::dvec3(0.5281, 0.3743, 0.7623));
  const glm::dvec3 b = glm::normalize(glm::cross(a, glm::dvec3(0.2117, -0.8931, 0.3967)));
  const glm::dvec3 c = glm::cross(a, b);
  return {{{a, b, c}, {b, c, a}, {c, a, b}}};
}

/// The axes whose poles are farthest from all corners.
Axes axesFor(std::span<const glm::dvec3> corners) {
  static const std::array<Axes, 3> all = axesCandidates();
  double best = 2;
  const Axes* chosen = all.data();
  for (const Axes& axes : all) {
    double nearest = 0;
    for (const glm::dvec3& c : corners) {
      nearest = std::max(nearest, std::abs(glm::dot(c, axes.north)));
    }
    if (nearest < best - kEqualAreas) {
      best = nearest;
      chosen = &axes;
    }
  }
  return *chosen;
}

/// Of a longitude, in [0, 2 pi).
double wrapped(double angle) {
  angle = std::fmod(angle, kTurn);
  if (angle < 0) angle += kTurn;
  return angle < kTurn ? angle : 0.0;
}

/// A side of the polygon in the frame of the axes (north is z).
struct SphereArc {
  glm::dvec3 normal;  ///< of its great circle, the way from begin to end counter-clockwise
  double begin = 0;   ///< longitude of its western end
  double width = 0;   ///< how far east it goes, below pi
  bool eastward = true;

  bool spans(double longitude, double slack) const {
    return wrapped(longitude - begin + slack) <= width + 2 * slack;
  }
  /// Tangent of the latitude on a meridian.
  double height(const glm::dvec2& meridian) const {
    return -(normal.x * meridian.x + normal.y * meridian.y) / normal.z;
  }
};

std::vector<SphereArc> arcsOf(std::span<const glm::dvec3> corners, const Axes& axes) {
  std::vector<glm::dvec3> p;
  for (const glm::dvec3& c : corners) {
    p.emplace_back(glm::dot(c, axes.x), glm::dot(c, axes.y), glm::dot(c, axes.north));
  }
  std::vector<SphereArc> arcs;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::dvec3 &a = p[i], &b = p[(i + 1) % p.size()];
    SphereArc arc;
    arc.normal = glm::cross(a, b);
    if (std::abs(arc.normal.z) < kMeridian) continue;  // bounds no slice
    arc.eastward = arc.normal.z > 0;
    const glm::dvec3 &west = arc.eastward ? a : b, &east = arc.eastward ? b : a;
    arc.begin = wrapped(std::atan2(west.y, west.x));
    arc.width = wrapped(std::atan2(east.y, east.x) - arc.begin);
    if (arc.width > std::numbers::pi) continue;  // by rounding: it is narrower than that
    arcs.push_back(arc);
  }
  return arcs;
}

/// Longitudes at which arcs begin, end or cross, ascending.
std::vector<double> eventsOf(const std::vector<SphereArc>& arcs) {
  std::vector<double> events = {0};
  for (const SphereArc& arc : arcs) {
    events.push_back(arc.begin);
    events.push_back(wrapped(arc.begin + arc.width));
  }
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (std::size_t j = i + 1; j < arcs.size(); ++j) {
      const glm::dvec3 meet = glm::cross(arcs[i].normal, arcs[j].normal);
      if (meet.x == 0 && meet.y == 0) continue;
      for (const double side : {1.0, -1.0}) {
        const double longitude = wrapped(std::atan2(side * meet.y, side * meet.x));
        if (arcs[i].spans(longitude, kArcSlack) && arcs[j].spans(longitude, kArcSlack)) {
          events.push_back(longitude);
        }
      }
    }
  }
  std::sort(events.begin(), events.end());
  events.erase(std::unique(events.begin(), events.end()), events.end());
  events.push_back(kTurn);
  return events;
}

glm::dvec2 meridianAt(double longitude) { return {std::cos(longitude), std::sin(longitude)}; }

glm::dvec3 pointAt(const glm::dvec2& meridian, double height) {
  return glm::dvec3(meridian, height) / std::sqrt(1 + height * height);
}

/// The arcs of the present slice by height; kept from slice to slice, where it hardly changes.
struct ArcCrossing {
  double height;
  std::size_t arc;
};

/// Area of the sphere by winding number, taken as 0 at the south pole.
std::map<long, double> areaByWinding(const std::vector<SphereArc>& arcs) {
  std::map<long, double> area;
  const std::vector<double> events = eventsOf(arcs);
  std::vector<ArcCrossing> slice;
  for (std::size_t e = 0; e + 1 < events.size(); ++e) {
    const double width = events[e + 1] - events[e], middle = events[e] + width / 2;
    const glm::dvec2 west = meridianAt(events[e]), east = meridianAt(events[e + 1]);
    const glm::dvec2 between = meridianAt(middle);
    slice.clear();
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (arcs[i].spans(middle, 0)) slice.push_back({arcs[i].height(between), i});
    }
    std::sort(slice.begin(), slice.end(), [](const ArcCrossing& a, const ArcCrossing& b) {
      return a.height != b.height ? a.height < b.height : a.arc < b.arc;
    });
    long winding = 0;
    double below = 2 * width;  // from the bottom of the band to the north pole
    for (const ArcCrossing& crossing : slice) {
      const SphereArc& arc = arcs[crossing.arc];
      const double above = signedTriangleArea({0, 0, 1}, pointAt(west, arc.height(west)),
                                              pointAt(east, arc.height(east)));
      area[winding] += below - above;
      winding += arc.eastward ? 1 : -1;
      below = above;
    }
    area[winding] += below;
  }
  return area;
}

}  // namespace

PolygonArea windingArea(std::span<const glm::dvec3> corners) {
  const std::map<long, double> area = areaByWinding(arcsOf(corners, axesFor(corners)));
  PolygonArea best;
  bool first = true;
  for (const auto& [zero, ignored] : area) {
    PolygonArea sum;
    for (const auto& [winding, part] : area) {
      sum.absolute += static_cast<double>(std::abs(winding - zero)) * part;
      sum.signedArea += static_cast<double>(winding - zero) * part;
    }
    const bool equal = std::abs(sum.absolute - best.absolute) <= kEqualAreas;
    if (first || (equal ? sum.signedArea > best.signedArea : sum.absolute < best.absolute)) {
      best = sum;
    }
    first = false;
  }
  best.absolute = std::clamp(best.absolute, 0.0, 2 * kTurn);
  return best;
}

}  // namespace chartflood
