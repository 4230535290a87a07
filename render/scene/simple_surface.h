#pragma once
/// Far fewer triangles in place of a dense mesh's, for pictures in motion where drawing is slow.
/// Made without a graphics card, on any thread.

#include <cstddef>
#include <memory>
#include <vector>

#include "core/model/mesh.h"
#include "render/scene/surface_vertices.h"
#include "render/scene/uv_layout.h"

namespace chartflood {

struct SimpleSurface {
  SurfaceVertices surface;       ///< with texture places where there is a layout
  std::vector<Index> triangles;  ///< of the mesh: the one that each triangle stands for
  double detail = 0;             ///< size of what became one point, normalised units

  bool empty() const { return triangles.empty(); }
};

/// Vertices in one cell of a grid become one, in the middle of all (vertex clustering: Rossignac
/// and Borrel, 1993); triangles whose corners are in three cells stay. Corners of different islands
/// of the texture, or with normals far from each other, stay apart in the same place. What is
/// thinner than a cell and would vanish stays as it is.
/// \param vertices of the mesh, without texture places
/// \param layout of the texture; may be null
/// \param wanted number of triangles; about so many are left, and what is thin. Empty when that is
/// more than half of the mesh
/// Cost: linear.
std::shared_ptr<const SimpleSurface> simpleSurface(const Mesh& mesh,
                                                   const SurfaceVertices& vertices,
                                                   const UvLayout* layout, std::size_t wanted);

}  // namespace chartflood
