/// The gear wheel: hub, web and rim are turned; teeth are cut from outlines with four corners each.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "core/samples/sample_shapes.h"
#include "core/samples/sample_surface.h"

namespace chartflood {

namespace {

constexpr std::size_t kTeeth = 16;
constexpr double kBore = 0.24;        ///< radius
constexpr double kRootRadius = 1.22;  ///< between the teeth
constexpr double kTipRadius = 1.46;
constexpr double kRootShare = 0.54;  ///< of the pitch that a tooth takes at its root
constexpr double kTipShare = 0.3;
constexpr double kHubHeight = 0.42, kRimHeight = 0.24;  ///< from the middle plane

/// The four corners of each tooth at one height, counter-clockwise.
struct ToothCorners {
  Index rootFirst, tipFirst, tipLast, rootLast;
};

/// The parts of an outline at one height.
struct GearOutline {
  std::vector<ToothCorners> corners;
  std::vector<Row> rising, tip, falling, root;  ///< flank, tip, flank, and up to the next tooth
};

class Gear {
 public:
  explicit Gear(double edge) : s_(edge) {}
  InputMesh make();

 private:
  static double halfAngle(double radius);
  Index corner(std::size_t tooth, double radius, double side, double height);
  Row arc(Index from, Index to, bool staggered);
  GearOutline outline(double height, bool staggered);
  void joinOutlines(const GearOutline& lower, const GearOutline& upper);
  Row fillTeeth(const GearOutline& outline, bool top);

  SampleSurface s_;
};

/// Half of the angle that a tooth takes at a radius; its flanks are nearly straight.
double Gear::halfAngle(double radius) {
  const double part = (radius - kRootRadius) / (kTipRadius - kRootRadius);
  return std::numbers::pi / kTeeth * (kRootShare + part * (kTipShare - kRootShare));
}

Index Gear::corner(std::size_t tooth, double radius, double side, double height) {
  const double angle =
      2 * std::numbers::pi * static_cast<double>(tooth) / kTeeth + side * halfAngle(radius);
  return s_.add({radius * std::cos(angle), radius * std::sin(angle), height});
}

/// A row around the axis from one vertex counter-clockwise to another at the same radius.
Row Gear::arc(Index from, Index to, bool staggered) {
  const glm::dvec3 a = s_.at(from), b = s_.at(to);
  const double begin = std::atan2(a.y, a.x), radius = std::hypot(a.x, a.y);
  double turn = std::atan2(b.y, b.x) - begin;
  if (turn < 0) turn += 2 * std::numbers::pi;
  return s_.between(from, to, s_.edgesFor(turn * radius), staggered, [=](double t) {
    const double angle = begin + t * turn;
    return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), a.z);
  });
}

GearOutline Gear::outline(double height, bool staggered) {
  GearOutline o;
  for (std::size_t t = 0; t < kTeeth; ++t) {
    o.corners.push_back({corner(t, kRootRadius, -1, height), corner(t, kTipRadius, -1, height),
                         corner(t, kTipRadius, 1, height), corner(t, kRootRadius, 1, height)});
  }
  for (std::size_t t = 0; t < kTeeth; ++t) {
    const ToothCorners& c = o.corners[t];
    o.rising.push_back(s_.line(c.rootFirst, c.tipFirst, staggered));
    o.tip.push_back(arc(c.tipFirst, c.tipLast, staggered));
    o.falling.push_back(s_.line(c.tipLast, c.rootLast, staggered));
    o.root.push_back(arc(c.rootLast, o.corners[(t + 1) % kTeeth].rootFirst, staggered));
  }
  return o;
}

void Gear::joinOutlines(const GearOutline& lower, const GearOutline& upper) {
  for (std::size_t t = 0; t < kTeeth; ++t) {
    s_.zip(lower.rising[t], upper.rising[t]);
    s_.zip(lower.tip[t], upper.tip[t]);
    s_.zip(lower.falling[t], upper.falling[t]);
    s_.zip(lower.root[t], upper.root[t]);
  }
}

/// The flat faces of the teeth, row by row from their feet to their tips.
/// \returns the closed row on the rim that they stand on
Row Gear::fillTeeth(const GearOutline& o, bool top) {
  Row ring;
  for (std::size_t t = 0; t < kTeeth; ++t) {
    const Row& rising = o.rising[t];
    const Row falling(o.falling[t].rbegin(), o.falling[t].rend());
    Row last = arc(rising.front(), falling.front(), false);
    ring.insert(ring.end(), last.begin(), last.end() - 1);
    ring.insert(ring.end(), o.root[t].begin(), o.root[t].end() - 1);
    for (std::size_t i = 1; i < rising.size(); ++i) {
      const bool atTip = i + 1 == rising.size();
      Row next = atTip ? o.tip[t] : arc(rising[i], falling[i], i % 2 == 1);
      if (top) {
        s_.zip(next, last);
      } else {
        s_.zip(last, next);
      }
      last = std::move(next);
    }
  }
  return ring;
}

InputMesh Gear::make() {
  // From the hub to the rim; the upper side runs through it backwards.
  const std::array<Profile, 5> side = {
      straight({kBore, kHubHeight}, {0.46, kHubHeight}), straight({0.46, kHubHeight}, {0.46, 0.27}),
      bezier({0.46, 0.27}, {0.46, 0.18}, {0.51, 0.12}, {0.6, 0.12}),
      straight({0.6, 0.12}, {0.84, 0.12}),
      bezier({0.84, 0.12}, {0.94, 0.12}, {1.0, 0.16}, {1.02, kRimHeight})};
  const Profile rim = straight({1.02, kRimHeight}, {kRootRadius, kRimHeight});

  const Row first = s_.ring(kBore, -kHubHeight, false);
  Row ring = first;
  for (const Profile& part : side) {
    ring = s_.revolve(ring, [&](double t) { return part(t) * glm::dvec2(1, -1); });
  }
  GearOutline last = outline(-kRimHeight, false);
  s_.revolveOnto(
      ring, [&](double t) { return rim(t) * glm::dvec2(1, -1); }, fillTeeth(last, false));
  const std::size_t rows = s_.rowsFor(2 * kRimHeight);
  for (std::size_t i = 1; i <= rows; ++i) {
    const double height =
        kRimHeight * (-1 + 2 * static_cast<double>(i) / static_cast<double>(rows));
    GearOutline next = outline(height, i % 2 == 1 && i < rows);
    joinOutlines(last, next);
    last = std::move(next);
  }
  ring = s_.revolve(fillTeeth(last, true), [&](double t) { return rim(1 - t); });
  for (auto part = side.rbegin(); part != side.rend(); ++part) {
    ring = s_.revolve(ring, [&](double t) { return (*part)(1 - t); });
  }
  s_.revolveOnto(ring, straight({kBore, kHubHeight}, {kBore, -kHubHeight}), first);
  return s_.take();
}

}  // namespace

InputMesh makeGear(double edge) { return Gear(edge).make(); }

}  // namespace chartflood
