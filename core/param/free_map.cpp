#include "core/param/free_map.h"

#include "core/param/border_crossings.h"
#include "core/param/circle_map.h"
#include "core/param/free_start.h"
#include "core/param/isometric_map.h"
#include "core/param/part_slits.h"

namespace chartflood {

namespace {

constexpr int kDirectSteps = 8, kGuardedSteps = 120;

/// Few steps from a free boundary; empty when triangles flip on the way.
std::vector<glm::dvec2> directStart(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = conformalMap(shape);
  if (uv.empty() || !localGlobalSteps(shape, 12, progress, uv)) return {};
  if (!scaleToUnitArea(shape.rest, uv) || !allPositive(shape.rest, uv)) return {};
  return uv;
}

bool simpleBoundary(const ChartShape& shape, const std::vector<glm::dvec2>& uv, Contact contact) {
  std::vector<bool> crossing;
  return !findCrossings(shape.boundary, uv, contact, crossing);
}

/// From a conformal map; empty when triangles flip or the chart covers itself.
std::vector<glm::dvec2> directMap(const ChartShape& shape, const Progress& progress) {
  std::vector<glm::dvec2> uv = directStart(shape, progress);
  if (uv.empty()) return {};
  minimiseIsometric(shape, {.steps = kDirectSteps}, progress, uv);
  if (!simpleBoundary(shape, uv, Contact::Deep) || !partSlits(shape, uv)) return {};
  return uv;
}

/// From a map that is one-to-one, never leaving such maps.
std::vector<glm::dvec2> guardedMap(const ChartShape& shape, std::vector<glm::dvec2> uv,
                                   const Progress& progress) {
  minimiseIsometric(shape, {.steps = kGuardedSteps, .guardBoundary = true}, progress, uv);
  std::vector<glm::dvec2> parted = uv;
  return partSlits(shape, parted) || simpleBoundary(shape, parted, Contact::Any) ? parted : uv;
}

}  // namespace

std::vector<glm::dvec2> freeMap(const ChartShape& shape, const std::vector<glm::dvec2>& before,
                                const Progress& progress) {
  std::vector<glm::dvec2> uv = directMap(shape, progress);
  if (!uv.empty() || progress.cancelled()) return uv;
  if (!before.empty()) {
    uv = before;
    if (scaleToUnitArea(shape.rest, uv) && partSlits(shape, uv) && allPositive(shape.rest, uv)) {
      return guardedMap(shape, std::move(uv), progress);
    }
  }
  uv = bestCircleMap(shape);
  if (uv.empty()) return {};
  return guardedMap(shape, std::move(uv), progress);
}

}  // namespace chartflood
