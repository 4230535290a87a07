#pragma once
/// Pictures of the user's, PNG or JPEG.

#include <filesystem>

#include "core/base/file_bytes.h"
#include "render/scene/image.h"

namespace chartflood {

/// The largest side that is kept; larger pictures are halved until they fit.
inline constexpr int kLargestPicture = 4096;

/// Opens the file as every file is opened; what it says of its size is held against kMostPixels and
/// against its own bytes before memory is asked for.
/// \throws ReadError naming the file and what is wrong with it.
Image readPicture(const std::filesystem::path& file);

}  // namespace chartflood
