#pragma once
/// Marks on the graphics card: the pattern of each triangle, lines on the model and in the texture.

#include <cstddef>
#include <vector>

#include "core/model/mesh.h"
#include "render/gl/objects.h"
#include "render/passes/cut_layer.h"
#include "render/scene/surface_marks.h"
#include "render/scene/uv_layout.h"

namespace chartflood {

class MarkLayer {
 public:
  /// \pre `marks.triangles` is empty or has an entry a triangle
  MarkLayer(const Mesh& mesh, const SurfaceMarks& marks);

  /// Draws the lines where this texture has them; null: it has them nowhere.
  void setTexture(const Mesh& mesh, const UvLayout* layout);

  bool marksTriangles() const { return marksTriangles_; }
  void bindTriangles(GLuint unit) const { triangles_.bind(unit); }

  struct Lines {
    CutLayer edges;
    EdgeLines look;  ///< without its sides
    gl::TextureBuffer inTexture;
    std::size_t inTextureCount = 0;
  };
  const std::vector<Lines>& lines() const { return lines_; }

 private:
  bool marksTriangles_ = false;
  gl::TextureBuffer triangles_;
  std::vector<Lines> lines_;
};

}  // namespace chartflood
