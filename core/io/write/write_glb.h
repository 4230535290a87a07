#pragma once
/// glTF 2.0 in one binary file, for engines and viewers.

#include <string>
#include <string_view>

#include "core/io/write/charted_mesh.h"

namespace chartflood {

struct GlbOptions {
  /// Edges within a chart that are folded more are shaded as creases along the chart's border;
  /// degrees.
  double sharpAngle = 45;
  /// PNG file that the charts are covered with; empty: plain grey.
  std::string_view texturePng;
};

/// One primitive of triangles whose vertices are those of the charts' surfaces: split at seams and
/// cuts, nowhere else. Charts follow each other by number; faces that reading dropped are left out.
/// Attributes, all float: POSITION (units and axes of the input), NORMAL, TEXCOORD_0 (v downwards,
/// as glTF has it; (0, 1) in charts that are not laid flat; absent without any) and `_CHART`, the
/// number of the chart (-1 where there is none).
///
/// Normals are smooth over a seam unless it runs along a crease.
/// Cost: linear, charts in parallel.
/// \throws Error when a coordinate is too large for single precision, or the file would exceed
///   4 GB. \pre as chartPlaces()
std::string glbBytes(const ChartedMesh& charted, const GlbOptions& options = {});

}  // namespace chartflood
