#pragma once
/// A picture of the user's in place of the checkerboard.

#include <filesystem>
#include <string>

#include "app/host/view_settings.h"

namespace chartflood {

class AppState;

/// Whether a file's name ends as those of pictures that can be read do.
bool isPictureFile(const std::filesystem::path& file);

/// Reads it and shows it on the charts. \throws ReadError with the view as it was
void setCheckerPicture(const std::filesystem::path& file, ViewSettings& view);

/// The same as the colours of the views, said in a toast. \throws ReadError
void putPictureOnCharts(AppState& state, const std::filesystem::path& file);

/// The squares again.
void dropCheckerPicture(ViewSettings& view);

}  // namespace chartflood
