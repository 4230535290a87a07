#include "core/param/free_map.h"

#include "core/param/border_crossings.h"
#include "core/param/circle_map.h"
#include "core/param/free_start.h"
#include "core/param/isometric_map.h"
#include "core/param/part_slits.h"

namespace chartflood {

namespace {

constexpr int kStartSteps = 12, kSketchSteps = 4;
constexpr int kDirectSteps = 8, kLooseSteps = 30, kSettlingSteps = 20, kGuardedSteps = 120;
constexpr double kLooseTolerance = 1e-3;

/// Few steps from a free boundary; empty when triangles flip on the way.
std::vector<glm::dvec2> directStart(const ChartShape& shape, int steps, const Progress& progress) {
  std::vector<glm::dvec2> uv = conformalMap(shape);
  if (uv.empty() || !localGlobalSteps(shape, steps, progress, uv)) return {};
  if (!scaleToUnitArea(shape.rest, uv) || !allPositive(shape.rest, uv)) return {};
  return uv;
}

bool simpleBoundary(const ChartShape& shape, const std::vector<glm::dvec2>& uv, Contact contact) {
  std::vector<bool> crossing;
  return !findCrossings(shape.boundary, uv, contact, crossing);
}

/// The map with its slits parted; empty when it covers itself.
std::vector<glm::dvec2> simpleOrNone(const ChartShape& shape, std::vector<glm::dvec2> uv) {
  if (!simpleBoundary(shape, uv, Contact::Deep) || !partSlits(shape, uv)) return {};
  return uv;
}

}  // namespace

std::vector<glm::dvec2> freeMap(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = directMap(shape, progress);
  return uv.empty() && !progress.cancelled() ? guardedMap(shape, progress) : uv;
}

std::vector<glm::dvec2> directMap(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = directStart(shape, kStartSteps, progress);
  if (uv.empty()) return {};
  minimiseIsometric(shape, {.steps = kDirectSteps}, progress, uv);
  return simpleOrNone(shape, std::move(uv));
}

std::vector<glm::dvec2> sketchedMap(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = directStart(shape, kSketchSteps, progress);
  return uv.empty() ? uv : simpleOrNone(shape, std::move(uv));
}

std::vector<glm::dvec2> looseMap(const ChartShape& shape, std::vector<glm::dvec2> start,
                                 const Progress& progress) {
  minimiseIsometric(shape, {.steps = kLooseSteps, .tolerance = kLooseTolerance}, progress, start);
  return start;
}

std::vector<glm::dvec2> settledMap(const ChartShape& shape, std::vector<glm::dvec2> loose,
                                   const Progress& progress) {
  minimiseIsometric(shape, {.steps = kSettlingSteps}, progress, loose);
  return simpleOrNone(shape, std::move(loose));
}

std::vector<glm::dvec2> guardedMap(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = bestCircleMap(shape);
  if (uv.empty()) return {};
  minimiseIsometric(shape, {.steps = kGuardedSteps, .guardBoundary = true}, progress, uv);
  std::vector<glm::dvec2> parted = uv;
  return partSlits(shape, parted) || simpleBoundary(shape, parted, Contact::Any) ? parted : uv;
}

}  // namespace chartflood
