#pragma once
/// The view as a session file holds it: named plain values, by the names of the options where
/// there are some.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/host/settings/view_settings.h"
#include "core/session/files/session_io.h"

namespace chartflood {

using SessionView = std::map<std::string, SessionValue>;

/// What is worth keeping of a view: colours, overlays, ground, camera.
SessionView viewValues(const ViewSettings& view);

/// Sets what `values` names. With a camera among them the view no longer waits to be framed.
/// \returns sentences that name what is not known or cannot be used, and was left out.
/// \param folder where a picture that they name must lie, or below; "": none is opened
std::vector<std::string> applyViewValues(const SessionView& values, ViewSettings& view,
                                         const std::filesystem::path& folder = {});

}  // namespace chartflood
