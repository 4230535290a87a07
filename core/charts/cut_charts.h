#pragma once
/// Cuts charts until each is a disk (paper section 3.6).

#include <cstdint>
#include <memory>

#include "core/base/progress.h"
#include "core/charts/handle_cutter.h"
#include "core/model/chart_set.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"

namespace chartflood {

struct CutOptions {
  bool handles = true;  ///< HandleCutter
  bool loops = true;    ///< LoopMergeCutter, and opening of closed charts
  bool tips = true;     ///< slits long fingers
  double tip = 0.5;     ///< least distance of a tip from the boundary, in lengths of the boundary
                        ///< loop; above 0
  HandleSearch handleSearch = HandleSearch::Shortest;
  std::uint32_t seed = 1;  ///< of the faces from which wavefronts grow

  bool operator==(const CutOptions&) const = default;
};

/// Takes the charts out of the mesh and cuts them: handles, then loops, then tips. With handles and
/// loops on, every chart becomes a disk; one that does not says why in CutChart::problem.
/// The charts are independent of each other and shared out over the threads.
/// \return null when cancelled
std::shared_ptr<const ChartSet> cutCharts(const Mesh& mesh, const Segmentation& segmentation,
                                          const CutOptions& options, Progress& progress);

}  // namespace chartflood
