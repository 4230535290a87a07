#pragma once
/// Wavefront OBJ: the input as it was, with texture coordinates.

#include <cstdint>
#include <span>
#include <string>

#include "core/io/write/charted_mesh.h"

namespace chartflood {

struct ObjOptions {
  /// Name of an MTL file with one material a chart (materialText()); empty: no materials.
  std::string materialFile;
};

/// The vertices of the input, same number and order, each the shortest decimal that reads as the
/// same double; its faces in its order, polygons kept.
///
/// - `f v/vt`: each chart has texture coordinates (`vt`, in [0, 1], v upwards) of its own, one for
///   each vertex of its surface. Seams and cuts are where `vt` differ and `v` do not.
/// - `g chart_000` stands where the chart changes; faces that reading dropped stand in their place
///   under `g dropped`, faces without chart under `g free`.
/// - Faces of charts that are not laid flat, and those without chart, have no `vt`.
///
/// Cost: linear, in parallel. \pre as chartPlaces()
std::string objText(const ChartedMesh& charted, const ObjOptions& options = {});

/// The MTL file beside it: one material a chart, with its colour as 0xRRGGBB.
std::string materialText(std::span<const std::uint32_t> colorOfChart);

}  // namespace chartflood
