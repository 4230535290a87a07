#pragma once
/// The immutable mesh that every stage works on: oriented triangles glued into a manifold
/// (possibly with borders), on flat arrays.
///
/// Words: a *face* is a polygon of the input file and the unit that charts are made of; it owns one
/// or more *triangles*, which are numbered face after face. *Side* 3 t + i of triangle t runs from
/// its corner i to its corner i + 1 (counter-clockwise seen from outside). An *edge* is one border
/// side or two opposite sides; it is named by its smaller side.

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// The arrays of a Mesh; see the accessors for shapes and units.
struct MeshData {
  std::shared_ptr<const InputMesh> input;
  std::vector<glm::dvec3> positions;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> opposite;
  std::vector<Index> vertexSide;
  std::vector<Index> faceOfTriangle;  ///< empty when faces are triangles
  std::vector<Index> triangleBegin;   ///< empty when faces are triangles
  std::vector<Index> inputFace;       ///< empty when no face was dropped
  std::vector<Index> inputVertex;     ///< empty when no vertex was split
  std::vector<Index> inputCorner;     ///< empty when triangles are the input's faces as they stand
  std::vector<Index> standIn;         ///< empty when no vertices were joined
  std::vector<bool> turned;           ///< empty when no face was turned over
  std::vector<Index> slits;           ///< ascending
  std::vector<double> triangleArea;
  std::vector<bool> degenerate;
  std::vector<Index> faceComponent;
  std::size_t faceCount = 0;
  std::size_t edgeCount = 0;
  std::size_t componentCount = 0;
  std::size_t boundaryLoopCount = 0;
  double surfaceArea = 0;
  glm::dvec3 center{0};
  double scale = 1;
  std::vector<Repair> repairs;
};

/// Whether two sides belong to one face that has several triangles.
inline bool isWithinFace(const MeshData& d, Index side, Index other) {
  return !d.faceOfTriangle.empty() && d.faceOfTriangle[side / 3] == d.faceOfTriangle[other / 3];
}

/// Immutable and safe to share between threads.
class Mesh {
 public:
  explicit Mesh(MeshData&& data) : d_(std::move(data)) {}

  const InputMesh& input() const { return *d_.input; }
  std::shared_ptr<const InputMesh> sharedInput() const { return d_.input; }

  std::size_t vertexCount() const { return d_.positions.size(); }
  std::size_t triangleCount() const { return d_.triangles.size(); }
  std::size_t faceCount() const { return d_.faceCount; }
  std::size_t edgeCount() const { return d_.edgeCount; }
  std::size_t componentCount() const { return d_.componentCount; }
  std::size_t boundaryLoopCount() const { return d_.boundaryLoopCount; }
  bool closed() const { return d_.boundaryLoopCount == 0; }
  /// True when each face is one triangle, so that triangle and face numbers are equal.
  bool facesAreTriangles() const { return d_.faceOfTriangle.empty(); }

  /// Vertex positions in normalised units: moved to the bounding box centre and divided by the
  /// bounding box diagonal. Original position = center() + scale() * position.
  std::span<const glm::dvec3> positions() const { return d_.positions; }
  const glm::dvec3& center() const { return d_.center; }
  /// Model units per normalised unit; lengths scale with it, areas with its square.
  double scale() const { return d_.scale; }

  /// Vertices of each triangle, counter-clockwise.
  std::span<const std::array<Index, 3>> triangles() const { return d_.triangles; }
  /// For each side the side across the edge, kNone on a border; 3 entries a triangle.
  std::span<const Index> opposite() const { return d_.opposite; }
  /// One side that starts at the vertex (the first one counter-clockwise at a border vertex, so
  /// that turning from it visits the whole fan); kNone for a vertex without triangles.
  std::span<const Index> vertexSide() const { return d_.vertexSide; }

  Index sideStart(Index side) const { return d_.triangles[side / 3][side % 3]; }
  Index sideEnd(Index side) const {
    return d_.triangles[side / 3][(side + 1) % 3 == 0 ? 0 : side % 3 + 1];
  }
  static Index nextSide(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index previousSide(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }
  /// The next side that starts at the same vertex, counter-clockwise; kNone past a border.
  Index turn(Index side) const { return d_.opposite[previousSide(side)]; }
  /// The edge's name: its smaller side.
  Index edgeOfSide(Index side) const {
    const Index other = d_.opposite[side];
    return other < side ? other : side;
  }

  Index faceOf(Index triangle) const {
    return d_.faceOfTriangle.empty() ? triangle : d_.faceOfTriangle[triangle];
  }
  /// Triangles of face f are [triangleBegin(f), triangleBegin(f + 1)).
  Index triangleBegin(Index face) const {
    return d_.triangleBegin.empty() ? face : d_.triangleBegin[face];
  }
  /// Number of the face in the input file.
  Index inputFace(Index face) const { return d_.inputFace.empty() ? face : d_.inputFace[face]; }
  /// The input vertex that a vertex stands for.
  Index inputVertex(Index vertex) const {
    return d_.inputVertex.empty() ? vertex : d_.inputVertex[vertex];
  }

  /// The corner of the input's faces (place in InputMesh::corners) that the start of a side is.
  Index inputCorner(Index side) const {
    return d_.inputCorner.empty() ? side : d_.inputCorner[side];
  }
  /// True when every triangle is a face of the input as it stands, so that sides are its corners.
  bool cornersAsInput() const { return d_.inputCorner.empty(); }
  /// The input vertex that a vertex of the input was joined with, itself when with none.
  Index standIn(Index inputVertex) const {
    return d_.standIn.empty() ? inputVertex : d_.standIn[inputVertex];
  }
  /// True for a face that runs the other way round than in the file.
  bool turned(Index face) const { return !d_.turned.empty() && d_.turned[face]; }
  /// True for a side within a face along which the face cannot be cut: a diagonal, as against the
  /// slit by which an outline reaches a hole.
  bool isDiagonal(Index side) const {
    const Index other = d_.opposite[side];
    if (facesAreTriangles() || other == kNone || faceOf(side / 3) != faceOf(other / 3)) {
      return false;
    }
    return !std::binary_search(d_.slits.begin(), d_.slits.end(), side);
  }

  /// Area of each triangle in squared normalised units.
  std::span<const double> triangleArea() const { return d_.triangleArea; }
  double surfaceArea() const { return d_.surfaceArea; }
  /// True for a triangle without a usable normal: twice its area is at most 1e-10 times its longest
  /// squared edge.
  bool degenerate(Index triangle) const { return d_.degenerate[triangle]; }
  /// Connected component of each face.
  std::span<const Index> faceComponent() const { return d_.faceComponent; }

  /// All that reading and gluing found or repaired.
  std::span<const Repair> repairs() const { return d_.repairs; }

  /// Sum of the genera of all components (gluing keeps only orientable pieces).
  long genus() const;
  /// V - E + F over the vertices that triangles use.
  long eulerNumber() const;

 private:
  MeshData d_;
};

}  // namespace chartflood
