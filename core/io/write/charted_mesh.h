#pragma once
/// What the writers of meshes are given: a mesh cut into charts, with the charts' places in the
/// texture.

#include <span>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/model/atlas.h"
#include "core/model/chart_set.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Refers to values that the caller keeps; made where a file is written.
struct ChartedMesh {
  const Mesh& mesh;
  std::span<const Index> label;  ///< chart of each face of the mesh, kNone while free
  const ChartSet& charts;        ///< one entry a chart
  const Atlas& atlas;            ///< without any uv: the files then have no texture coordinates

  std::size_t chartCount() const { return charts.charts.size(); }
  const ChartSurface& surface(std::size_t chart) const { return charts.charts[chart].surface; }
  /// Texture places of the vertices of a chart's surface; empty where the chart is not laid flat.
  std::span<const glm::dvec2> uv(std::size_t chart) const {
    if (atlas.uv.empty()) return {};
    return atlas.uv[chart];
  }
};

/// "chart_000", "chart_001", ..: the name of a chart in every file.
std::string chartName(Index chart);

/// Names every corner of the input's faces by a *place*: a vertex of a chart's surface, counted
/// chart after chart. Two corners have the same place where the chart is whole between them, so
/// places differ across seams and cuts.
struct ChartPlaces {
  std::vector<Index> begin;   ///< first place of each chart; one more entry than charts
  std::vector<Index> chart;   ///< of each face of the input; kNone where it has none
  std::vector<Index> corner;  ///< place of each corner of the input, kNone in faces without chart
  std::vector<bool> dropped;  ///< of each face of the input: reading dropped it; empty: none
};

/// A corner of a polygon that belongs to no triangle (buildMesh() drops triangles that repeat a
/// vertex) takes the place of an equal vertex of its face, or else that of the corner before it.
/// Cost: linear. \pre sizes of label, charts and uv agree
ChartPlaces chartPlaces(const ChartedMesh& charted);

}  // namespace chartflood
