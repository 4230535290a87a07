#pragma once
/// What a flood begins from: with the mesh and the parameters it is enough to make the same charts
/// again, because floods are deterministic.

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/segmentation.h"

namespace chartflood {

struct FloodStart {
  std::vector<Index> seeds;         ///< faces, one a chart; empty: there are no charts
  std::vector<double> offsets;      ///< one a seed or none; steradians
  std::vector<glm::dvec3> normals;  ///< of methods that grow by normals, one a seed or none
  /// The charts are from creases, made with this generator seed; see makeCreaseStart().
  std::optional<std::uint32_t> creases;
  std::optional<FastFlood> fast;  ///< the charts are from the fast search

  bool operator==(const FloodStart&) const = default;
};

}  // namespace chartflood
