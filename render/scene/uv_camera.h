#pragma once
/// Looks at the texture plane from above: pure mathematics, no GL.
///
/// Texture places are (u, v) with v upwards; the texture is the square from 0 to 1. Places of the
/// picture are pixels from its top left, not whole numbers: (0.5, 0.5) is the middle of the first.

#include <glm/vec2.hpp>

#include "render/scene/eye.h"

namespace chartflood {

struct UvCamera {
  glm::dvec2 center{0.5};  ///< texture place in the middle of the picture
  double span = 1.14;      ///< texture units across the shorter side of the picture, > 0

  bool operator==(const UvCamera&) const = default;

  /// The whole texture with room for numbers at its frame.
  static UvCamera whole() { return {}; }
  /// The texture alone: a square picture holds exactly the places from 0 to 1.
  static UvCamera exact() { return {glm::dvec2(0.5), 1.0}; }

  /// Pixels for one texture unit in a picture of this size.
  double pixelsPerUnit(const glm::dvec2& size) const;
  glm::dvec2 toPixel(const glm::dvec2& uv, const glm::dvec2& size) const;
  glm::dvec2 toUv(const glm::dvec2& pixel, const glm::dvec2& size) const;

  /// Comes closer by `factor` > 1, keeping what is at `pixel` in its place. Stops where a picture
  /// would show less than kLeastSpan or more than kMostSpan texture units.
  void zoom(double factor, const glm::dvec2& pixel, const glm::dvec2& size);
  /// Shifts the picture so that what was at pixel `from` comes to `to`.
  void pan(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& size);
  /// Moves until the box between the two texture places fills the picture up to a margin.
  void frame(const glm::dvec2& low, const glm::dvec2& high, const glm::dvec2& size);

  static constexpr double kLeastSpan = 1e-4, kMostSpan = 20;
};

/// The same as uniforms of common/eye.glsl: texture places with z = 0 are "camera space".
Eye makeEye(const UvCamera& camera, const PicturePart& part);

}  // namespace chartflood
