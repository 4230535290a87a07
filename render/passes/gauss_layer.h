#pragma once
/// Gauss area on the graphics card: a value for each triangle, a line for each crease, a disc for
/// each corner of the surface (paper section 3.2, figure 5).

#include <cstddef>
#include <vector>

#include <glm/vec4.hpp>

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "render/gl/objects.h"
#include "render/scene/scalar_range.h"

namespace chartflood {

/// Gauss area per area of each triangle, steradians over squared normalised units, averaged over a
/// neighbourhood of about 1 % of the model's diagonal: single triangles of a scanned mesh differ so
/// much that features would drown. Nothing is averaged across creases, nor where triangles are
/// larger than that. Sums over the surface stay as they are. Cost: linear, at most 40 rounds.
std::vector<double> smoothDensity(const Mesh& mesh, const GaussArea& gauss);

/// What a GaussLayer shows, worked out on any thread. All values are for the mesh scaled to a
/// bounding box diagonal d = 1: triangles carry steradians per area, creases steradians per length,
/// corners steradians.
struct GaussValues {
  ScalarRange faceRange, edgeRange, vertexRange;
  std::vector<float> faces;         ///< one a triangle
  std::vector<glm::vec4> edges;     ///< (start, value), (end, 0) of each crease
  std::vector<glm::vec4> vertices;  ///< (place, value), (0, 0, 0, 0) of each corner
};
GaussValues gaussValues(const Mesh& mesh, const GaussArea& gauss);

/// The values on the graphics card.
class GaussLayer {
 public:
  explicit GaussLayer(const GaussValues& values);

  const ScalarRange& faceRange() const { return faceRange_; }
  const ScalarRange& edgeRange() const { return edgeRange_; }
  const ScalarRange& vertexRange() const { return vertexRange_; }
  std::size_t edgeCount() const { return edgeCount_; }
  std::size_t vertexCount() const { return vertexCount_; }

  void bindFaceValues(GLuint unit) const { faceValues_.bind(unit); }
  /// Two texels a crease: (start, value), (end, 0).
  void bindEdges(GLuint unit) const { edges_.bind(unit); }
  /// Two texels a corner: (place, value), (0, 0, 0, 0).
  void bindVertices(GLuint unit) const { vertices_.bind(unit); }

 private:
  ScalarRange faceRange_, edgeRange_, vertexRange_;
  std::size_t edgeCount_ = 0, vertexCount_ = 0;
  gl::TextureBuffer faceValues_, edges_, vertices_;
};

}  // namespace chartflood
