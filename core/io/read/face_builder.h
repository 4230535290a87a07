#pragma once
/// Appends faces to an InputMesh; keeps the compact form while all of them are triangles.

#include <cstddef>

#include "core/model/input_mesh.h"

namespace chartflood {

/// For a mesh without faces at first. Call addCorner() for each corner, then endFace().
class FaceBuilder {
 public:
  explicit FaceBuilder(InputMesh& mesh) : mesh_(mesh) {}

  void addCorner(Index vertex) { mesh_.corners.push_back(vertex); }
  void endFace() {
    const std::size_t end = mesh_.corners.size();
    if (mesh_.faceStart.empty()) {
      if (end - begin_ == 3) {
        begin_ = end;
        return;
      }
      for (std::size_t start = 0; start <= begin_; start += 3) mesh_.faceStart.push_back(start);
    }
    mesh_.faceStart.push_back(end);
    begin_ = end;
  }
  void addTriangle(Index a, Index b, Index c) {
    mesh_.corners.insert(mesh_.corners.end(), {a, b, c});
    endFace();
  }
  /// Takes note of triangles that were written to the corners directly, before any other face.
  void adoptTriangles() { begin_ = mesh_.corners.size(); }

 private:
  InputMesh& mesh_;
  std::size_t begin_ = 0;  ///< first corner of the face that has begun
};

}  // namespace chartflood
