#pragma once
/// Which results do not belong to the present parameters.

#include <string_view>

namespace chartflood {

class AppState;

/// The script line that brings up to date what a section of the parameter table decides; "" where
/// it is, or where there is nothing yet. `group` is ParameterInfo::group.
std::string_view bringsUpToDate(const AppState& state, std::string_view group);

}  // namespace chartflood
