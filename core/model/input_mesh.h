#pragma once
/// What a file holds, before anything is glued or repaired.

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"

namespace chartflood {

/// One line of the import report: what was found or repaired, and how often.
/// `what` is a stable id in kebab-case ("non-manifold-edges"), `text` the words for a person.
struct Repair {
  std::string what;
  std::size_t count = 0;
  std::string text;
};

/// Vertices and faces exactly as a file lists them: same number, same order. Kept for export, which
/// promises to give them back unchanged.
struct InputMesh {
  std::string file;                   ///< where it came from, for messages
  std::vector<glm::dvec3> positions;  ///< in the file's units
  std::vector<Index> corners;         ///< vertex of each face corner, face after face
  /// First corner of each face, one more entry than faces. Empty when every face is a triangle.
  std::vector<std::size_t> faceStart;
  std::vector<Repair> repairs;  ///< what the reader already had to say

  /// Gives back the room that was kept for more vertices and faces.
  void shrink() {
    positions.shrink_to_fit();
    corners.shrink_to_fit();
    faceStart.shrink_to_fit();
  }
  std::size_t faceCount() const {
    return faceStart.empty() ? corners.size() / 3 : faceStart.size() - 1;
  }
  /// Vertices of face f in the order of the file.
  std::span<const Index> face(std::size_t f) const {
    if (faceStart.empty()) return {corners.data() + 3 * f, 3};
    return {corners.data() + faceStart[f], faceStart[f + 1] - faceStart[f]};
  }
};

}  // namespace chartflood
