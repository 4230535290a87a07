#pragma once
/// Searches for the densest layout of shapes in a square: places them one by one in several orders,
/// then takes a few out of the best layouts and puts them back in, again and again.

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/pack/pack_shape.h"
#include "core/pack/squeeze.h"

namespace chartflood {

/// Among more charts than these a few that lie better change little.
constexpr std::size_t kManyCharts = 250;

/// Layouts found, the densest first; their shapes may still be pressed into each other by a small
/// part of the points' spacing. A fixed amount of work that grows little with the number of
/// shapes, shared out over the threads by independent layouts. Fills the progress up to
/// `lastFraction`.
/// \param largestSide starts with more room than a square of this side are not tried: a layout as
/// large is known
/// \return at least one layout; meaningless when cancelled
std::vector<PackLayout> searchLayouts(std::span<const PackShape> shapes, const PackGaps& gaps,
                                      double largestSide, float lastFraction, Progress& progress);

}  // namespace chartflood
