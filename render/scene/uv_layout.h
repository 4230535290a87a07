#pragma once
/// The texture plane as it is drawn, worked out on any thread: islands of triangles, how large the
/// surface is against the texture, and the outlines. No GL.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/base/index.h"
#include "core/model/mesh.h"
#include "render/scene/cut_path.h"
#include "render/scene/label_places.h"

namespace chartflood {

/// Lines of one island in a list of segments.
struct SegmentRange {
  std::size_t first = 0, count = 0;
};

/// An island is a set of triangles that meet in the texture along whole edges: an unwrapped chart.
struct UvLayout {
  /// (u, v, scale) of each corner, three a triangle. `scale` is the square root of the island's
  /// surface over its area in the texture: normalised units per texture unit, 0 for an island
  /// without area. Triangles without a texture place have kNoPlace for u and v.
  std::vector<glm::vec3> corners;
  std::vector<Index> island;  ///< of each triangle, kNone without a place; by smallest triangle
  std::vector<Index> firstTriangle;     ///< of each island
  std::vector<Index> outline;           ///< sides on the border of an island, island after island
  std::vector<SegmentRange> outlineOf;  ///< of each island, in `outline`
  glm::vec2 low{0}, high{1};            ///< box of all places; 0..1 without any
  std::vector<ChartLabel> places;       ///< for numbers, as islandPlaces() gives them

  static constexpr float kNoPlace = -1e30f;
  bool empty() const { return firstTriangle.empty(); }
};

/// From the texture place of each corner (three a triangle, not finite: none).
/// \pre uv.size() == 3 * mesh.triangleCount()
UvLayout uvLayout(const Mesh& mesh, std::span<const glm::vec2> uv);

/// Two entries a segment, (u, v, 0, value) of its ends. `value` is the length along the cut in
/// texture units; for outlines 0.
struct UvLines {
  std::vector<glm::vec4> outline;       ///< borders of islands but no cuts, island after island
  std::vector<SegmentRange> outlineOf;  ///< of each island
  std::vector<glm::vec4> cuts;          ///< both banks of each cut
  std::vector<Index> cutTriangle;       ///< that each segment of `cuts` borders
};
/// Both banks of each edge where they have a place, as `cuts` of UvLines.
std::vector<glm::vec4> uvSegments(const Mesh& mesh, const UvLayout& layout,
                                  std::span<const CutEdge> edges);
UvLines uvLines(const Mesh& mesh, const UvLayout& layout, std::span<const CutEdge> cuts);

}  // namespace chartflood
