#pragma once
/// Cuts measured along their paths, so that dashes run on from edge to edge. No GL.

#include <span>
#include <vector>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// One edge of a cut. The path is `from` long at the start of `side` and `to` at its end
/// (normalised units); `from` is the larger where the path runs against the side.
struct CutEdge {
  Index side = kNone;
  float from = 0, to = 0;
};

/// Measures sides that are given in order along their paths. A path ends where a side does not go
/// on from the one before; the next one starts at 0.
std::vector<CutEdge> measureCuts(const Mesh& mesh, std::span<const Index> sides);

}  // namespace chartflood
