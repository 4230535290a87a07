#pragma once
/// Short seams between charts of equal Gauss area: minimum cuts between two neighbouring charts at
/// a time, annealed from little to full weight of balance, from clusters of faces to single ones.
/// Beyond the paper, whose floods leave seams in stairs.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"
#include "core/model/seam_record.h"
#include "core/segment/parts/chart_price.h"

namespace chartflood {

/// Lowers the energy
///
///   seam length (creases times a factor) / sqrt(area) + w * mean_i ((B_i - mean) / mean)^2,
///   B_i = A(i) + eta * area(i),
///
/// over the charts that have a neighbour and their area; or with the one-sided balance of
/// SeamBalance, and with a method's own cost of faces, which is
/// fitted again after every pass. Every chart stays in one piece and keeps at least a twenty-fifth
/// of the mean area (or what it had), and the sum of max(0, 1 - Euler number) over the two charts
/// of a cut never grows; where it falls, that counts as a width of a chart. Pairs of charts without
/// a common chart are cut at the same time; those with one keep their order, so the result does not
/// depend on the number of threads.
class SeamCuts {
 public:
  struct Options {
    double weight = 1000;       ///< w: how much balance counts against short seams
    double creaseWeight = 0.3;  ///< length of a creaseLines() edge against others'
    double band = 0.15;         ///< width of the band around seams, in mean chart sizes
    double eta = 0;             ///< steradians a squared normalised unit of surface counts as
    std::span<const double> sideFactor = {};  ///< of hints, on the length of each side; empty: 1
    bool oneSided = false;                    ///< only charts above their share of the whole cost
    ChartPrice* price = nullptr;              ///< the method's own cost, added to the energy
    bool clusters = true;  ///< begin on clusters of faces; false: on single faces throughout
    bool sketch = false;   ///< few stages: seams end some per cent longer, in a fourth of the time
    bool anneal = true;    ///< false: the last two stages only, at full weight
  };

  /// \param fixed faces that keep their chart, for example seeds
  SeamCuts(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
           std::vector<Index> label, std::size_t charts, std::span<const Index> fixed,
           const Options& options);
  ~SeamCuts();

  /// Cuts until all stages are done or `progress` is cancelled; true when nothing is left to do.
  /// A cancelled run goes on where it stopped.
  bool run(Progress& progress);

  /// As of the last pass over all pairs that was ended, like energy() and record().
  std::span<const Index> labels() const;
  /// The energy above, of the present labels.
  double energy() const;
  /// What was done so far.
  const SeamRecord& record() const;

 private:
  class Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace chartflood
