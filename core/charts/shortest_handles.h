#pragma once
/// The guaranteed way to cut handles: always along the shortest curve that does not part the chart.

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/charts/handle_labels.h"
#include "core/charts/open_surface.h"

namespace chartflood {

/// Finds the shortest closed walks along edges that go around a handle, boundary edges counting
/// nothing: around a base vertex a tree of shortest paths, and of the edges outside it the one that
/// closes the shortest loop with a word of labels that is not 0 (Erickson and Whittlesey 2005,
/// "Greedy optimal homotopy and homology generators"). Every vertex has a lower bound of the loops
/// through it, which a search passes on to its surroundings (a vertex d farther away can win at
/// most 2 d), so that few vertices become bases, and opening the surface only changes bounds near
/// the cut.
class ShortestHandles {
 public:
  explicit ShortestHandles(OpenSurface& surface);

  /// A walk of least length; empty when there is none, or when cancelled.
  std::optional<std::vector<Index>> find(const Progress& progress);
  /// Opens the surface along the path, which stems from the walk that find() returned.
  void open(const std::vector<Index>& walk, const HandlePath& path);

 private:
  struct Walk {
    double length = 0;
    std::vector<Index> sides;  ///< in order; inner sides point along the walk
  };

  void relabel();
  void search(Index base, double limit);
  void grow(Index base, double limit);
  void keepWalk(Index side);
  const Walk* bestWalk();
  bool stillAround(Walk& walk) const;
  void lowerBoundsNear(const std::vector<Index>& vertices);
  void resize();
  std::uint64_t wordOf(const std::vector<Index>& sides) const;

  OpenSurface& surface_;
  HandleLabels labels_;
  std::vector<double> bound_;  ///< no loop through the vertex is shorter
  VertexQueue bases_;          ///< by bound; entries may be outdated
  std::vector<Walk> walks_;
  VertexQueue known_;  ///< walks by length; entries may be outdated

  // One search: distance, side that leads there, word of the way, for vertices with the stamp.
  std::vector<double> distance_;
  std::vector<Index> side_;
  std::vector<std::uint64_t> word_;
  std::vector<std::uint32_t> stamp_, settled_;
  std::uint32_t search_ = 0;
  VertexQueue queue_;
  std::vector<Index> order_;
  double found_ = 0;
  Index foundSide_ = kNone;
};

}  // namespace chartflood
