#pragma once
/// Gauss area of creases and corners on the graphics card: a line for each crease, a disc for each
/// corner of the surface (paper section 3.2, figure 5).

#include <cstddef>

#include "render/gl/objects.h"
#include "render/scene/gauss_values.h"

namespace chartflood {

class GaussLayer {
 public:
  explicit GaussLayer(const GaussValues& values);

  std::size_t edgeCount() const { return edgeCount_; }
  std::size_t vertexCount() const { return vertexCount_; }

  /// Two texels a crease: (start, value), (end, 0).
  void bindEdges(GLuint unit) const { edges_.bind(unit); }
  /// Two texels a corner: (place, value), (0, 0, 0, 0).
  void bindVertices(GLuint unit) const { vertices_.bind(unit); }

 private:
  std::size_t edgeCount_ = 0, vertexCount_ = 0;
  gl::TextureBuffer edges_, vertices_;
};

}  // namespace chartflood
