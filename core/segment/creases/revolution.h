#pragma once
/// Bodies of revolution whose sharp edges are circles around their axis: bottles, shafts, wheels.

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// True when sharp edges cut the model into rings around one axis:
/// - four fifths of their length are closed circles around it,
/// - and nine tenths of the surface look towards the axis or away from it.
/// Cost: linear, apart from sorting sharp edges.
bool ringsBetweenCreases(const Mesh& mesh, const GaussArea& gauss);

}  // namespace chartflood
