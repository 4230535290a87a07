#pragma once
/// Tells on the spot whether a closed walk on a surface parts it or goes around a handle.

#include <cstdint>
#include <vector>

#include "core/charts/open_surface.h"

namespace chartflood {

/// Every edge has a word of 64 bits. The words along a closed walk, added bit by bit without
/// carrying, give 0 when the walk parts the surface with its boundary loops closed by lids.
///
/// Each bit counts, modulo 2, how often the walk crosses one closed curve on the triangles. The
/// curves come from a spanning tree of the faces (polygons and lids) and the edges that are neither
/// crossed by it nor in a spanning tree of the vertices over the rest: two edges a handle (Eppstein
/// 2003, "Dynamic generators of topologically embedded graphs"). With up to 32 handles every curve
/// has its bit, and a word that is not 0 is both sufficient and necessary for a walk that does not
/// part the surface; with more, each bit stands for a random half of the curves, which misses a
/// walk with a chance of 1 in 2^32 or less and never takes a wrong one.
class HandleLabels {
 public:
  /// Labels the surface as it is now. Cost: linear in its size.
  void label(const OpenSurface& surface);
  std::uint64_t of(Index side) const { return label_[side]; }
  bool at(const OpenSurface& surface, Index vertex) const;

  /// To be told after the surface was opened along a curve with this word: curves that differ only
  /// by it become equal.
  void open(std::uint64_t word);
  /// False when so many handles were opened that the bits no longer tell curves apart for sure.
  bool sure() const { return exact_ || bits_ >= 32; }
  bool exact() const { return exact_; }

 private:
  std::vector<std::uint64_t> label_;
  bool exact_ = true;
  int bits_ = 64;
};

}  // namespace chartflood
