#pragma once
/// The texture plane on the graphics card: its lines. The triangles are those of SurfaceMesh.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/gl/objects.h"
#include "render/scene/uv_layout.h"

namespace chartflood {

class UvLayer {
 public:
  UvLayer(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const UvLayout> layout);

  /// Draws these borders as cuts from now on.
  void setCuts(std::span<const CutEdge> cuts);

  const UvLayout& layout() const { return *layout_; }
  std::shared_ptr<const UvLayout> sharedLayout() const { return layout_; }
  std::size_t outlineCount() const { return outlineCount_; }
  /// Triangle that each segment of the cuts borders.
  const std::vector<Index>& cutTriangle() const { return cutTriangle_; }
  /// Lines of an island in the outlines, without its cuts.
  const SegmentRange& outlineOf(Index island) const { return outlineOf_[island]; }
  void bindOutlines(GLuint unit) const { outlines_.bind(unit); }
  void bindCuts(GLuint unit) const { cuts_.bind(unit); }

  /// The place on the surface where a triangle has this texture place; normalised units.
  glm::dvec3 surfacePoint(Index triangle, const glm::dvec2& uv) const;

 private:
  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const UvLayout> layout_;
  std::vector<SegmentRange> outlineOf_;
  std::size_t outlineCount_ = 0;
  std::vector<Index> cutTriangle_;
  gl::TextureBuffer outlines_, cuts_;
};

}  // namespace chartflood
