#pragma once
/// Patterns and lines that point at places of the surface, whatever else is shown. Each has a
/// colour and a pattern of its own, so that no kind of colour vision is needed. No GL.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"

namespace chartflood {

/// What a triangle is marked with; values of uMarks in surface.frag.
enum class TriangleMark : std::uint8_t {
  None,
  Stripes,  ///< rising to the right
  Lattice,  ///< rising and falling
  Bars,     ///< level
  Dots,
};
inline constexpr std::size_t kTriangleMarks = 5;

/// Vermilion, blue, purple and yellow that differ with every kind of colour vision (M. Okabe and
/// K. Ito, "Color Universal Design", 2008); sRGB in [0, 1].
glm::vec3 markColor(TriangleMark mark);

/// Lines along edges of the mesh, drawn whatever else is shown.
struct EdgeLines {
  std::vector<Index> sides;  ///< sides of the mesh, in order along each path
  glm::vec3 color{1};        ///< sRGB in [0, 1]
  float width = 2;           ///< pixels, as in RenderSettings
  bool dashed = false;
};

/// All marks of a mesh.
struct SurfaceMarks {
  std::vector<TriangleMark> triangles;  ///< one each; empty: none is marked
  std::vector<EdgeLines> lines;         ///< the first ones lowest; also drawn in the texture
};

}  // namespace chartflood
