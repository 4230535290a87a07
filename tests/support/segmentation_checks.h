#pragma once
/// What must hold of every finished segmentation, whatever the method.

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"

namespace chartflood::test {

/// Every face labelled, every chart connected across edges and holding its seed, areas adding up.
void expectValid(const Mesh& mesh, const GaussArea& gauss, const Segmentation& segmentation);

}  // namespace chartflood::test
