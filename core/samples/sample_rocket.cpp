/// The toy rocket: a body of revolution out of which three fins grow, all one closed surface.
///
/// Up to the top of the fins the surface is built from horizontal outlines. Each is a closed curve
/// with twelve corners: for each fin the two roots on the body and the two ends of its outer edge.
/// Rows of equal corners are joined into strips.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/samples/sample_shapes.h"
#include "core/samples/sample_surface.h"

namespace chartflood {

namespace {

constexpr std::size_t kFins = 3;
constexpr double kFinTop = 1.45;     ///< height where the fins leave the body
constexpr double kFinFoot = -0.95;   ///< height of their feet; the body ends at 0
constexpr double kFootOuter = 1.34;  ///< radius of the feet's outer edge
constexpr double kFootInner = 1.12;

struct Porthole {
  double height, radius, rim, rise;
};
constexpr std::array<Porthole, 2> kPortholes = {
    {{2.6, 0.23, 0.05, 0.065}, {1.98, 0.14, 0.04, 0.05}}};

glm::dvec2 belly(double t) { return bezier({0.34, 0}, {0.5, 0.5}, {0.58, 1.1}, {0.58, 1.7})(t); }

/// The parameter at which the belly has a height.
double bellyAt(double height) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (belly(middle).y < height ? low : high) = middle;
  }
  return low;
}

/// How far the surface of the body is pushed outwards: rims and panes of the portholes.
double rise(const glm::dvec3& p) {
  if (p.y > 0) return 0;
  double sum = 0;
  for (const Porthole& hole : kPortholes) {
    const double distance = std::hypot(p.x, p.z - hole.height);
    const double offset = (distance - hole.radius) / hole.rim;
    const double inside = std::max(0.0, 1 - distance * distance / (hole.radius * hole.radius));
    sum += hole.rise * std::exp(-offset * offset) + 0.5 * hole.rise * inside * inside;
  }
  return sum;
}

/// The outline of one height: vertices at the corners of each fin. "Left" is the side that comes
/// first counter-clockwise.
struct Corners {
  std::array<Index, kFins> rootLeft{}, rootRight{}, tipLeft{}, tipRight{};
};

/// The rows of an outline between its corners.
struct RocketOutline {
  std::array<Row, kFins> left, edge, right;  ///< root to tip, across the tip, tip to root
  std::array<Row, kFins> body;               ///< from this fin's right root to the next one's left
  std::array<Row, kFins> inner;              ///< right root to left root, below the body
};

class Rocket {
 public:
  explicit Rocket(double edge) : s_(edge) {}

  InputMesh make();

 private:
  static double finHalfWidth(double radius) { return 0.082 - 0.034 * radius; }
  static double outerRadius(double height);
  static double innerRadius(double height);
  static glm::dvec3 onFin(std::size_t fin, double radius, double side, double height);
  static double angleOf(const glm::dvec3& p) { return std::atan2(p.y, p.x); }

  Corners corners(double inner, double outer, double height, bool closed);
  Row arc(Index from, Index to, double radius, bool staggered);
  RocketOutline bodyOutline(double height, double radius, bool staggered);
  RocketOutline legOutline(double height, bool staggered);
  void fillSides(RocketOutline& outline, const Corners& c, bool staggered);
  void makeTail(const Row& nozzleRing, RocketOutline& outline);
  void makeLegs(RocketOutline outline);
  void makeFoot(const RocketOutline& outline, std::size_t fin);
  Row makeFinned(RocketOutline outline);
  void makeUpper(Row ring);

  SampleSurface s_;
};

/// The leading edge: leaves the body and turns downwards.
double Rocket::outerRadius(double height) {
  const double top = belly(bellyAt(kFinTop)).x;
  const double part = (kFinTop - height) / (kFinTop - kFinFoot);
  return top + (kFootOuter - top) * std::sin(part * std::numbers::pi / 2);
}

/// The trailing edge, from the end of the body to the foot.
double Rocket::innerRadius(double height) {
  const double part = height / kFinFoot;
  return 0.34 + (kFootInner - 0.34) * part * (1.3 - 0.3 * part);
}

/// The point of a fin's left (side -1) or right (side 1) face at a distance from the axis.
glm::dvec3 Rocket::onFin(std::size_t fin, double radius, double side, double height) {
  const double angle =
      std::numbers::pi / 2 + 2 * std::numbers::pi * static_cast<double>(fin) / kFins;
  const double across = side * finHalfWidth(radius);
  const double along = std::sqrt(radius * radius - across * across);
  return {along * std::cos(angle) - across * std::sin(angle),
          along * std::sin(angle) + across * std::cos(angle), height};
}

/// \param closed the tips coincide with the roots
Corners Rocket::corners(double inner, double outer, double height, bool closed) {
  Corners c;
  for (std::size_t fin = 0; fin < kFins; ++fin) {
    c.rootLeft[fin] = s_.add(onFin(fin, inner, -1, height));
    c.rootRight[fin] = s_.add(onFin(fin, inner, 1, height));
    c.tipLeft[fin] = closed ? c.rootLeft[fin] : s_.add(onFin(fin, outer, -1, height));
    c.tipRight[fin] = closed ? c.rootRight[fin] : s_.add(onFin(fin, outer, 1, height));
  }
  return c;
}

/// A row on the body, counter-clockwise.
Row Rocket::arc(Index from, Index to, double radius, bool staggered) {
  const double begin = angleOf(s_.at(from)), height = s_.at(from).z;
  double turn = angleOf(s_.at(to)) - begin;
  if (turn < 0) turn += 2 * std::numbers::pi;
  return s_.between(from, to, s_.edgesFor(turn * radius), staggered, [=](double t) {
    const double angle = begin + t * turn;
    return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), height);
  });
}

void Rocket::fillSides(RocketOutline& outline, const Corners& c, bool staggered) {
  for (std::size_t fin = 0; fin < kFins; ++fin) {
    outline.left[fin] = s_.line(c.rootLeft[fin], c.tipLeft[fin], staggered);
    outline.right[fin] = s_.line(c.tipRight[fin], c.rootRight[fin], staggered);
  }
}

RocketOutline Rocket::bodyOutline(double height, double radius, bool staggered) {
  const bool top = height >= kFinTop - 1e-9;
  const Corners c = corners(radius, outerRadius(height), height, top);
  RocketOutline outline;
  fillSides(outline, c, staggered);
  for (std::size_t fin = 0; fin < kFins; ++fin) {
    outline.body[fin] = arc(c.rootRight[fin], c.rootLeft[(fin + 1) % kFins], radius, staggered);
    outline.edge[fin] = top ? arc(c.tipLeft[fin], c.tipRight[fin], radius, false)
                            : s_.line(c.tipLeft[fin], c.tipRight[fin], false);
  }
  return outline;
}

RocketOutline Rocket::legOutline(double height, bool staggered) {
  const Corners c = corners(innerRadius(height), outerRadius(height), height, false);
  RocketOutline outline;
  fillSides(outline, c, staggered);
  for (std::size_t fin = 0; fin < kFins; ++fin) {
    outline.edge[fin] = s_.line(c.tipLeft[fin], c.tipRight[fin], false);
    const glm::dvec3 a = s_.at(c.rootRight[fin]), b = s_.at(c.rootLeft[fin]);
    outline.inner[fin] = s_.between(c.rootRight[fin], c.rootLeft[fin], outline.edge[fin].size() - 1,
                                    false, [&](double t) { return a + t * (b - a); });
  }
  return outline;
}

/// The flat end of the body around the nozzle; its outer ring also begins the legs.
void Rocket::makeTail(const Row& nozzleRing, RocketOutline& outline) {
  Row rim;
  for (std::size_t fin = 0; fin < kFins; ++fin) {
    const Index right = outline.body[fin].front();
    const Index left = outline.left[fin].front();
    outline.inner[fin] = s_.line(right, left, false);
    // Without the right end, which begins the body's row.
    rim.insert(rim.end(), outline.inner[fin].rbegin(), outline.inner[fin].rend() - 1);
    rim.insert(rim.end(), outline.body[fin].begin(), outline.body[fin].end() - 1);
  }
  const double inner = glm::length(glm::dvec2(s_.at(nozzleRing.front())));
  s_.revolveOnto(nozzleRing, straight({inner, 0}, {belly(0).x, 0}), rim);
}

void Rocket::makeFoot(const RocketOutline& outline, std::size_t fin) {
  const Row& edge = outline.edge[fin];
  Row inner(outline.inner[fin].rbegin(), outline.inner[fin].rend());
  Row right(outline.right[fin].rbegin(), outline.right[fin].rend());
  // Rows along the fin from its left side to its right one, seen from below.
  Row last = outline.left[fin];
  for (std::size_t i = 1; i + 1 < edge.size(); ++i) {
    Row next = s_.line(inner[i], edge[i], i % 2 == 1);
    s_.zip(next, last);
    last = std::move(next);
  }
  s_.zip(right, last);
}

void Rocket::makeLegs(RocketOutline outline) {
  const std::size_t rows = s_.rowsFor(-kFinFoot * 1.25);
  for (std::size_t i = 1; i <= rows; ++i) {
    const double height = kFinFoot * static_cast<double>(i) / static_cast<double>(rows);
    RocketOutline next = legOutline(height, i % 2 == 1);
    for (std::size_t fin = 0; fin < kFins; ++fin) {
      s_.zip(next.left[fin], outline.left[fin]);
      s_.zip(next.edge[fin], outline.edge[fin]);
      s_.zip(next.right[fin], outline.right[fin]);
      s_.zip(next.inner[fin], outline.inner[fin]);
    }
    outline = std::move(next);
  }
  for (std::size_t fin = 0; fin < kFins; ++fin) makeFoot(outline, fin);
}

/// The body with its fins, from the tail to their top. \returns the ring there
Row Rocket::makeFinned(RocketOutline outline) {
  const double end = bellyAt(kFinTop);
  const Profile part = [&](double t) { return belly(t * end); };
  const std::vector<double> steps = equalSteps(part, s_.rowsFor(lengthOf(part)));
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const glm::dvec2 p = part(steps[i]);
    const bool last = i + 1 == steps.size();
    RocketOutline next = bodyOutline(last ? kFinTop : p.y, p.x, i % 2 == 1);
    for (std::size_t fin = 0; fin < kFins; ++fin) {
      s_.zip(outline.left[fin], next.left[fin]);
      s_.zip(outline.edge[fin], next.edge[fin]);
      s_.zip(outline.right[fin], next.right[fin]);
      s_.zip(outline.body[fin], next.body[fin]);
    }
    outline = std::move(next);
  }
  Row ring;
  for (std::size_t fin = 0; fin < kFins; ++fin) {
    ring.insert(ring.end(), outline.edge[fin].begin(), outline.edge[fin].end() - 1);
    ring.insert(ring.end(), outline.body[fin].begin(), outline.body[fin].end() - 1);
  }
  return ring;
}

void Rocket::makeUpper(Row ring) {
  const double begin = bellyAt(kFinTop);
  ring = s_.revolve(ring, [&](double t) { return belly(begin + t * (1 - begin)); });
  ring = s_.revolve(ring, bezier({0.58, 1.7}, {0.58, 2.3}, {0.51, 2.9}, {0.41, 3.3}));
  ring = s_.revolve(ring, straight({0.41, 3.3}, {0.45, 3.3}));
  s_.revolve(ring, bezier({0.45, 3.3}, {0.4, 3.75}, {0.2, 4.2}, {0, 4.6}));
}

InputMesh Rocket::make() {
  Row ring = s_.ring(0, -0.06, false);
  ring = s_.revolve(ring, bezier({0, -0.06}, {0.09, -0.06}, {0.2, -0.2}, {0.25, -0.42}));
  ring = s_.revolve(ring, straight({0.25, -0.42}, {0.31, -0.42}));
  ring = s_.revolve(ring, bezier({0.31, -0.42}, {0.27, -0.2}, {0.2, -0.1}, {0.17, 0}));
  RocketOutline tail = bodyOutline(0, 0.34, false);
  makeTail(ring, tail);
  makeLegs(tail);
  makeUpper(makeFinned(tail));
  InputMesh mesh = s_.take();
  for (glm::dvec3& p : mesh.positions) {
    const double height = rise(p);
    if (height > 0) p *= glm::dvec3(glm::dvec2(1 + height / std::hypot(p.x, p.y)), 1);
  }
  return mesh;
}

}  // namespace

InputMesh makeRocket(double edge) { return Rocket(edge).make(); }

}  // namespace chartflood
