#pragma once
/// A chart that is being opened, with what the HandleCutter asks of it kept up to date: opening
/// costs as much as the path and the boundary loops it touches are long.

#include <optional>
#include <span>
#include <vector>

#include "core/charts/chart_surface.h"
#include "core/charts/edge_paths.h"

namespace chartflood {

class OpenSurface {
 public:
  /// Works on `surface` in place.
  explicit OpenSurface(ChartSurface& surface);

  const ChartSurface& surface() const { return surface_; }
  std::size_t vertexCount() const { return surface_.vertexCount(); }
  Index firstSide(Index vertex) const { return firstSide_[vertex]; }
  /// Length of an edge as a way: nothing along the boundary, where no cut is needed.
  double wayLength(Index side) const { return length_[side]; }
  bool boundarySide(Index side) const { return surface_.opposite[side] == kNone; }
  /// Number of the boundary loop that the vertex lies on, below loopNumbers(); kNone inside.
  Index loopOf(Index vertex) const { return loopOf_[vertex]; }
  Index loopNumbers() const { return static_cast<Index>(loopStart_.size()); }
  /// A side of each loop; kNone for a loop that is no more.
  Index loopStart(Index loop) const { return loopStart_[loop]; }
  /// The boundary side that follows a boundary side, the surface on the left.
  Index nextOnBoundary(Index side) const;
  /// V - E + F, number of boundary loops, and of handles if the surface is in one piece.
  long euler() const { return euler_; }
  long loops() const { return loopCount_; }
  long genus() const { return (2 - loopCount_ - euler_) / 2; }

  /// Opens the surface along sides that are not on the boundary. Vertices are numbered as
  /// openAlong() does.
  void open(std::span<const Index> sides);

  /// True when the two triangles at the first side stay joined if these sides are opened. For a
  /// closed curve without crossings that tells whether the surface stays in one piece.
  bool staysConnected(std::span<const Index> sides);

 private:
  void renumberFans(std::vector<Index>& corners);
  void traceLoops(const std::vector<Index>& corners);

  ChartSurface& surface_;
  std::vector<Index> firstSide_;
  std::vector<double> length_;
  std::vector<Index> loopOf_;
  std::vector<Index> loopStart_;
  long euler_ = 0;
  long loopCount_ = 0;
  std::vector<std::uint32_t> triangleMark_, sideMark_;
  std::uint32_t mark_ = 0;
  std::vector<Index> stack_;
};

/// A way to open one handle: a closed curve, or arcs that close over boundary loops.
struct HandlePath {
  /// Inner sides in order along each piece. One closed curve, or one arc between two points of one
  /// boundary loop; else each arc but the last joins two loops, and the last closes the curve.
  std::vector<std::vector<Index>> pieces;
  bool whole = true;  ///< holds all inner sides of the walk it comes from
};

/// The shortest part of a closed walk that lowers the number of handles by one: it meets each
/// vertex and boundary loop at most once and does not part the surface. Empty when there is none,
/// or when the walk has a gap.
/// \param walk sides in order; inner ones point along the walk, boundary ones are passed over
std::optional<HandlePath> handlePath(OpenSurface& surface, std::span<const Index> walk);

}  // namespace chartflood
