#pragma once
/// Finds the first triangle that a ray meets, without looking at the others.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// A hierarchy of boxes over the triangles in the order of a space-filling curve: every box of a
/// level holds two neighbours of the level below, so that none needs to name its children. Takes
/// about 16 bytes a triangle. Immutable and safe to share between threads.
class TriangleTree {
 public:
  explicit TriangleTree(std::shared_ptr<const Mesh> mesh);
  const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }

  struct Hit {
    Index triangle = kNone;
    glm::dvec3 point{0};  ///< on the triangle, normalised units
  };
  /// The triangle nearest to `from` on the way to `to`, seen from either side; of equally near
  /// ones the one of the smallest number. Watertight: no ray slips through between neighbours.
  /// \param counts which triangles can be met; empty: all
  std::optional<Hit> first(const glm::dvec3& from, const glm::dvec3& to,
                           const std::function<bool(Index)>& counts = {}) const;

 private:
  struct Box {
    std::array<float, 3> low, high;
  };

  void buildLeaves();

  std::shared_ptr<const Mesh> mesh_;
  std::vector<Index> order_;              // triangles along the curve
  std::vector<std::vector<Box>> levels_;  // [0] of kLeaf triangles each; the last one has one box
};

}  // namespace chartflood
