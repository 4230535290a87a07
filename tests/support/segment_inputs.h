#pragma once
/// What a segmenter is made from, for tests that start at a mesh.

#include <memory>
#include <utility>

#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/parts/segmenter.h"

namespace chartflood::test {

inline SegmentInputs segmentInputs(std::shared_ptr<const Mesh> mesh, double sharpAngle = 45,
                                   const FloodSpeeds& speeds = {}) {
  SegmentInputs in;
  in.mesh = std::move(mesh);
  in.gaussArea = std::make_shared<GaussArea>(computeGaussArea(*in.mesh, sharpAngle));
  in.floodGraph = std::make_shared<FloodGraph>(buildFloodGraph(*in.mesh, *in.gaussArea, speeds));
  return in;
}

}  // namespace chartflood::test
