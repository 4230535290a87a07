#include "core/samples/sample_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace chartflood {

namespace {

constexpr int kFineSteps = 256;  ///< for measuring curves

double distance2(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); }

/// Length of a profile up to each of its fine steps.
std::vector<double> lengthsAlong(const Profile& profile) {
  std::vector<double> lengths(kFineSteps + 1, 0.0);
  for (int i = 1; i <= kFineSteps; ++i) {
    const double step = 1.0 / kFineSteps;
    lengths[static_cast<std::size_t>(i)] =
        lengths[static_cast<std::size_t>(i - 1)] +
        glm::distance(profile((i - 1) * step), profile(i * step));
  }
  return lengths;
}

}  // namespace

double SampleSurface::rowDistance() const { return edge_ * std::sqrt(3.0) / 2; }

std::size_t SampleSurface::edgesFor(double length, std::size_t least) const {
  return std::max(static_cast<std::size_t>(std::lround(length / edge_)), least);
}

std::size_t SampleSurface::rowsFor(double length) const {
  return std::max<std::size_t>(static_cast<std::size_t>(std::lround(length / rowDistance())), 1);
}

Index SampleSurface::add(const glm::dvec3& position) {
  mesh_.positions.push_back(position);
  return static_cast<Index>(mesh_.positions.size() - 1);
}

Row SampleSurface::between(Index first, Index last, std::size_t edges, bool staggered,
                           const std::function<glm::dvec3(double)>& curve) {
  if (first == last) return {first};
  Row row = {first};
  const double count = static_cast<double>(edges);
  for (std::size_t i = 1; i < edges + (staggered ? 1 : 0); ++i) {
    const double step = static_cast<double>(i) - (staggered ? 0.5 : 0.0);
    row.push_back(add(curve(step / count)));
  }
  row.push_back(last);
  return row;
}

Row SampleSurface::line(Index first, Index last, bool staggered) {
  const glm::dvec3 a = at(first), b = at(last);
  return between(first, last, edgesFor(glm::distance(a, b)), staggered,
                 [&](double t) { return a + t * (b - a); });
}

Row SampleSurface::ring(double radius, double height, bool staggered) {
  staggered_ = staggered;
  if (radius < 1e-9) return {add({0, 0, height})};
  const std::size_t count = edgesFor(2 * std::numbers::pi * radius, 5);
  Row row;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + (staggered ? 0.5 : 0.0)) /
                         static_cast<double>(count);
    row.push_back(add({radius * std::cos(angle), radius * std::sin(angle), height}));
  }
  return row;
}

void SampleSurface::addTriangle(Index a, Index b, Index c) {
  if (a == b || b == c || c == a) return;  // rows that share an end vertex
  mesh_.corners.insert(mesh_.corners.end(), {a, b, c});
}

void SampleSurface::zip(std::span<const Index> lower, std::span<const Index> upper) {
  std::size_t i = 0, j = 0;
  while (i + 1 < lower.size() || j + 1 < upper.size()) {
    const bool canLower = i + 1 < lower.size(), canUpper = j + 1 < upper.size();
    const bool alongLower =
        canLower && (!canUpper || distance2(at(lower[i + 1]), at(upper[j])) <=
                                      distance2(at(lower[i]), at(upper[j + 1])));
    if (alongLower) {
      addTriangle(lower[i], lower[i + 1], upper[j]);
      ++i;
    } else {
      addTriangle(lower[i], upper[j + 1], upper[j]);
      ++j;
    }
  }
}

void SampleSurface::zipRings(std::span<const Index> lower, std::span<const Index> upper) {
  Row low(lower.begin(), lower.end()), up(upper.begin(), upper.end());
  if (low.size() == 1) {
    up.push_back(up.front());
  } else if (up.size() == 1) {
    low.push_back(low.front());
  } else {
    const auto nearest = std::min_element(up.begin(), up.end(), [&](Index a, Index b) {
      return distance2(at(a), at(low.front())) < distance2(at(b), at(low.front()));
    });
    std::rotate(up.begin(), nearest, up.end());
    low.push_back(low.front());
    up.push_back(up.front());
  }
  zip(low, up);
}

Row SampleSurface::revolveUpTo(Row last, const Profile& profile, bool withEnd) {
  const std::vector<double> steps = equalSteps(profile, rowsFor(lengthOf(profile)));
  for (std::size_t i = 1; i + (withEnd ? 0 : 1) < steps.size(); ++i) {
    const glm::dvec2 p = profile(steps[i]);
    Row next = ring(p.x, p.y, !staggered_);
    zipRings(last, next);
    last = std::move(next);
  }
  return last;
}

Row SampleSurface::revolve(Row ring, const Profile& profile) {
  return revolveUpTo(std::move(ring), profile, true);
}

void SampleSurface::revolveOnto(Row ring, const Profile& profile, std::span<const Index> last) {
  zipRings(revolveUpTo(std::move(ring), profile, false), last);
}

double lengthOf(const Profile& profile) { return lengthsAlong(profile).back(); }

std::vector<double> equalSteps(const Profile& profile, std::size_t pieces) {
  const std::vector<double> lengths = lengthsAlong(profile);
  std::vector<double> steps = {0.0};
  std::size_t at = 1;
  for (std::size_t i = 1; i < pieces; ++i) {
    const double wanted = lengths.back() * static_cast<double>(i) / static_cast<double>(pieces);
    while (lengths[at] < wanted) ++at;
    const double part = (wanted - lengths[at - 1]) / (lengths[at] - lengths[at - 1]);
    steps.push_back((static_cast<double>(at - 1) + part) / kFineSteps);
  }
  steps.push_back(1.0);
  return steps;
}

Profile straight(glm::dvec2 from, glm::dvec2 to) {
  return [=](double t) { return from + t * (to - from); };
}

Profile bezier(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  return [=](double t) {
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
  };
}

}  // namespace chartflood
