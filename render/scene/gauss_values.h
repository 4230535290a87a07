#pragma once
/// Gauss area as it is drawn: a value for each triangle, crease and corner of the surface (paper
/// section 3.2, figure 5). No GL.

#include <vector>

#include <glm/vec4.hpp>

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
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

}  // namespace chartflood
