// The energy of the free unwrap against finite differences, and the solver against products.

#include "core/param/isometric_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "core/param/chart_shape.h"
#include "tests/core/param/param_support.h"

namespace chartflood {
namespace {

class Energy : public testing::Test {
 protected:
  Energy()
      : mesh_(test::sampleMesh("bumps", 200)), chart_(test::wholeChart(*mesh_)),
        shape_(chart_.surface) {
    std::mt19937 random(3);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    for (const glm::dvec3& p : chart_.surface.positions) {
      uv_.push_back(glm::dvec2(1.7 * p.x, -2.3 * p.z) / shape_.rest.unit +
                    1e-2 * glm::dvec2(number(), number()));
      way_.emplace_back(number(), number());
    }
    if (signedArea(shape_.rest, uv_) < 0) {
      for (glm::dvec2& p : uv_) p.x = -p.x;
    }
  }

  std::vector<glm::dvec2> moved(double length) const {
    std::vector<glm::dvec2> result = uv_;
    for (std::size_t v = 0; v < uv_.size(); ++v) result[v] += length * way_[v];
    return result;
  }
  std::vector<glm::dvec2> gradientAt(const std::vector<glm::dvec2>& uv) const {
    SparseLdl<glm::dmat2> system(shape_.pattern);
    system.clear();
    std::vector<glm::dvec2> gradient(uv.size(), glm::dvec2(0));
    addIsometricModel(shape_.rest, uv, StepModel::Newton, system, gradient);
    return gradient;
  }

  std::shared_ptr<const Mesh> mesh_;
  CutChart chart_;
  ChartShape shape_;
  std::vector<glm::dvec2> uv_, way_;
};

TEST_F(Energy, IsOneForAnIsometryAndKnownForAScale) {
  const auto plane = test::grid(5, true);
  const CutChart chart = test::wholeChart(*plane);
  const ChartShape shape(chart.surface);
  std::vector<glm::dvec2> uv;
  for (const glm::dvec3& p : chart.surface.positions) {
    uv.push_back(glm::dvec2(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y) / shape.rest.unit);
  }
  EXPECT_NEAR(isometricEnergy(shape.rest, uv), 1, 1e-12);
  for (glm::dvec2& p : uv) p *= 2;
  EXPECT_NEAR(isometricEnergy(shape.rest, uv), (4 + 0.25) / 2, 1e-12);
  for (glm::dvec2& p : uv) p.x = -p.x;
  EXPECT_TRUE(std::isinf(isometricEnergy(shape.rest, uv)));
}

TEST_F(Energy, GradientIsTheSlopeOfTheEnergy) {
  ASSERT_TRUE(allPositive(shape_.rest, uv_));
  const double h = 1e-6;
  const double slope =
      (isometricEnergy(shape_.rest, moved(h)) - isometricEnergy(shape_.rest, moved(-h))) / (2 * h);
  double expected = 0;
  const auto gradient = gradientAt(uv_);
  for (std::size_t v = 0; v < uv_.size(); ++v) expected += glm::dot(gradient[v], way_[v]);
  EXPECT_NEAR(slope, expected, 1e-6 * std::abs(expected));
}

TEST_F(Energy, NewtonStepsSolveTheSecondDerivativeWhereItIsDefinite) {
  // Enlarged by 1.7 and 2.3, no triangle's twist is negative, so that the model is exact: solving
  // with the change of the gradient along a way gives the way (a turn or shift costs nothing).
  ASSERT_TRUE(allPositive(shape_.rest, uv_));
  SparseLdl<glm::dmat2> system(shape_.pattern);
  system.clear();
  std::vector<glm::dvec2> gradient(uv_.size(), glm::dvec2(0));
  addIsometricModel(shape_.rest, uv_, StepModel::Newton, system, gradient);
  constexpr double kAnchor = 1e-3;
  for (Index v = 0; v < uv_.size(); ++v) system.addDiagonal(v, glm::dmat2(kAnchor));
  ASSERT_TRUE(system.factor());
  const double h = 1e-6;
  const auto ahead = gradientAt(moved(h)), behind = gradientAt(moved(-h));
  std::vector<glm::dvec2> x(uv_.size());
  for (std::size_t v = 0; v < x.size(); ++v) {
    x[v] = (ahead[v] - behind[v]) / (2 * h) + kAnchor * way_[v];
  }
  system.solve(x);
  for (std::size_t v = 0; v < x.size(); ++v) {
    EXPECT_NEAR(x[v].x, way_[v].x, 1e-4);
    EXPECT_NEAR(x[v].y, way_[v].y, 1e-4);
  }
}

TEST_F(Energy, ReweightedStepsHaveTheSameGradientAndGoDown) {
  SparseLdl<glm::dmat2> system(shape_.pattern);
  system.clear();
  std::vector<glm::dvec2> gradient(uv_.size(), glm::dvec2(0));
  addIsometricModel(shape_.rest, uv_, StepModel::Reweighted, system, gradient);
  const auto expected = gradientAt(uv_);
  for (std::size_t v = 0; v < uv_.size(); ++v) {
    EXPECT_NEAR(gradient[v].x, expected[v].x, 1e-12);
    EXPECT_NEAR(gradient[v].y, expected[v].y, 1e-12);
  }
  for (Index v = 0; v < uv_.size(); ++v) system.addDiagonal(v, glm::dmat2(1e-6));
  ASSERT_TRUE(system.factor());
  system.solve(gradient);
  double slope = 0;
  for (std::size_t v = 0; v < uv_.size(); ++v) slope -= glm::dot(gradient[v], expected[v]);
  EXPECT_LT(slope, 0);
}

TEST_F(Energy, TheLargestStepIsWhereTheFirstTriangleVanishes) {
  const double step = largestStep(shape_.rest, uv_, way_);
  ASSERT_TRUE(std::isfinite(step));
  EXPECT_TRUE(allPositive(shape_.rest, moved(0.999 * step)));
  EXPECT_FALSE(allPositive(shape_.rest, moved(1.001 * step)));
}

TEST_F(Energy, HermitianSystemsAreSolved) {
  SparseLdl<std::complex<double>> system(shape_.pattern);
  system.clear();
  std::mt19937 random(5);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  using Complex = std::complex<double>;
  std::vector<Complex> x(uv_.size()), b(uv_.size());
  for (Complex& value : x) value = {number(), number()};
  for (Index v = 0; v < uv_.size(); ++v) {
    system.addDiagonal(v, 20);
    b[v] = 20.0 * x[v];
  }
  for (Index side = 0; side < chart_.surface.opposite.size(); ++side) {
    const Complex entry(number(), number());
    const Index start = chart_.surface.sideStart(side), end = chart_.surface.sideEnd(side);
    system.addSide(side, entry);
    b[start] += entry * x[end];
    b[end] += std::conj(entry) * x[start];
  }
  ASSERT_TRUE(system.factor());
  std::vector<glm::dvec2> solution;
  for (const Complex& value : b) solution.emplace_back(value.real(), value.imag());
  system.solve(solution);
  for (std::size_t v = 0; v < x.size(); ++v) {
    EXPECT_NEAR(solution[v].x, x[v].real(), 1e-12);
    EXPECT_NEAR(solution[v].y, x[v].imag(), 1e-12);
  }
}

}  // namespace
}  // namespace chartflood
