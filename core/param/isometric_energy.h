#pragma once
/// The energy that the free unwrap minimises, and its derivatives: the symmetric Dirichlet energy
/// (Schreiner, Asirvatham, Praun, Hoppe 2004; Smith, Schaefer 2015).

#include <limits>
#include <span>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "core/param/rest_shape.h"
#include "core/param/sparse_ldl.h"

namespace chartflood {

/// Mean over the area of (s1^2 + s2^2 + s1^-2 + s2^-2) / 4, with s1, s2 the singular values of the
/// map of each triangle: 1 for an isometry, infinite when a triangle is not counter-clockwise.
double isometricEnergy(const RestShape& rest, std::span<const glm::dvec2> uv);

/// Quadratic model that a step minimises.
enum class StepModel {
  /// The nearest rotation of each triangle with weights that give the energy's gradient
  /// (Rabinovich,
  /// Poranne, Panozzo, Sorkine-Hornung 2017, "Scalable locally injective mappings"): large steps
  /// from far away, but slow near the end.
  Reweighted,
  /// The second derivative, made positive semidefinite triangle by triangle. Its modes are known in
  /// closed form (Smith, De Goes, Kim 2019, "Analytic eigensystems for isotropic distortion
  /// energies"); only the one that turns a triangle can be negative, and is then left out. Fast
  /// near the end.
  Newton,
};

/// Adds the model's matrix to `system` and the gradient to `gradient` (one entry a vertex).
/// \pre every triangle is counter-clockwise
void addIsometricModel(const RestShape& rest, std::span<const glm::dvec2> uv, StepModel model,
                       SparseLdl<glm::dmat2>& system, std::span<glm::dvec2> gradient);

/// The largest step along `direction` that keeps every triangle counter-clockwise: the smallest
/// positive root of their areas, quadratic in the step; infinite when there is none.
double largestStep(const RestShape& rest, std::span<const glm::dvec2> uv,
                   std::span<const glm::dvec2> direction);

}  // namespace chartflood
