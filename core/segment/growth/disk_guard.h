#pragma once
/// Says whether a chart that is a disk is still one with one more face.

#include <vector>

#include "core/model/mesh.h"
#include "core/segment/growth/growth_graph.h"

namespace chartflood {

/// Sander et al. 2003, section 3.1: a face is no candidate for a chart where the chart would get a
/// hole or a handle. Looks at the face and the fans of its corners only.
class DiskGuard {
 public:
  explicit DiskGuard(const Mesh& mesh) : mesh_(mesh) {}

  /// True when the sides and corners that the face shares with the chart form one arc of its
  /// outline: not the whole outline, not two pieces. Labels are those of `faces`.
  bool staysDisk(Index face, Index chart, const std::vector<GrowthFace>& faces) const;

 private:
  const Mesh& mesh_;
};

}  // namespace chartflood
