#include "core/param/isometric_energy.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace chartflood {

namespace {

using Complex = std::complex<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Complex unitOf(const Complex& z) {
  const double length = std::sqrt(std::norm(z));  // far from both ends of the range
  return length > 0 ? z / length : Complex(1, 0);
}

glm::dvec2 times(const Complex& a, const glm::dvec2& x) {
  return {a.real() * x.x - a.imag() * x.y, a.real() * x.y + a.imag() * x.x};
}
glm::dvec2 timesConjugate(const Complex& a, const glm::dvec2& x) { return times(a, {x.x, -x.y}); }
glm::dvec2 quarterTurn(const glm::dvec2& x) { return {-x.y, x.x}; }

/// Row times column; glm's matrices list columns.
glm::dmat2 outer(const glm::dvec2& a, const glm::dvec2& b) { return {a * b.x, a * b.y}; }

/// Derivatives of one triangle's energy with respect to its map. `turn` and `mirror` are the
/// directions of alpha and beta; the modes are growth (turn), twist (i turn), shear (mirror) and
/// flip (i mirror), each over sqrt(2).
struct MapModel {
  Complex turn, mirror;
  double slopeTurn = 0, slopeMirror = 0;                  // gradient along turn and mirror
  double scale = 0, scaleCross = 0, twist = 0, flip = 0;  // second derivatives
  double twistFlip = 0;
};

MapModel modelOf(const PlaneMap& map, StepModel kind) {
  MapModel m;
  m.turn = unitOf(map.alpha);
  m.mirror = unitOf(map.beta);
  const double s1 = std::sqrt(std::norm(map.alpha)) + std::sqrt(std::norm(map.beta));
  const double s2 = map.determinant() / s1;
  const double c1 = 1 / (s1 * s1 * s1), c2 = 1 / (s2 * s2 * s2);
  const double f1 = 0.5 * (s1 - c1), f2 = 0.5 * (s2 - c2);  // first derivatives
  m.slopeTurn = 0.5 * (f1 + f2);
  m.slopeMirror = 0.5 * (f1 - f2);
  if (kind == StepModel::Reweighted) {
    // f / (s - 1) for each row of the map in the frame of the singular vectors.
    const double w1 = 0.5 * (s1 + 1) * (s1 * s1 + 1) * c1;
    const double w2 = 0.5 * (s2 + 1) * (s2 * s2 + 1) * c2;
    m.scale = m.twist = m.flip = 0.5 * (w1 + w2);
    m.scaleCross = 0.5 * (w1 - w2);
    m.twistFlip = -m.scaleCross;
    return m;
  }
  const double g1 = 0.5 * (1 + 3 * c1 / s1), g2 = 0.5 * (1 + 3 * c2 / s2);
  m.scale = 0.5 * (g1 + g2);
  m.scaleCross = 0.5 * (g1 - g2);
  m.twist = std::max(0.0, 0.5 * (1 - (s1 * s1 - s1 * s2 + s2 * s2) * c1 * c2));
  m.flip = 0.5 * (1 + (s1 * s1 + s1 * s2 + s2 * s2) * c1 * c2);
  return m;
}

/// What moving a corner does to the four modes.
struct CornerModes {
  glm::dvec2 growth, shear, twist, flip;
  CornerModes(const MapModel& m, const glm::dvec2& gradient) {
    constexpr double kHalfRoot = 0.70710678118654752;
    growth = kHalfRoot * times(m.turn, gradient);
    shear = kHalfRoot * timesConjugate(m.mirror, gradient);
    twist = quarterTurn(growth);
    flip = quarterTurn(shear);
  }
};

glm::dmat2 block(const MapModel& m, const CornerModes& a, const CornerModes& b) {
  return outer(m.scale * a.growth + m.scaleCross * a.shear, b.growth) +
         outer(m.scale * a.shear + m.scaleCross * a.growth, b.shear) +
         outer(m.twist * a.twist + m.twistFlip * a.flip, b.twist) +
         outer(m.flip * a.flip + m.twistFlip * a.twist, b.flip);
}

}  // namespace

double isometricEnergy(const RestShape& rest, std::span<const glm::dvec2> uv) {
  double sum = 0;
  for (std::size_t t = 0; t < rest.triangleCount(); ++t) {
    const PlaneMap map = planeMap(rest, t, uv);
    const double det = map.determinant();
    if (!(det > 0)) return kInfinity;
    sum += rest.weight[t] * map.squaredNorm() * (1 + 1 / (det * det));
  }
  return std::isfinite(sum) ? 0.25 * sum : kInfinity;
}

void addIsometricModel(const RestShape& rest, std::span<const glm::dvec2> uv, StepModel model,
                       SparseLdl<glm::dmat2>& system, std::span<glm::dvec2> gradient) {
  for (std::size_t t = 0; t < rest.triangleCount(); ++t) {
    const double weight = rest.weight[t];
    const MapModel m = modelOf(planeMap(rest, t, uv), model);
    const auto& v = rest.triangles[t];
    const glm::dvec2 g1 = rest.gradient[t][0], g2 = rest.gradient[t][1];
    const Complex turn = weight * m.slopeTurn * m.turn, mirror = weight * m.slopeMirror * m.mirror;
    const glm::dvec2 p1 = times(turn, g1) + timesConjugate(mirror, g1);
    const glm::dvec2 p2 = times(turn, g2) + timesConjugate(mirror, g2);
    gradient[v[0]] -= p1 + p2;
    gradient[v[1]] += p1;
    gradient[v[2]] += p2;
    const CornerModes c1(m, g1), c2(m, g2);
    const glm::dmat2 k11 = weight * block(m, c1, c1), k22 = weight * block(m, c2, c2);
    const glm::dmat2 k12 = weight * block(m, c1, c2), k21 = glm::transpose(k12);
    system.addDiagonal(v[0], k11 + k12 + k21 + k22);
    system.addDiagonal(v[1], k11);
    system.addDiagonal(v[2], k22);
    const auto side = static_cast<Index>(3 * t);
    system.addSide(side, -(k11 + k21));      // row 0, column 1
    system.addSide(side + 1, k12);           // row 1, column 2
    system.addSide(side + 2, -(k21 + k22));  // row 2, column 0
  }
}

double largestStep(const RestShape& rest, std::span<const glm::dvec2> uv,
                   std::span<const glm::dvec2> direction) {
  double least = kInfinity;
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  for (const auto& v : rest.triangles) {
    const glm::dvec2 e1 = uv[v[1]] - uv[v[0]], e2 = uv[v[2]] - uv[v[0]];
    const glm::dvec2 d1 = direction[v[1]] - direction[v[0]], d2 = direction[v[2]] - direction[v[0]];
    // area2(t) = c + b t + a t^2, above 0 at t = 0.
    const double a = cross(d1, d2), b = cross(e1, d2) + cross(d1, e2), c = cross(e1, e2);
    const double root = b * b - 4 * a * c;
    if (root < 0) continue;
    // The smaller positive root, without taking near numbers from each other.
    const double q = -b + std::sqrt(root);
    if (b < 0) {
      least = std::min(least, 2 * c / q);
    } else if (a < 0) {
      least = std::min(least, (b + std::sqrt(root)) / (-2 * a));
    }
  }
  return least;
}

}  // namespace chartflood
