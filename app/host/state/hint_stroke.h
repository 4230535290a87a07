#pragma once
/// The brush on edges: the line that is being painted, and the edges that it and the hints cover.

#include <span>
#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/model/edge_hints.h"
#include "core/model/mesh.h"

namespace chartflood {

/// What the brush does to edges.
enum class HintBrush { Cut, Never, Erase };
std::string hintBrushId(HintBrush brush);       ///< "cut"
HintBrush hintBrushFromId(const std::string&);  ///< \pre one of "cut", "never", "erase"

/// A line that is being painted: vertices of the mesh from edge to edge.
struct HintStroke {
  std::vector<Index> vertices;
};

/// Leads a stroke on to a vertex, along the shortest path of edges where that is near; begins it
/// there where it is empty or the vertex is far.
void leadStroke(const Mesh& mesh, HintStroke& stroke, Index vertex);

/// The vertex of a triangle that is nearest to a point, normalised units.
Index nearestCorner(const Mesh& mesh, Index triangle, const glm::dvec3& point);

/// Sides of the mesh along a chain of vertices; pairs without an edge are left out.
std::vector<Index> sidesAlong(const Mesh& mesh, std::span<const Index> vertices);

/// One side of each edge that has a hint of this kind.
std::vector<Index> hintSides(const Mesh& mesh, const EdgeHints& hints, HintKind kind);

}  // namespace chartflood
