#pragma once
/// From numbers to colours: the colour maps, by name.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace chartflood {

/// Red, green, blue of 8 bits each, sRGB.
using Rgb8 = std::array<std::uint8_t, 3>;

/// Reads 0xRRGGBB.
constexpr Rgb8 rgb8(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8),
          static_cast<std::uint8_t>(hex)};
}

/// Evenly spaced colours, interpolated linearly between.
struct ColorMap {
  const char* id;                           ///< option value
  const char* label;                        ///< menu text
  bool diverging;                           ///< its middle is a neutral value
  bool colorBlindSafe;                      ///< readable with every common kind of colour vision
  const char* source;                       ///< where the colours come from
  std::span<const std::uint32_t> controls;  ///< 0xRRGGBB, first to last

  /// Colour at t, which is clamped to [0, 1]; sRGB components in [0, 1].
  glm::vec3 at(float t) const;
};

/// All maps, in the order of the menu.
std::span<const ColorMap> colorMapTable();
/// The map with this id, or nullptr.
const ColorMap* findColorMap(std::string_view id);

/// CIE L* of an sRGB colour with components in [0, 1]: 0 black to 100 white.
float lightness(const glm::vec3& color);

}  // namespace chartflood
