#pragma once
/// Colours that no map or palette gives; sRGB.

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace chartflood::colors {

inline constexpr glm::vec3 kClay(0.800f, 0.790f, 0.770f);
inline constexpr glm::vec3 kCalm(0.560f, 0.565f, 0.575f);  ///< the ground of discs and lines
inline constexpr glm::vec3 kDry(0.4157f);                  ///< 6A6A6A
inline constexpr glm::vec4 kInk(0.055f, 0.055f, 0.063f, 1);
inline constexpr glm::vec4 kChalk(0.93f, 0.93f, 0.90f, 1);
/// Cuts: told from seams by dashes and by lightness, so that no kind of colour vision is needed.
inline constexpr glm::vec4 kCut(1.0f, 0.72f, 0.10f, 1);

}  // namespace chartflood::colors
