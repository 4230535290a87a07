#pragma once
/// The dual graph of a mesh at one coarseness, with everything that a change of seams adds up:
/// lengths, Gauss area and Euler numbers. The sums are those of the mesh at every coarseness.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/face_values.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// How far a chart of that Euler number is from a disk, whose number is 1.
inline int diskDefect(int euler) { return euler < 1 ? 1 - euler : 0; }

/// What a mesh holds per face, side and vertex; made once.
struct SeamTables {
  std::vector<double> sideLength;   ///< of each side, normalised units, as seams count it
  std::vector<double> sideGauss;    ///< of each side's edge; empty when no edge has any
  std::vector<double> vertexGauss;  ///< of each vertex; empty when no vertex has any
  std::vector<double> faceValue;    ///< Gauss area plus eta times area
  FaceValues faceArea;              ///< squared normalised units
  std::vector<glm::dvec3> center;   ///< of each face
};

/// \param creaseWeight factor on the length of sharp edges that are creaseLines()
/// \param eta steradians that a squared normalised unit of surface counts as
/// \param sideFactor one more factor on the length of each side; empty: 1
SeamTables makeSeamTables(const Mesh& mesh, const GaussArea& gauss,
                          std::span<const double> faceGauss, double creaseWeight, double eta,
                          std::span<const double> sideFactor = {});

/// Clusters of faces as nodes. Chart sums are sums over nodes, over arcs with both ends in the
/// chart and over corners with all nodes in it.
struct SeamLevel {
  std::vector<Index> nodeOfFace;
  std::vector<Index> faceBegin;   ///< into faceOfNode, one entry more than nodes
  std::vector<Index> faceOfNode;  ///< faces of each node, ascending
  // Of each node:
  std::vector<double> value;        ///< faces, edges and vertices that lie wholly inside
  std::vector<double> area;         ///< of the surface
  std::vector<int> euler;           ///< triangles - inner edges + inner vertices
  std::vector<glm::dvec3> center;   ///< weighted by area
  std::vector<std::uint8_t> fixed;  ///< stays in its chart
  std::vector<Index> arcBegin;      ///< one entry more than nodes
  std::vector<Index> cornerBegin;   ///< into nodeCorner, one entry more than nodes
  std::vector<Index> nodeCorner;    ///< corners at each node
  // Of each arc, heads ascending at each node:
  std::vector<Index> arcHead;
  std::vector<Index> arcTwin;     ///< the arc back
  std::vector<double> arcLength;  ///< as seams count it
  std::vector<double> arcValue;   ///< edges and vertices that touch just the two nodes
  std::vector<int> arcEuler;
  // Of each corner, a vertex that touches three nodes or more:
  std::vector<Index> cornerNodeBegin;  ///< into cornerNode, one entry more than corners
  std::vector<Index> cornerNode;
  std::vector<double> cornerValue;

  std::size_t nodeCount() const { return value.size(); }
  std::size_t cornerCount() const { return cornerValue.size(); }
};

/// Builds the level of the given clusters, which must be connected.
SeamLevel buildSeamLevel(const Mesh& mesh, const SeamTables& tables, std::vector<Index> nodeOfFace,
                         std::size_t nodes);

}  // namespace chartflood
