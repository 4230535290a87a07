#pragma once
/// The exact look at a finished layout: are all charts apart, to the last corner of their outlines?

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

/// The largest scale found, at most `largest` (texture units per unit of the charts' plane), at
/// which all charts lie in the texture and keep the gaps from each other; they are scaled about
/// their centres, which stay where they are. 0: none.
/// Exact up to rounding: the distance of two outlines is that of their closest points, along the
/// axis where it is larger. Cost: about linear in the outlines' segments, several times.
double largestScale(std::span<const PlacedOutline> charts, const PackGaps& gaps, double largest);

}  // namespace chartflood
