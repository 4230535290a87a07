#pragma once
/// Cuts on the graphics card.

#include <cstddef>
#include <span>
#include <vector>

#include "core/model/mesh.h"
#include "render/gl/objects.h"
#include "render/scene/cut_path.h"

namespace chartflood {

class CutLayer {
 public:
  /// Sides in order along each path.
  CutLayer(const Mesh& mesh, std::span<const Index> sides);

  const std::vector<CutEdge>& edges() const { return edges_; }
  /// Triangle that each edge borders.
  const std::vector<Index>& triangle() const { return triangle_; }
  /// Two texels an edge: (place, length along the path) of its ends.
  void bind(GLuint unit) const { segments_.bind(unit); }

 private:
  std::vector<CutEdge> edges_;
  std::vector<Index> triangle_;
  gl::TextureBuffer segments_;
};

}  // namespace chartflood
