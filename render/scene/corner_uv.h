#pragma once
/// From charts, unwrap and atlas to what the renderer takes: arrays over the mesh.

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/index.h"
#include "core/model/atlas.h"
#include "core/model/chart_set.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Texture place of each corner of each triangle of the mesh: three entries a triangle, in its
/// corner order; NaN where its chart is not laid flat.
std::vector<glm::vec2> cornerUv(const Mesh& mesh, const ChartSet& charts, const Atlas& atlas);

/// The sides of all cuts, chart after chart and path after path.
std::vector<Index> cutSides(const ChartSet& charts);

}  // namespace chartflood
