#pragma once
/// Pictures of the user's, PNG or JPEG.

#include <filesystem>

#include "render/image.h"

namespace chartflood {

/// The largest side that is kept; larger pictures are halved until they fit.
inline constexpr int kLargestPicture = 4096;

/// \throws ReadError naming the file and what is wrong with it.
Image readPicture(const std::filesystem::path& file);

}  // namespace chartflood
