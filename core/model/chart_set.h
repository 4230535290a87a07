#pragma once
/// The charts as surfaces, with the cuts that make them disks (paper section 3.6).

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/model/chart_surface.h"

namespace chartflood {

/// Why a cut was made.
enum class CutReason : std::uint8_t {
  Handle,  ///< opens a handle (HandleCutter)
  Open,    ///< gives a closed chart without handles a boundary
  Loop,    ///< joins two boundary loops (LoopMergeCutter)
  Tip,     ///< slits a long finger
  Relief,  ///< slits a chart where it would stretch too much
};

/// A path or loop of edges along which a chart is opened. Cuts change neither labels nor the
/// chart's Gauss area.
struct Cut {
  CutReason reason = CutReason::Handle;
  std::vector<Index> sides;  ///< sides of the mesh, one of each edge's two, in order along the path
  double length = 0;         ///< normalised units
};

/// A chart after cutting.
struct CutChart {
  ChartSurface surface;    ///< opened along all cuts
  std::vector<Cut> cuts;   ///< in the order they were made
  ChartTopology before;    ///< as segmented
  ChartTopology topology;  ///< of `surface`
  std::string problem;     ///< a sentence that says why it is no disk; "" when it is one

  bool disk() const { return topology.disk(); }
  double cutLength() const {
    double sum = 0;
    for (const Cut& cut : cuts) sum += cut.length;
    return sum;
  }
};

/// One entry a chart, by its number.
struct ChartSet {
  std::vector<CutChart> charts;
};

}  // namespace chartflood
