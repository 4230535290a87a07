#pragma once
/// Joining the borders of a surface where the file repeats vertices, a step of buildMesh().

#include <span>

#include <glm/vec3.hpp>

#include "core/model/glue_edges.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Glues sides without an opposite one that run between the same two places but between different
/// vertices. Engines and converters repeat vertices at creases and along the seams of textures.
///
/// A joint must leave the surface as well as the file had it, which is decided edge by edge:
/// - Two sides are glued only where they alone run between their places. Where more do, two boxes
///   that touch or a wall on a floor, those that share vertices stay glued as they are.
/// - They are not glued when their vertices at one end also bound one of those crowded edges: two
///   sheets, one on the other, stay two sheets.
/// - The two sides of a thin card, triangles or polygons over the same places, stay apart.
///
/// \param distance how far vertices at one place may lie apart, in the units of `positions`; 0:
///   equal bit by bit
/// \param found gets as conflicts the sides that belong together but run the same way, and as
///   non-manifold those of crowded edges without any two that are glued
/// Cost: linear in the number of border sides; in all sides, with hashing, where some can be glued.
/// \returns whether any were glued or are in conflict
bool weldBorders(MeshData& d, std::span<const glm::dvec3> positions, double distance,
                 GlueFindings& found);

}  // namespace chartflood
