#pragma once
/// How colours look to people with another kind of colour vision. No GL.

#include <span>
#include <string_view>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace chartflood {

enum class ColorVision {
  Full,
  RedBlind,    ///< protanopia
  GreenBlind,  ///< deuteranopia
  BlueBlind,   ///< tritanopia
};

struct ColorVisionInfo {
  ColorVision vision;
  const char* id;     ///< argument of the action
  const char* label;  ///< menu text
};
/// One row a kind, in the order of the enumeration.
std::span<const ColorVisionInfo> colorVisionTable();
const ColorVisionInfo& colorVisionInfo(ColorVision vision);
/// The kind with this id, or nullptr.
const ColorVisionInfo* findColorVision(std::string_view id);

/// Turns linear RGB into the linear RGB that looks the same to everyone as the first does to the
/// colour-blind (Machado, Oliveira, Fernandes 2009, table of full severity). Greys stay. The
/// product may leave [0, 1].
glm::mat3 visionMatrix(ColorVision vision);
/// The same for an sRGB colour with components in [0, 1].
glm::vec3 seenColor(const glm::vec3& color, ColorVision vision);

}  // namespace chartflood
