#pragma once
/// What several actions need: each check gives the sentence that tells why not, "" when all is
/// there.

#include <string>

#include "app/host/script/action.h"
#include "core/base/index.h"

namespace chartflood {

class AppState;

std::string needsMesh(const AppState& state);
std::string needsCharts(const AppState& state);
std::string needsSeeds(const AppState& state);

/// Why a picture of this view ("3d", "uv", "both", "ab", "window") cannot be taken.
std::string pictureRefusal(const AppState& state, const std::string& view);

/// The chart that an action is told with "chart", or the selected one.
/// \throws Refusal where there is none, or not that one
Index namedChart(const AppState& state, const Arguments& arguments);

}  // namespace chartflood
