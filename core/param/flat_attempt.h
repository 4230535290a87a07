#pragma once
/// One try at laying a chart flat, and how well it went.

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/progress.h"
#include "core/model/unwrap.h"
#include "core/param/chart_shape.h"
#include "core/param/stretch.h"
#include "core/param/unwrap_charts.h"

namespace chartflood {

struct FlatAttempt {
  ChartUv chart;
  std::vector<TriangleDistortion> triangles;  ///< empty when not laid flat
  std::size_t bad = 0;                        ///< triangles that are not counter-clockwise

  bool flat() const { return !chart.uv.empty(); }
  double stretch() const { return chart.distortion.l2; }
  /// Nothing is wrong with it and it stretches no more than `limit`.
  bool keeps(double limit) const { return flat() && bad == 0 && !(stretch() > limit); }
};

/// Fewer bad triangles, then less stretch.
bool better(const FlatAttempt& a, const FlatAttempt& b);

/// Scales and measures a map; an empty one is a problem.
FlatAttempt measuredMap(const ChartShape& shape, std::vector<glm::dvec2> places);

/// Lays a disk flat; with places that are empty or have flips, on a circle with equal weights.
FlatAttempt flatOrCircle(const ChartShape& shape, std::vector<glm::dvec2> places);

/// The map that the boundary asks for: a circle, or the free map.
FlatAttempt layFlat(const ChartShape& shape, UnwrapOptions::Boundary boundary,
                    const Progress& progress);

}  // namespace chartflood
