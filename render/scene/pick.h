#pragma once
/// What lies under a pixel of a picture of the model: a ray through the triangle tree. No GL.

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/mesh.h"
#include "core/model/triangle_tree.h"
#include "render/scene/camera.h"

namespace chartflood {

/// What lies under a pixel.
struct Pick {
  Index triangle = kNone;
  Index face = kNone;
  Index chart = kNone;  ///< kNone where the face has none
  glm::dvec3 point{0};  ///< on the surface, normalised units
  bool hit() const { return triangle != kNone; }
};

/// A pixel of a picture, counted from its top left.
struct PicturePixel {
  int width = 1, height = 1;  ///< of the picture
  int x = 0, y = 0;
  bool inside() const { return x >= 0 && y >= 0 && x < width && y < height; }
};

/// \param labels chart of each face; empty: there are none
/// \param hidden charts that are seen through
Pick pickModel(const TriangleTree& tree, const BoundingSphere& bounds, const Camera& camera,
               const PicturePixel& pixel, std::span<const Index> labels,
               const std::vector<Index>& hidden = {});

}  // namespace chartflood
