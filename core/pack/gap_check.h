#pragma once
/// The exact look at a finished layout: are all charts apart, to the last corner of their outlines?

#include <cstddef>
#include <span>
#include <vector>

#include "core/pack/chart_outline.h"
#include "core/pack/squeeze.h"

namespace chartflood {

/// A chart to be placed: its outline, the point of its plane that it is turned and scaled about,
/// and where in the texture that point goes.
struct PlacedOutline {
  const ChartOutline* outline = nullptr;
  glm::dvec2 center{0.0};
  Pose pose;  ///< texture units
};

/// What came of moving charts apart.
struct Settled {
  bool apart = false;
  double scale = 0;                ///< at the end
  std::vector<std::size_t> stuck;  ///< charts still too close to a larger one or to the border
};

/// Moves the charts a little and scales them down until all lie in the texture and keep the gaps
/// from each other: charts that are too close push each other apart, step by step, while the scale
/// falls with what is still missing. A chart in a narrow bay of another stays stuck.
/// Exact up to rounding: the distance of two outlines is that of their closest points, along the
/// axis where it is larger. Cost a step: about linear in the outlines' segments.
/// \param scale to begin with, texture units per unit of the charts' plane
/// \param steps at most, as many as are tried
Settled settle(std::span<PlacedOutline> charts, const PackGaps& gaps, double scale, int steps,
               const Progress& progress);

}  // namespace chartflood
