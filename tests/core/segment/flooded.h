#pragma once
/// A mesh with charts fresh from the flood, for tests of what refines their borders.

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/segment/parts/chart_areas.h"
#include "core/segment/t_flooding.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {

struct Flooded {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const GaussArea> gauss;
  FaceValues face;  ///< Gauss area of each face
  double eta = 0;
  Segmentation state;

  Flooded(std::shared_ptr<const Mesh> m, std::size_t charts) : mesh(std::move(m)) {
    gauss = std::make_shared<GaussArea>(computeGaussArea(*mesh, 45));
    face = faceGaussArea(*mesh, *gauss);
    SegmentOptions options;
    options.charts = charts;
    const auto graph = std::make_shared<FloodGraph>(buildFloodGraph(*mesh, *gauss, {}));
    eta = graph->eta;
    const auto stepper = makeTFlooding({mesh, gauss, graph}, options);
    Progress progress;
    stepper->advance(StepUnit::Flood, 5, progress);
    state = *stepper->state();
  }

  /// The same charts with other labels, measured.
  Segmentation relabelled(std::span<const Index> label) const {
    Segmentation s = state;
    s.label.assign(label.begin(), label.end());
    s.areas = chartAreas(*mesh, *gauss, face, s.label, s.chartCount);
    return s;
  }
};

}  // namespace chartflood::test
