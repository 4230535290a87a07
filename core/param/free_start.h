#pragma once
/// Maps with a free boundary that may flip triangles: good places to start from.

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/progress.h"
#include "core/param/chart_shape.h"

namespace chartflood {

/// Least-squares conformal map (Levy, Petitjean, Ray, Maillot 2002; Desbrun, Meyer, Alliez 2002)
/// with two far boundary vertices pinned, scaled to area 1. Solved as one Hermitian system in
/// u + iv. \return empty when it cannot be solved or the result is not finite
std::vector<glm::dvec2> conformalMap(const ChartShape& shape);

/// Moves the vertices by up to `steps` local/global steps towards an isometry ("as rigid as
/// possible", Liu, Zhang, Xu, Gotsman, Gortler 2008). One factorisation serves all steps.
/// Ends early when cancelled, or when a step no longer helps.
/// \return false when the system cannot be solved; `uv` may then be anything
bool localGlobalSteps(const ChartShape& shape, int steps, const Progress& progress,
                      std::vector<glm::dvec2>& uv);

}  // namespace chartflood
