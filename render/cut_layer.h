#pragma once
/// Cuts on the graphics card.

#include <cstddef>
#include <span>
#include <vector>

#include "core/model/mesh.h"
#include "render/cut_path.h"
#include "render/gl/objects.h"

namespace chartflood {

class CutLayer {
 public:
  /// Sides in order along each path.
  CutLayer(const Mesh& mesh, std::span<const Index> sides);

  const std::vector<CutEdge>& edges() const { return edges_; }
  std::size_t count() const { return edges_.size(); }
  /// Two texels an edge: (place, length along the path) of its ends.
  void bind(GLuint unit) const { segments_.bind(unit); }

 private:
  std::vector<CutEdge> edges_;
  gl::TextureBuffer segments_;
};

}  // namespace chartflood
