#pragma once
/// What all maps of one chart share.

#include <vector>

#include "core/param/rest_shape.h"
#include "core/param/sparse_ldl.h"

namespace chartflood {

/// A disk ready to be laid flat. `surface` must outlive it.
struct ChartShape {
  /// \pre the surface is a disk
  explicit ChartShape(const ChartSurface& chart);

  const ChartSurface& surface;
  RestShape rest;
  SparsePattern pattern;
  std::vector<Index> boundary;   ///< vertices around the boundary, counter-clockwise
  std::vector<bool> onBoundary;  ///< of each vertex
};

}  // namespace chartflood
