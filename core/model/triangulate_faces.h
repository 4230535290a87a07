#pragma once
/// The first step of buildMesh(): triangles from the faces of a file.

#include <cstddef>

#include "core/model/input_mesh.h"
#include "core/model/mesh.h"

namespace chartflood {

struct TriangulationFindings {
  std::size_t droppedTriangles = 0;
  std::size_t emptyFaces = 0;
};

/// Fills triangles, faces and inputCorner of `d`, and `opposite`, where the diagonals of polygons
/// are glued already, whatever else uses the same pairs of vertices; other entries are kNone.
/// \param joinPlaces an edge of no length that only one face has is left out of that face: it runs
///   between two vertices at one place, which will be one
/// \throws ReadError when no triangle is left
TriangulationFindings triangulateFaces(const InputMesh& input, bool joinPlaces, MeshData& d);

}  // namespace chartflood
