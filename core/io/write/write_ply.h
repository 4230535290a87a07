#pragma once
/// Binary PLY: charts and texture coordinates per face, and per vertex for tools that look there.

#include <string>

#include "core/io/write/charted_mesh.h"

namespace chartflood {

enum class PlyVertices {
  /// The vertices of the input come first, same number and order. A vertex that is needed with
  /// several texture coordinates is repeated behind them, so that each vertex has one `s t`.
  SplitAtSeams,
  /// The vertices of the input and no others; texture coordinates only in the faces.
  AsInput,
};

struct PlyOptions {
  /// Blender's importer knows texture coordinates of vertices (`s t`) only, hence the default.
  PlyVertices vertices = PlyVertices::SplitAtSeams;
};

/// Little endian. Vertices have `x y z`, as float where that keeps every coordinate exact, else as
/// double, and `s t` (float, v upwards; 0 where no texture coordinate is known) where they are
/// split. Faces, all of the input in its order, polygons kept, have
///
/// - `list vertex_indices`,
/// - `int chart`: -1 for a face that reading dropped or that has no chart,
/// - `list float texcoord`: u v of each corner; empty where the chart is not laid flat.
///
/// Lists count in uchar, or in int when a polygon is too large for that.
/// Cost: linear, in parallel. \pre as chartPlaces()
std::string plyBytes(const ChartedMesh& charted, const PlyOptions& options = {});

}  // namespace chartflood
