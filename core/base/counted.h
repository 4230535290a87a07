#pragma once
/// Numbers of things in sentences.

#include <cstddef>
#include <string>

namespace chartflood {

/// "1 face", "3 faces".
inline std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace chartflood
