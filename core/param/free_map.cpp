#include "core/param/free_map.h"

#include "core/param/border_crossings.h"
#include "core/param/circle_map.h"
#include "core/param/free_start.h"
#include "core/param/isometric_energy.h"
#include "core/param/isometric_map.h"
#include <limits>
#include "core/param/part_slits.h"
#include <cstdio>
#include <cstdlib>

namespace chartflood {

namespace {

constexpr double kCrossingSlack = 1e-5;

/// Few steps from a free boundary; empty when triangles flip on the way.
std::vector<glm::dvec2> directStart(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = conformalMap(shape);
  if (uv.empty() || !localGlobalSteps(shape, 12, progress, uv)) return {};
  if (!scaleToUnitArea(shape.rest, uv) || !allPositive(shape.rest, uv)) return {};
  return uv;
}

/// A start that never overlaps.
std::vector<glm::dvec2> circleStart(const ChartShape& shape) {
  std::vector<glm::dvec2> best;
  double least = std::numeric_limits<double>::infinity();
  for (const CircleWeights weights : {CircleWeights::Conformal, CircleWeights::Uniform}) {
    std::vector<glm::dvec2> uv = circleMap(shape, weights);
    if (uv.empty()) continue;
    const double energy = isometricEnergy(shape.rest, uv);
    if(getenv("DEBUG")) printf("  circle start %g\n",energy);
    if (!(energy < least)) continue;
    least = energy;
    best = std::move(uv);
  }
  return best;
}

}  // namespace

std::vector<glm::dvec2> freeMap(const ChartShape& shape, const Progress& progress) {
  static const bool debug = getenv("DEBUG") != nullptr;
  std::vector<bool> crossing;
  std::vector<glm::dvec2> uv = directStart(shape, progress);
  bool direct = !uv.empty();
  if (direct) {
    minimiseIsometric(shape, {.steps = 8}, progress, uv);
  } else {
    if (debug) printf("  circle start\n");
    uv = circleStart(shape);
    if (uv.empty()) return {};
    const char* s = getenv("CSTEPS");
    minimiseIsometric(shape, {.steps = s ? atoi(s) : 24}, progress, uv);
  }
  if (findCrossings(shape.boundary, uv, kCrossingSlack, crossing)) {
    if (debug) printf("  guarded\n");
    uv = circleStart(shape);
    if (uv.empty()) return {};
    minimiseIsometric(shape, {.steps = 120, .guardBoundary = true}, progress, uv);
  }
  if(!partSlits(shape, uv)&&getenv("WARN")) printf("  slits stay\n");
  return uv;
}

}  // namespace chartflood
