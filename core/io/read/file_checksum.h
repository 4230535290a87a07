#pragma once
/// Tells whether a file is still the one that something was made from.

#include <filesystem>
#include <string>

namespace chartflood {

/// 64 bits over all bytes of a file as 16 hexadecimal digits; "" when it cannot be read. Guards
/// against mistakes, not against forgery. Cost: about that of reading the file.
std::string fileChecksum(const std::filesystem::path& file);

}  // namespace chartflood
