#pragma once
/// Steps over the surface from face to face, for seeds that are moved by keys.

#include <functional>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// The face that lies best in a direction from another one, among those that share a corner with it
/// and that `free` allows: its middle less than about 70 degrees off as seen along `forward`.
/// kNone where there is none. `direction` and `forward` have unit length and are perpendicular.
Index faceTowards(const Mesh& mesh, Index face, const glm::dvec3& direction,
                  const glm::dvec3& forward, const std::function<bool(Index)>& free);

/// Area-weighted normal of a face, not of unit length; 0 for one without area.
glm::dvec3 faceNormal(const Mesh& mesh, Index face);

}  // namespace chartflood
