#pragma once
/// A picture of the user's in place of the checkerboard.

#include <filesystem>
#include <string>

#include "app/host/settings/view_settings.h"

namespace chartflood {

/// Whether a file's name ends as those of pictures that can be read do.
bool isPictureFile(const std::filesystem::path& file);

/// Reads it and shows it on the charts. \throws ReadError with the view as it was
void setCheckerPicture(const std::filesystem::path& file, ViewSettings& view);

/// The squares again.
void dropCheckerPicture(ViewSettings& view);

}  // namespace chartflood
