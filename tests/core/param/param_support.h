#pragma once
/// Charts for the tests of the unwrap.

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/model/chart_set.h"
#include "core/model/unwrap.h"
#include "core/param/unwrap_charts.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {

/// Triangles over a grid of (columns + 1) x (rows + 1) places in [0, 1]^2, vertex numbers
/// row * (columns + 1) + column. With `wrap` the last column is the first one, and there are only
/// `columns` vertices in a row.
std::shared_ptr<const Mesh> surfaceOver(Index columns, Index rows, bool wrap,
                                        const std::function<glm::dvec3(double, double)>& place);

/// The whole mesh as one chart, opened along edges given by their mesh vertices.
CutChart wholeChart(const Mesh& mesh, const std::vector<std::pair<Index, Index>>& cuts = {});

std::shared_ptr<const ChartSet> setOf(std::vector<CutChart> charts);

/// Unwraps the mesh as one chart.
UnwrapResult unwrapWhole(const Mesh& mesh, const UnwrapOptions& options,
                         const std::vector<std::pair<Index, Index>>& cuts = {});

/// Every place finite, every triangle counter-clockwise, no boundary segment on another; the same
/// after scaling the chart to a tenth of the texture and rounding to 9 digits.
void expectOneToOne(const ChartSurface& surface, const std::vector<glm::dvec2>& uv);

/// Triangles that are not counter-clockwise.
std::size_t badTriangles(const ChartSurface& surface, const std::vector<glm::dvec2>& uv);
/// Pairs of boundary segments that cross, by all pairs, unlike the program.
std::size_t crossings(const ChartSurface& surface, const std::vector<glm::dvec2>& uv);

double surfaceArea(const ChartSurface& surface);
double planeArea(const ChartSurface& surface, const std::vector<glm::dvec2>& uv);

}  // namespace chartflood::test
