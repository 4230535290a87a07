#pragma once
/// Vertex normals, one per smooth region around a vertex (paper section 3.2: "the surrounding area
/// of each vertex is split by the sharp edges into smooth regions").

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/corner_normals.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Unit normals. A vertex that no crease splits has one, `vertex[v]`; at the others every side that
/// starts there names its sector.
struct SectorNormals {
  /// The sectors of a vertex that creases split, counter-clockwise.
  struct Split {
    Index vertex;
    Index firstSector;
    Index sectorCount;
    bool interior;  ///< false at a mesh border
  };
  std::vector<glm::dvec3> vertex;
  std::vector<glm::dvec3> sector;
  std::vector<Index> sideSector;  ///< one per side, kNone where `vertex` holds; empty: nowhere
  std::vector<Split> splits;      ///< ascending by vertex

  /// Normal at the corner where `side` starts.
  const glm::dvec3& at(const Mesh& mesh, Index side) const {
    if (!sideSector.empty() && sideSector[side] != kNone) return sector[sideSector[side]];
    return vertex[mesh.sideStart(side)];
  }
};

/// Computes all sector normals: the normalised sum over the corners of a sector of
/// (e1 x e2) / (|e1|^2 |e2|^2) (Max, "Weights for computing vertex normals from facet normals",
/// 1999; the paper's [21]). Degenerate triangles are skipped; a vanishing sum falls back to the sum
/// of unit triangle normals, then to one triangle's normal, whatever their order, then to (0, 0,
/// 1). An interior vertex with s sharp edges has max(1, s) sectors, a border vertex s + 1.
SectorNormals computeSectorNormals(const Mesh& mesh, std::span<const std::uint8_t> sharpSides);

/// The same normals laid out for drawing.
CornerNormals computeCornerNormals(const Mesh& mesh, double sharpAngle);

}  // namespace chartflood
