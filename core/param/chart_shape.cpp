#include "core/param/chart_shape.h"

#include "core/base/check.h"
#include "core/charts/chart_surface.h"

namespace chartflood {

ChartShape::ChartShape(const ChartSurface& chart)
    : surface(chart), rest(chart), pattern(chart.triangles, chart.vertexCount()),
      onBoundary(chart.vertexCount(), false) {
  const auto loops = boundaryLoops(chart);
  CF_CHECK(loops.size() == 1);
  for (const Index side : loops.front()) {
    boundary.push_back(chart.sideStart(side));
    onBoundary[boundary.back()] = true;
  }
}

}  // namespace chartflood
