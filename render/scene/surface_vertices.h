#pragma once
/// Vertices as the graphics card gets them, made without one: on any thread.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/model/corner_normals.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Corners of one vertex share an entry where their normals and texture places agree.
struct SurfaceVertices {
  /// One drawn vertex; 16 bytes, so that shaders can read the array as vec4 too.
  struct Vertex {
    std::array<float, 3> place;
    std::uint32_t normal;  ///< GL_INT_2_10_10_10_REV
  };
  std::vector<Vertex> vertices;
  std::vector<Index> indices;  ///< three a triangle, in the mesh's order
  bool hasNormals = false;     ///< else shading uses the plane of each triangle
  /// Place in the texture and scale of each vertex, as in UvLayout; empty: there is no texture.
  std::vector<glm::vec3> texture;
};

/// Gives each corner the entry of its vertex with the same normal, made when there is none yet.
/// `normals` may be null. Cost: linear.
std::shared_ptr<const SurfaceVertices> surfaceVertices(const Mesh& mesh,
                                                       const CornerNormals* normals);

/// The same vertices, parted where corners have different places in the texture. \param corners
/// place and scale of each corner, three a triangle. Cost: linear.
std::shared_ptr<const SurfaceVertices> partedVertices(const SurfaceVertices& whole,
                                                      std::span<const glm::vec3> corners);

}  // namespace chartflood
