#pragma once
/// What drawing and plotting need of the surface beside the results.

#include <memory>

#include "core/model/corner_normals.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "render/scene/gauss_values.h"
#include "render/scene/surface_vertices.h"

namespace chartflood {

/// Depends on the mesh and the sharp edge angle alone.
struct SurfaceDerived {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const GaussArea> gaussArea;
  CornerNormals normals;
  std::shared_ptr<const SurfaceVertices> vertices;
  std::shared_ptr<const GaussValues> gaussValues;
};

}  // namespace chartflood
