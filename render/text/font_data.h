#pragma once
/// The font of pictures and window, built into the program so that text looks the same everywhere.

#include <span>

namespace chartflood {

/// The OpenType files of Inter, from the package fonts-inter. Valid for the life of the program.
std::span<const unsigned char> interRegular();
std::span<const unsigned char> interSemiBold();

}  // namespace chartflood
