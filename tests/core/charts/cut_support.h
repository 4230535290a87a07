#pragma once
/// Meshes and checks for the tests of the cutters.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "core/charts/chart_surface.h"
#include "core/charts/cut_charts.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {

/// Torus of n (around) by m (along the tube) quads, each two triangles when `triangles`; the quads
/// in `holes`, numbered row by row, are left out.
inline std::shared_ptr<const Mesh> torusGrid(Index n, Index m, bool triangles,
                                             const std::set<Index>& holes = {}) {
  std::vector<glm::dvec3> p;
  Polygons faces;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < m; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / m;
      const double r = 2 + std::cos(v);
      p.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const Index a = i * m + j, b = (i + 1) % n * m + j;
      const Index c = (i + 1) % n * m + (j + 1) % m, d = i * m + (j + 1) % m;
      if (holes.count(a) != 0) continue;
      if (triangles) {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
      } else {
        faces.push_back({a, b, c, d});
      }
    }
  }
  return meshOf(p, faces);
}

/// Open tube of n quads around and m along.
inline std::shared_ptr<const Mesh> tubeGrid(Index n, Index m) {
  std::vector<glm::dvec3> p;
  Polygons faces;
  for (Index j = 0; j <= m; ++j) {
    for (Index i = 0; i < n; ++i) {
      const double u = 2 * std::numbers::pi * i / n;
      p.emplace_back(std::cos(u), std::sin(u), 0.5 * j);
      if (j == m) continue;
      const Index a = j * n + i, b = j * n + (i + 1) % n;
      faces.push_back({a, b, b + n, a + n});
    }
  }
  return meshOf(p, faces);
}

inline Segmentation oneChart(const Mesh& mesh) {
  Segmentation segmentation;
  segmentation.chartCount = 1;
  segmentation.label.assign(mesh.faceCount(), 0);
  return segmentation;
}

/// Bands of the mesh along x: connected or not, with borders of every kind.
inline Segmentation bands(const Mesh& mesh, Index count) {
  Segmentation segmentation;
  segmentation.chartCount = count;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Index v = mesh.triangles()[mesh.triangleBegin(f)][0];
    const double share = mesh.positions()[v].x + 0.5;
    segmentation.label.push_back(
        std::min(count - 1, static_cast<Index>(std::max(0.0, share * count))));
  }
  return segmentation;
}

inline std::shared_ptr<const ChartSet> cutAll(const Mesh& mesh, const Segmentation& segmentation,
                                              const CutOptions& options = {}) {
  Progress progress;
  return cutCharts(mesh, segmentation, options, progress);
}

inline std::size_t countOf(const CutChart& chart, CutReason reason) {
  return static_cast<std::size_t>(std::count_if(chart.cuts.begin(), chart.cuts.end(),
                                                [&](const Cut& c) { return c.reason == reason; }));
}

/// Opens the chart again, cut by cut, and checks what each cut promises.
inline void checkCuts(const Mesh& mesh, ChartSurface surface, const CutChart& chart) {
  ASSERT_EQ(topologyOf(surface), chart.before);
  std::set<Index> edges;
  for (const Cut& cut : chart.cuts) {
    ASSERT_FALSE(cut.sides.empty());
    std::vector<Index> local;
    double length = 0;
    for (std::size_t i = 0; i < cut.sides.size(); ++i) {
      const Index side = cut.sides[i];
      if (i > 0) {
        EXPECT_EQ(mesh.sideEnd(cut.sides[i - 1]), mesh.sideStart(side));
      }
      EXPECT_TRUE(edges.insert(mesh.edgeOfSide(side)).second) << "an edge is cut twice";
      EXPECT_NE(mesh.faceOf(side / 3), mesh.faceOf(mesh.opposite()[side] / 3)) << "a diagonal";
      length += glm::length(mesh.positions()[mesh.sideEnd(side)] -
                            mesh.positions()[mesh.sideStart(side)]);
      const auto& all = surface.meshTriangle;
      const auto at = std::lower_bound(all.begin(), all.end(), side / 3);
      ASSERT_TRUE(at != all.end() && *at == side / 3) << "a cut in another chart";
      local.push_back(3 * static_cast<Index>(at - all.begin()) + side % 3);
    }
    EXPECT_NEAR(cut.length, length, 1e-12);
    const ChartTopology before = topologyOf(surface);
    openAlong(surface, local);
    const ChartTopology after = topologyOf(surface);
    EXPECT_EQ(after.pieces, 1u);
    EXPECT_EQ(before.genus() - after.genus(), cut.reason == CutReason::Handle ? 1 : 0);
    if (cut.reason == CutReason::Loop) {
      EXPECT_EQ(after.boundaryLoops + 1, before.boundaryLoops);
    }
    if (cut.reason == CutReason::Open) {
      EXPECT_GE(cut.sides.size(), 2u);
    }
    if (cut.reason == CutReason::Tip) {
      EXPECT_EQ(after, before);
    }
    if (cut.reason == CutReason::Handle) {
      EXPECT_GT(after.boundaryLoops + 1, before.boundaryLoops);
    }
  }
  EXPECT_EQ(topologyOf(surface), chart.topology);
  EXPECT_EQ(topologyOf(chart.surface), chart.topology);
  // Same gluing, though vertices may have other numbers.
  EXPECT_EQ(surface.opposite, chart.surface.opposite);
}

/// Checks every chart, and that each is a disk with the cuts that its topology needs.
inline void checkDisks(const Mesh& mesh, const Segmentation& segmentation, const ChartSet& set) {
  const auto surfaces = extractCharts(mesh, segmentation.label, segmentation.chartCount);
  ASSERT_EQ(set.charts.size(), surfaces.size());
  for (std::size_t c = 0; c < surfaces.size(); ++c) {
    SCOPED_TRACE("chart " + std::to_string(c));
    const CutChart& chart = set.charts[c];
    checkCuts(mesh, surfaces[c], chart);
    if (chart.before.pieces != 1) {
      EXPECT_NE(chart.problem, "");
      continue;
    }
    EXPECT_TRUE(chart.disk());
    EXPECT_EQ(chart.problem, "");
    const auto handles = countOf(chart, CutReason::Handle);
    EXPECT_EQ(static_cast<long>(handles), chart.before.genus());
    if (chart.before.boundaryLoops > 0 && handles == 0) {
      EXPECT_EQ(countOf(chart, CutReason::Loop), chart.before.boundaryLoops - 1);
    }
    EXPECT_EQ(countOf(chart, CutReason::Open),
              chart.before.boundaryLoops == 0 && handles == 0 ? 1u : 0u);
  }
}

}  // namespace chartflood::test
