#include "tests/core/param/param_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/charts/chart_surface.h"

namespace chartflood::test {

std::shared_ptr<const Mesh> surfaceOver(Index columns, Index rows, bool wrap,
                                        const std::function<glm::dvec3(double, double)>& place) {
  const Index width = wrap ? columns : columns + 1;
  std::vector<glm::dvec3> positions;
  for (Index r = 0; r <= rows; ++r) {
    for (Index c = 0; c < width; ++c) {
      positions.push_back(place(static_cast<double>(c) / columns, static_cast<double>(r) / rows));
    }
  }
  Polygons faces;
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < columns; ++c) {
      const Index a = r * width + c, b = r * width + (c + 1) % width;
      faces.push_back({a, b, b + width});
      faces.push_back({a, b + width, a + width});
    }
  }
  return meshOf(std::move(positions), faces);
}

CutChart wholeChart(const Mesh& mesh, const std::vector<std::pair<Index, Index>>& cuts) {
  CutChart chart;
  const std::vector<Index> label(mesh.faceCount(), 0);
  chart.surface = extractCharts(mesh, label, 1).front();
  chart.before = topologyOf(chart.surface);
  std::vector<Index> sides;
  for (const auto& [a, b] : cuts) {
    for (Index side = 0; side < chart.surface.opposite.size(); ++side) {
      if (chart.surface.meshVertex[chart.surface.sideStart(side)] == a &&
          chart.surface.meshVertex[chart.surface.sideEnd(side)] == b) {
        sides.push_back(side);
      }
    }
  }
  EXPECT_EQ(sides.size(), cuts.size());
  openAlong(chart.surface, sides);
  chart.topology = topologyOf(chart.surface);
  if (!chart.disk()) chart.problem = "It is no disk.";
  return chart;
}

std::shared_ptr<const ChartSet> setOf(std::vector<CutChart> charts) {
  auto set = std::make_shared<ChartSet>();
  for (CutChart& chart : charts) set->charts.push_back(std::move(chart));
  return set;
}

UnwrapResult unwrapWhole(const Mesh& mesh, const UnwrapOptions& options,
                         const std::vector<std::pair<Index, Index>>& cuts) {
  Progress progress;
  return unwrapCharts(mesh, setOf({wholeChart(mesh, cuts)}), options, progress);
}

namespace {

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::size_t badTriangles(const ChartSurface& surface, const std::vector<glm::dvec2>& uv) {
  return static_cast<std::size_t>(
      std::count_if(surface.triangles.begin(), surface.triangles.end(),
                    [&](const auto& t) { return !(turn(uv[t[0]], uv[t[1]], uv[t[2]]) > 0); }));
}

std::size_t crossings(const ChartSurface& surface, const std::vector<glm::dvec2>& uv) {
  const auto loops = boundaryLoops(surface);
  EXPECT_EQ(loops.size(), 1u);
  const auto& loop = loops.front();
  std::size_t count = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    for (std::size_t j = i + 2; j < loop.size() - (i == 0 ? 1 : 0); ++j) {
      const glm::dvec2 a = uv[surface.sideStart(loop[i])], b = uv[surface.sideEnd(loop[i])];
      const glm::dvec2 c = uv[surface.sideStart(loop[j])], d = uv[surface.sideEnd(loop[j])];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) ++count;
    }
  }
  return count;
}

void expectOneToOne(const ChartSurface& surface, const std::vector<glm::dvec2>& uv) {
  ASSERT_EQ(uv.size(), surface.vertexCount());
  for (const glm::dvec2& p : uv) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  EXPECT_EQ(badTriangles(surface, uv), 0u);
  EXPECT_EQ(crossings(surface, uv), 0u);
  glm::dvec2 low = uv.front(), high = uv.front();
  for (const glm::dvec2& p : uv) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double scale = 0.1 / std::max(high.x - low.x, high.y - low.y);
  std::vector<glm::dvec2> rounded = uv;
  for (glm::dvec2& p : rounded) {
    for (int i = 0; i < 2; ++i) {
      char text[32];
      std::snprintf(text, sizeof text, "%.9g", (p[i] - low[i]) * scale + 0.85);
      p[i] = std::strtod(text, nullptr);
    }
  }
  EXPECT_EQ(badTriangles(surface, rounded), 0u) << "after rounding";
  EXPECT_EQ(crossings(surface, rounded), 0u) << "after rounding";
}

double surfaceArea(const ChartSurface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const glm::dvec3& a = surface.positions[t[0]];
    sum += 0.5 * glm::length(glm::cross(surface.positions[t[1]] - a, surface.positions[t[2]] - a));
  }
  return sum;
}

double planeArea(const ChartSurface& surface, const std::vector<glm::dvec2>& uv) {
  double sum = 0;
  for (const auto& t : surface.triangles) sum += 0.5 * turn(uv[t[0]], uv[t[1]], uv[t[2]]);
  return sum;
}

}  // namespace chartflood::test
