#include "render/scene/uv_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>

#include "render/scene/uv_places.h"

namespace chartflood {

namespace {

/// Sets of triangles that grow together; the smallest number stands for each.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

bool finite(const glm::vec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// Corner at which a side ends.
Index endCorner(Index side) { return Mesh::nextSide(side); }

/// The edge has the same two places in the texture from both its sides.
bool glued(const UvLayout& layout, Index side, Index other) {
  const auto place = [&](Index corner) { return glm::vec2(layout.corners[corner]); };
  return place(side) == place(endCorner(other)) && place(endCorner(side)) == place(other);
}

void takeCorners(std::span<const glm::vec2> uv, UvLayout& layout) {
  layout.corners.resize(uv.size(), glm::vec3(UvLayout::kNoPlace, UvLayout::kNoPlace, 0));
  layout.island.assign(uv.size() / 3, kNone);
  bool any = false;
  for (std::size_t t = 0; t < layout.island.size(); ++t) {
    if (!finite(uv[3 * t]) || !finite(uv[3 * t + 1]) || !finite(uv[3 * t + 2])) continue;
    layout.island[t] = 0;
    for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
      layout.corners[c] = glm::vec3(uv[c], 0);
      layout.low = any ? glm::min(layout.low, uv[c]) : uv[c];
      layout.high = any ? glm::max(layout.high, uv[c]) : uv[c];
      any = true;
    }
  }
}

void findIslands(const Mesh& mesh, UvLayout& layout) {
  Sets sets(mesh.triangleCount());
  for (Index side = 0; side < mesh.opposite().size(); ++side) {
    const Index other = mesh.opposite()[side];
    if (other == kNone || other < side || layout.island[side / 3] == kNone) continue;
    if (glued(layout, side, other)) sets.join(side / 3, other / 3);
  }
  for (Index t = 0; t < layout.island.size(); ++t) {
    if (layout.island[t] == kNone) continue;
    const Index root = sets.find(t);
    if (root == t) {
      layout.island[t] = static_cast<Index>(layout.firstTriangle.size());
      layout.firstTriangle.push_back(t);
    } else {
      layout.island[t] = layout.island[root];
    }
  }
}

void measureIslands(const Mesh& mesh, UvLayout& layout) {
  std::vector<double> surface(layout.firstTriangle.size(), 0.0), flat = surface;
  for (std::size_t t = 0; t < layout.island.size(); ++t) {
    if (layout.island[t] == kNone) continue;
    const glm::dvec3 a(layout.corners[3 * t]), b(layout.corners[3 * t + 1]),
        c(layout.corners[3 * t + 2]);
    surface[layout.island[t]] += mesh.triangleArea()[t];
    flat[layout.island[t]] += 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
  for (std::size_t c = 0; c < layout.corners.size(); ++c) {
    const Index island = layout.island[c / 3];
    if (island == kNone || !(flat[island] > 0)) continue;
    layout.corners[c].z = static_cast<float>(std::sqrt(surface[island] / flat[island]));
  }
}

void collectOutlines(const Mesh& mesh, UvLayout& layout) {
  std::vector<SegmentRange>& ranges = layout.outlineOf;
  ranges.assign(layout.firstTriangle.size(), {});
  std::vector<Index> border;
  for (Index side = 0; side < mesh.opposite().size(); ++side) {
    if (layout.island[side / 3] == kNone) continue;
    const Index other = mesh.opposite()[side];
    if (other != kNone && glued(layout, side, other)) continue;
    border.push_back(side);
    ++ranges[layout.island[side / 3]].count;
  }
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    ranges[i].first = ranges[i - 1].first + ranges[i - 1].count;
  }
  layout.outline.resize(border.size());
  std::vector<std::size_t> next(ranges.size());
  std::transform(ranges.begin(), ranges.end(), next.begin(),
                 [](const SegmentRange& range) { return range.first; });
  for (const Index side : border) layout.outline[next[layout.island[side / 3]]++] = side;
}

/// The two ends of a side, with the lengths along a cut that it stands for.
void addSegment(const UvLayout& layout, Index side, float from, float to,
                std::vector<glm::vec4>& out) {
  const glm::vec3 &a = layout.corners[side], &b = layout.corners[endCorner(side)];
  const float unit = a.z > 0 ? 1 / a.z : 0.0f;
  out.emplace_back(a.x, a.y, 0.0f, from * unit);
  out.emplace_back(b.x, b.y, 0.0f, to * unit);
}

}  // namespace

UvLayout uvLayout(const Mesh& mesh, std::span<const glm::vec2> uv) {
  UvLayout layout;
  takeCorners(uv, layout);
  findIslands(mesh, layout);
  measureIslands(mesh, layout);
  collectOutlines(mesh, layout);
  layout.places = islandPlaces(layout);
  return layout;
}

std::vector<glm::vec4> uvSegments(const Mesh& mesh, const UvLayout& layout,
                                  std::span<const CutEdge> edges) {
  std::vector<glm::vec4> segments;
  for (const CutEdge& edge : edges) {
    const Index other = mesh.opposite()[edge.side];
    if (layout.island[edge.side / 3] != kNone) {
      addSegment(layout, edge.side, edge.from, edge.to, segments);
    }
    if (other != kNone && layout.island[other / 3] != kNone) {
      addSegment(layout, other, edge.to, edge.from, segments);
    }
  }
  return segments;
}

UvLines uvLines(const Mesh& mesh, const UvLayout& layout, std::span<const CutEdge> cuts) {
  UvLines lines;
  std::vector<bool> isCut(mesh.opposite().size(), false);
  for (const CutEdge& cut : cuts) {
    const Index other = mesh.opposite()[cut.side];
    isCut[cut.side] = true;
    if (layout.island[cut.side / 3] != kNone) {
      addSegment(layout, cut.side, cut.from, cut.to, lines.cuts);
      lines.cutTriangle.push_back(cut.side / 3);
    }
    if (other == kNone) continue;
    isCut[other] = true;
    if (layout.island[other / 3] != kNone) {
      addSegment(layout, other, cut.to, cut.from, lines.cuts);
      lines.cutTriangle.push_back(other / 3);
    }
  }
  for (const SegmentRange& range : layout.outlineOf) {
    const std::size_t first = lines.outline.size() / 2;
    for (std::size_t i = range.first; i < range.first + range.count; ++i) {
      if (!isCut[layout.outline[i]]) addSegment(layout, layout.outline[i], 0, 0, lines.outline);
    }
    lines.outlineOf.push_back({first, lines.outline.size() / 2 - first});
  }
  return lines;
}

}  // namespace chartflood
