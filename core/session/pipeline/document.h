#pragma once
/// What the user decides: parameters, and seeds placed by hand. Plain values that undo keeps and
/// session files hold.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/model/edge_hints.h"
#include "core/model/flood_start.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"
#include "core/session/settings/parameters.h"

namespace chartflood {

/// A chart's first face as the user put it. An unlocked one is where the rounds start from; a
/// locked one stays there and outlives a smaller number of charts.
struct PlacedSeed {
  Index face = kNone;
  bool locked = false;

  bool operator==(const PlacedSeed&) const = default;
};

/// What undo brings back: values only, cheap to copy.
struct Document {
  Parameters parameters;
  std::vector<PlacedSeed> seeds;  ///< in the order of the charts; empty: placed by the method
  EdgeHints hints;                ///< edges painted by hand

  bool operator==(const Document&) const = default;
};

/// Where the charts of a moment came from. With the document of that moment it is enough to make
/// the same labels again by one flood, because floods are deterministic.
struct FloodMoment {
  FloodStart start;       ///< of the present flood
  std::size_t taken = 0;  ///< faces that the flood has taken
  bool finished = false;  ///< a stop rule has fired and the borders were finished

  bool operator==(const FloodMoment&) const = default;
};

/// The faces of the seeds, in their order.
std::vector<Index> seedFaces(std::span<const PlacedSeed> seeds);

/// The faces of the locked seeds, in their order.
std::vector<Index> lockedFaces(std::span<const PlacedSeed> seeds);

/// Drops the newest (last) unlocked seeds until at most `wanted` are left, or only locked ones.
void dropNewestUnlocked(std::vector<PlacedSeed>& seeds, std::size_t wanted);

/// The document with seeds that its parameters allow, after a change from `before`: a smaller
/// number of charts drops the newest unlocked seeds; another generator seed drops all unlocked
/// ones, which are then placed anew.
Document withFittingSeeds(const Document& before, Document document);

/// The face of the mesh for a face of its input file; kNone when there is none or it was dropped.
/// Cost: logarithmic.
Index meshFace(const Mesh& mesh, Index inputFace);

}  // namespace chartflood
