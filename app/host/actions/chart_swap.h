#pragma once
/// Two charts change their colours with each other, where neighbours still differ afterwards.

#include <vector>

#include "core/base/index.h"

namespace chartflood {

class AppState;

/// The charts that this one can change colours with, ascending: of another colour, and such that no
/// chart gets the colour of a neighbour. Empty while colours are not known yet. Cost: linear in
/// edges.
std::vector<Index> colorPartners(const AppState& state, Index chart);

/// \throws Refusal with one sentence when they cannot
void swapColors(AppState& state, Index chart, Index other);

}  // namespace chartflood
