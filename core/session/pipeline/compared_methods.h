#pragma once
/// Which methods are compared, and with which values each.

#include <array>
#include <string>

#include "core/session/settings/parameters.h"

namespace chartflood {

/// In the order of figure 6 of the paper.
inline constexpr std::array<const char*, 3> kComparedMethods = {"mcgim", "vsa", "t-flooding"};

/// The values for one method of a comparison: the same for all, with borders finished alike.
Parameters comparedWith(Parameters parameters, const std::string& method);

/// The same with borders as the method leaves them: its rivals' stay as they are grown, while
/// t-flooding keeps those of `parameters`, which are part of the method here.
Parameters asLeft(Parameters parameters, const std::string& method);

}  // namespace chartflood
