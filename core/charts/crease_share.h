#pragma once
/// How well borders of charts follow the creases of a model.

#include <span>

#include "core/base/index.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Length of the sharp edges that lie between two charts over the length of all sharp edges, in
/// [0, 1]; 0 without sharp edges.
/// \param label chart of each face
double creaseShare(const Mesh& mesh, const GaussArea& gauss, std::span<const Index> label);

}  // namespace chartflood
