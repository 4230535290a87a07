#pragma once
/// A picture of the user's put on the charts, by a drop, by the file browser or by an action.

#include <filesystem>

namespace chartflood {

class AppState;

/// Reads it and makes it the colours of the views, said in a toast. \throws ReadError
void putPictureOnCharts(AppState& state, const std::filesystem::path& file);

}  // namespace chartflood
