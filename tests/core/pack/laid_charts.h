#pragma once
/// Charts in the plane for tests, made from polygons.

#include <vector>

#include <glm/vec2.hpp>

#include "core/base/rng.h"
#include "core/model/atlas.h"
#include "core/model/chart_set.h"
#include "core/model/unwrap.h"
#include "core/pack/layout_atlas.h"

namespace chartflood::test {

using Polygon = std::vector<glm::dvec2>;

/// Charts with their places in the plane.
struct LaidCharts {
  ChartSet charts;
  Unwrap unwrap;

  void add(const Polygon& vertices, const std::vector<std::array<Index, 3>>& triangles);
  /// A polygon whose first vertex sees all others, counter-clockwise.
  void addFan(const Polygon& polygon);
  void addRectangle(double width, double height);
  /// A band around a hole, cut open along one radius.
  void addRing(double inner, double outer, int parts);
  /// Four arms of length 1 that are thin.
  void addCross(double halfWidth);
  /// A round, uneven shape of about the given radius; now and then with long thin arms.
  void addBlob(double radius, Rng& rng);
  /// A chart that is not laid flat.
  void addUnlaid();

  std::shared_ptr<const Atlas> layout(const LayoutOptions& options) const;
};

/// Sum of the areas of all triangles at their places in the texture.
double coveredArea(const LaidCharts& laid, const Atlas& atlas);

/// What a raster of the texture shows, without any use of the program's own geometry.
struct RasterCheck {
  long sharedPixels = 0;    ///< touched by two charts
  int emptyBetween = 1000;  ///< fewest empty pixels between two charts, diagonals count as steps
  int emptyBorder = 1000;   ///< fewest empty pixels to the sides
};

/// Looks as far as `reach` pixels around each. A pixel is a chart's when a triangle touches it.
RasterCheck checkRaster(const LaidCharts& laid, const Atlas& atlas, int size, int reach);

}  // namespace chartflood::test
