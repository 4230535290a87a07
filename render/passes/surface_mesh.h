#pragma once
/// The mesh as the graphics card sees it. Uploaded once; changes of colour mode or playhead touch
/// nothing here.

#include <cstddef>
#include <optional>

#include "core/model/mesh.h"
#include "render/gl/objects.h"
#include "render/scene/simple_surface.h"
#include "render/scene/surface_vertices.h"

namespace chartflood {

/// Vertices and triangles in buffers.
class SurfaceArrays {
 public:
  SurfaceArrays() : vertexArray_(gl::VertexArray::create()) {}

  void upload(const SurfaceVertices& vertices);
  bool uploaded() const { return static_cast<bool>(vertices_); }
  bool hasNormals() const { return hasNormals_; }
  /// Attributes 0: place, 1: normal, 2: texture place and scale.
  void draw(std::size_t first, std::size_t count) const;
  const gl::Buffer& vertices() const { return vertices_; }
  const gl::Buffer& indices() const { return indices_; }

 private:
  bool hasNormals_ = false;
  gl::VertexArray vertexArray_;
  gl::Buffer vertices_, indices_, texturePlaces_;
};

/// Indexed triangles in the mesh's own order, so that gl_PrimitiveID is the triangle's number; and,
/// if wanted, a simple form with far fewer.
class SurfaceMesh {
 public:
  /// Has nothing to draw before setVertices().
  explicit SurfaceMesh(const Mesh& mesh);

  /// Uploads places and normals of the mesh's vertices, with texture places or without.
  void setVertices(const SurfaceVertices& vertices);
  void setSimple(const SimpleSurface& simple);
  void forgetSimple() { simple_.reset(); }

  bool hasVertices() const { return arrays_.uploaded(); }
  std::size_t triangleCount() const { return triangleCount_; }
  bool hasNormals() const { return arrays_.hasNormals(); }
  /// The triangles of a closed surface in one piece face inwards.
  bool insideOut() const { return insideOut_; }
  /// Insides of a closed surface in one piece need not be drawn.
  bool culled() const { return culled_; }
  /// Draws all triangles with the program in use (attributes 0: place, 1: normal, 2: texture place
  /// and scale), those seen from inside only where `outsideAlone` is false or the surface is open.
  void draw(bool outsideAlone) const { draw(outsideAlone, 0, triangleCount_); }
  /// The same for the triangles [first, first + count); shaders count primitives from 0 again.
  void draw(bool outsideAlone, std::size_t first, std::size_t count) const;

  /// The simple form has this many triangles; 0: there is none.
  std::size_t simpleCount() const { return simple_ ? simple_->count : 0; }
  double simpleDetail() const { return simple_ ? simple_->detail : 0; }
  /// Draws triangles of the simple form. bindSimple() makes readable which triangle of the mesh
  /// each one stands for (R32UI).
  void drawSimple(bool outsideAlone, std::size_t first, std::size_t count) const;
  void bindSimple(GLuint unit) const;
  /// Makes vertices (RGBA32F), indices (R32UI) and inner sides (R8UI) readable by shaders.
  void bindArrays(GLuint vertexUnit, GLuint indexUnit, GLuint innerSideUnit) const;

 private:
  struct Simple {
    SurfaceArrays arrays;
    gl::TextureBuffer triangles;
    std::size_t count = 0;
    double detail = 0;
  };
  void draw(const SurfaceArrays& arrays, bool outsideAlone, std::size_t first,
            std::size_t count) const;

  std::size_t triangleCount_ = 0;
  bool culled_ = false, insideOut_ = false;
  SurfaceArrays arrays_;
  gl::Texture vertexTexture_, indexTexture_;
  gl::TextureBuffer innerSides_;
  std::optional<Simple> simple_;
};

}  // namespace chartflood
