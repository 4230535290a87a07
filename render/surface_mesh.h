#pragma once
/// The mesh as the graphics card sees it. Uploaded once; changes of colour mode or playhead touch
/// nothing here.

#include <cstddef>

#include "core/model/mesh.h"
#include "render/gl/objects.h"
#include "render/surface_vertices.h"

namespace chartflood {

/// Indexed triangles in the mesh's own order, so that gl_PrimitiveID is the triangle's number.
class SurfaceMesh {
 public:
  /// Uploads places and normals of the mesh's vertices.
  SurfaceMesh(const Mesh& mesh, const SurfaceVertices& vertices);

  /// The same mesh with other normals, with other texture places or without.
  void setVertices(const SurfaceVertices& vertices);

  std::size_t triangleCount() const { return triangleCount_; }
  bool hasNormals() const { return hasNormals_; }
  /// The triangles of a closed surface in one piece face inwards.
  bool insideOut() const { return insideOut_; }
  /// Insides of a closed surface in one piece need not be drawn.
  bool culled() const { return culled_; }
  /// Draws all triangles with the program in use (attributes 0: place, 1: normal, 2: texture place
  /// and scale), those seen from inside only where `outsideAlone` is false or the surface is open.
  void draw(bool outsideAlone) const { draw(outsideAlone, 0, triangleCount_); }
  /// The same for the triangles [first, first + count); shaders count primitives from 0 again.
  void draw(bool outsideAlone, std::size_t first, std::size_t count) const;
  /// Makes vertices (RGBA32F), indices (R32UI) and inner sides (R8UI) readable by shaders.
  void bindArrays(GLuint vertexUnit, GLuint indexUnit, GLuint innerSideUnit) const;

 private:
  std::size_t triangleCount_ = 0;
  bool culled_ = false, insideOut_ = false, hasNormals_ = false;
  gl::VertexArray vertexArray_;
  gl::Buffer vertices_, indices_, texturePlaces_;
  gl::Texture vertexTexture_, indexTexture_;
  gl::TextureBuffer innerSides_;
};

}  // namespace chartflood
