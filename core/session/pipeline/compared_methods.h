#pragma once
/// With which values each method of a comparison runs.

#include <string>

#include "core/session/settings/parameters.h"

namespace chartflood {

/// The values for one method of a comparison: the same for all, with borders finished alike.
Parameters comparedWith(Parameters parameters, const std::string& method);

/// The same with borders as the method leaves them: those of `parameters` where refined borders are
/// part of the method, as they are grown elsewhere.
Parameters asLeft(Parameters parameters, const std::string& method);

}  // namespace chartflood
