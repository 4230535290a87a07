#pragma once
/// The moments that the pictures of a flood film show, for window and command line alike.

#include <cstddef>
#include <optional>

namespace chartflood {

/// Faces that are taken in picture `number` of `frames` (at least 2), evenly from none to all
/// `recorded`; nothing for the last one, which shows the finished charts.
inline std::optional<std::size_t> filmPlayhead(std::size_t recorded, std::size_t number,
                                               std::size_t frames) {
  if (number + 1 >= frames) return std::nullopt;
  return recorded * number / (frames - 1);
}

}  // namespace chartflood
