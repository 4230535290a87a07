#pragma once
/// The legends of all colour modes as one line of a session file.

#include <string>

#include "app/host/settings/view_settings.h"

namespace chartflood {

/// "stretch colormap=magma range=1,2; balance steps=5": the modes whose legend is not their own,
/// the one that is shown among them; "" without any.
std::string legendsText(const ViewSettings& view);

/// Takes it in, for the mode that is shown too. \returns false, with the view as it was, where
/// something is not known.
bool applyLegends(const std::string& text, ViewSettings& view);

}  // namespace chartflood
