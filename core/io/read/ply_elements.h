#pragma once
/// Where the rows of a PLY file go: shared by the text and the binary reader.

#include <array>
#include <cstdint>
#include <vector>

#include "core/io/read/face_builder.h"
#include "core/io/read/ply_header.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Columns of x, y and z.
using PlyAxes = std::array<std::size_t, 3>;

/// \throws ReadError when an axis is missing or a list.
PlyAxes plyAxes(const Source& source, const PlyElement& vertices);

/// Column of the list of vertex numbers. \throws ReadError when there is none of whole numbers.
std::size_t plyIndexColumn(const Source& source, const PlyElement& faces);

inline bool plyIsStrips(const PlyElement& element) { return element.name == "tristrips"; }
inline bool plyHoldsFaces(const PlyElement& element) {
  return element.name == "face" || plyIsStrips(element);
}

/// Takes vertex numbers row by row and makes faces of them: a polygon from each row, or the
/// triangles of a strip.
class PlyFaces {
 public:
  PlyFaces(InputMesh& mesh, std::size_t vertexCount) : faces_(mesh), vertexCount_(vertexCount) {}

  void beginElement(const PlyElement& element) { strips_ = plyIsStrips(element); }
  /// \returns false when there is no such vertex.
  bool add(std::int64_t vertex) {
    if (strips_) return addToStrip(vertex);
    if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertexCount_)) return false;
    faces_.addCorner(static_cast<Index>(vertex));
    return true;
  }
  void endRow() {
    stripLength_ = 0;
    if (!strips_) faces_.endFace();
  }
  FaceBuilder& builder() { return faces_; }
  std::size_t vertexCount() const { return vertexCount_; }

 private:
  bool addToStrip(std::int64_t vertex);

  FaceBuilder faces_;
  std::size_t vertexCount_;
  bool strips_ = false;
  std::size_t stripLength_ = 0;
  Index last_ = 0, beforeLast_ = 0;  ///< of the present strip
};

/// Reads the rows behind the header. \returns false when cancelled. \throws ReadError
bool readPlyText(const Source& source, const PlyHeader& header, InputMesh& mesh, PlyFaces& faces);
bool readPlyBinary(const Source& source, const PlyHeader& header, InputMesh& mesh, PlyFaces& faces);

}  // namespace chartflood
