#pragma once
/// The paper's way to find handles: a region grows over the chart until its fronts meet.

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/charts/front_loops.h"
#include "core/charts/open_surface.h"
#include "core/model/handle_record.h"

namespace chartflood {

/// Cuts handles while a region grows. Readings of the paper: "nearest first" goes by the distance
/// between centres of neighbouring faces; the two parts of a front that splits begin to remember
/// anew, as neither runs around what the whole did; two edges that meet in a vertex only do not
/// touch. The region grows as if nothing were cut, so that fronts meet once for each handle.
class WavefrontHandles {
 public:
  /// \param original the surface as it is in `open` now; must outlive this and stay as it is
  WavefrontHandles(const ChartSurface& original, OpenSurface& open);

  /// Grows over the whole chart, or until no handle is left if `onlyCuts`.
  void run(std::uint32_t seed, bool onlyCuts, const Progress& progress);
  HandleRecord takeRecord() { return std::move(record_); }

 private:
  /// What a front remembers: its shortest state.
  struct Kept {
    Index step = kNone;
    Index side = kNone;
    double length = 0;
  };

  void takeFace(Index face);
  void takeWithLids(Index face);
  void pushNeighbours(Index face, double distance);
  void remember();
  void happened(HandleEvent event);
  void openHandle(Index a, Index b);
  bool cutKept(Index front);
  void cutShortest();
  void recordCuts(HandleEvent event, const HandlePath& path);

  const ChartSurface& original_;
  OpenSurface& open_;
  LiddedSurface lidded_;
  FrontLoops fronts_;
  std::vector<Index> stepOfFace_;
  std::vector<glm::dvec3> centre_;
  std::vector<double> distance_;
  VertexQueue queue_;  ///< of faces
  std::vector<Kept> kept_;
  Index step_ = 0;
  HandleRecord record_;
  const Progress* progress_ = nullptr;
};

}  // namespace chartflood
