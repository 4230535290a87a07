#include "core/model/weld_borders.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/base/parallel.h"
#include "core/model/position_table.h"

namespace chartflood {

namespace {

constexpr std::size_t kPlaceBlock = 1 << 14;

/// A side by the places and the vertices it runs between, each pair in the order of places.
struct PlacedSide {
  Index placeA, placeB;
  Index vertexA, vertexB;
  Index side;

  bool operator<(const PlacedSide& o) const {
    return std::tie(placeA, placeB, vertexA, vertexB, side) <
           std::tie(o.placeA, o.placeB, o.vertexA, o.vertexB, o.side);
  }
  bool sameEdge(const PlacedSide& o) const { return placeA == o.placeA && placeB == o.placeB; }
  bool sameVertices(const PlacedSide& o) const {
    return vertexA == o.vertexA && vertexB == o.vertexB;
  }
};

/// Sides listed by their smaller place, each list sorted.
std::vector<PlacedSide> listedByPlace(const std::vector<PlacedSide>& sides, std::size_t places) {
  std::vector<Index> start(places + 1, 0);
  for (const PlacedSide& s : sides) ++start[s.placeA + 1];
  for (std::size_t p = 0; p < places; ++p) start[p + 1] += start[p];
  std::vector<Index> next(start.begin(), start.end() - 1);
  std::vector<PlacedSide> out(sides.size());
  for (const PlacedSide& s : sides) out[next[s.placeA]++] = s;
  parallelBlocks(places, kPlaceBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      std::sort(out.begin() + start[p], out.begin() + start[p + 1]);
    }
  });
  return out;
}

class BorderWelder {
 public:
  BorderWelder(MeshData& d, std::span<const glm::dvec3> positions, double distance)
      : d_(d), positions_(positions), distance_(distance) {}

  bool run(GlueFindings& found);

 private:
  Index start(Index side) const { return d_.triangles[side / 3][side % 3]; }
  Index end(Index side) const { return d_.triangles[side / 3][(side + 1) % 3]; }
  Index faceOf(Index side) const {
    return d_.faceOfTriangle.empty() ? side / 3 : d_.faceOfTriangle[side / 3];
  }
  void placeVertices(const std::vector<bool>& which);
  std::vector<PlacedSide> sidesAt(const std::vector<bool>& places, bool bordersOnly) const;
  std::vector<bool> placesOfPairs();
  void noteCrowded(std::span<const PlacedSide> edge);
  bool meetElsewhere(Index u, Index v) const;
  bool sameOutline(Index side, Index other) const;
  bool mayGlue(const PlacedSide& x, const PlacedSide& y) const;
  bool glue(const PlacedSide& x, const PlacedSide& y, GlueFindings& found);
  template <class Visit>
  static void forEachEdge(std::span<const PlacedSide> sides, const Visit& visit);

  MeshData& d_;
  std::span<const glm::dvec3> positions_;
  double distance_;
  std::vector<Index> place_;  ///< of each vertex; kNone: not asked for
  std::size_t placeCount_ = 0;
  std::vector<std::pair<Index, Index>> crowded_;  ///< vertex and number of a crowded edge, sorted
  Index crowdedEdges_ = 0;
};

void BorderWelder::placeVertices(const std::vector<bool>& which) {
  place_.assign(positions_.size(), kNone);
  const auto number = [&](auto&& table) {
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (!which[v]) continue;
      place_[v] = table.indexOf(positions_[v]);
      placeCount_ = std::max<std::size_t>(placeCount_, std::size_t{place_[v]} + 1);
    }
  };
  placeCount_ = 0;
  if (distance_ > 0) {
    number(NearPlaces(distance_));
  } else {
    number(PositionTable(static_cast<std::size_t>(std::count(which.begin(), which.end(), true))));
  }
}

/// Sides with an end at one of the places, sorted; empty `places`: all.
std::vector<PlacedSide> BorderWelder::sidesAt(const std::vector<bool>& places,
                                              bool bordersOnly) const {
  std::vector<PlacedSide> sides;
  for (Index s = 0; s < d_.opposite.size(); ++s) {
    if (bordersOnly && d_.opposite[s] != kNone) continue;
    Index u = start(s), v = end(s);
    if (place_[u] == place_[v]) continue;  // of no length
    if (!places.empty() && !places[place_[u]] && !places[place_[v]]) continue;
    if (place_[u] > place_[v]) std::swap(u, v);
    sides.push_back({place_[u], place_[v], u, v, s});
  }
  return listedByPlace(sides, placeCount_);
}

template <class Visit>
void BorderWelder::forEachEdge(std::span<const PlacedSide> sides, const Visit& visit) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].sameEdge(sides[i])) ++end;
    visit(sides.subspan(i, end - i));
  }
}

/// Ends of border sides that could be glued, by borders alone; empty when there are none. Most
/// meshes have none, which is found out from their borders.
std::vector<bool> BorderWelder::placesOfPairs() {
  std::vector<bool> onBorder(positions_.size(), false);
  bool any = false;
  for (Index s = 0; s < d_.opposite.size(); ++s) {
    if (d_.opposite[s] != kNone) continue;
    onBorder[start(s)] = onBorder[end(s)] = true;
    any = true;
  }
  if (!any) return {};
  placeVertices(onBorder);
  std::vector<Index> ends;  // vertices, as places will get other numbers
  forEachEdge(sidesAt({}, true), [&](std::span<const PlacedSide> edge) {
    if (edge.size() != 2 || edge[0].sameVertices(edge[1])) return;
    ends.insert(ends.end(), {edge[0].vertexA, edge[0].vertexB});
  });
  if (ends.empty()) return {};
  std::vector<bool> used(positions_.size(), false);
  for (const auto& triangle : d_.triangles) {
    for (const Index v : triangle) used[v] = true;
  }
  if (used != onBorder) placeVertices(used);
  std::vector<bool> places(placeCount_, false);
  for (const Index v : ends) places[place_[v]] = true;
  return places;
}

/// Remembers at which vertices more than two sides meet that do not all share theirs.
void BorderWelder::noteCrowded(std::span<const PlacedSide> edge) {
  if (edge.size() <= 2 || edge.front().sameVertices(edge.back())) return;
  for (const PlacedSide& s : edge) {
    crowded_.emplace_back(s.vertexA, crowdedEdges_);
    crowded_.emplace_back(s.vertexB, crowdedEdges_);
  }
  ++crowdedEdges_;
}

/// Whether two vertices at one place bound the same crowded edge.
bool BorderWelder::meetElsewhere(Index u, Index v) const {
  if (u == v) return false;
  const std::pair<Index, Index> ofU(u, 0), ofV(v, 0);
  auto a = std::lower_bound(crowded_.begin(), crowded_.end(), ofU);
  auto b = std::lower_bound(crowded_.begin(), crowded_.end(), ofV);
  while (a != crowded_.end() && b != crowded_.end() && a->first == u && b->first == v) {
    if (a->second == b->second) return true;
    a->second < b->second ? ++a : ++b;
  }
  return false;
}

/// Whether the faces of two sides have the same places as corners.
bool BorderWelder::sameOutline(Index side, Index other) const {
  const auto places = [&](Index face) {
    const Index begin = d_.triangleBegin.empty() ? face : d_.triangleBegin[face];
    const Index end = d_.triangleBegin.empty() ? face + 1 : d_.triangleBegin[face + 1];
    std::vector<Index> all;
    for (Index t = begin; t < end; ++t) {
      for (const Index v : d_.triangles[t]) all.push_back(place_[v]);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  };
  return faceOf(side) != faceOf(other) && places(faceOf(side)) == places(faceOf(other));
}

bool BorderWelder::mayGlue(const PlacedSide& x, const PlacedSide& y) const {
  if (d_.opposite[x.side] != kNone || d_.opposite[y.side] != kNone) return false;
  if (x.sameVertices(y) || x.side / 3 == y.side / 3) return false;
  if (meetElsewhere(x.vertexA, y.vertexA) || meetElsewhere(x.vertexB, y.vertexB)) return false;
  return !sameOutline(x.side, y.side);
}

/// Of an edge with its two sides at different vertices. \returns false when they stay apart
bool BorderWelder::glue(const PlacedSide& x, const PlacedSide& y, GlueFindings& found) {
  if (!mayGlue(x, y)) return false;
  const Index s = x.side, t = y.side;
  if ((start(s) == x.vertexA) == (start(t) == y.vertexA)) {
    found.conflicts.emplace_back(std::min(s, t), std::max(s, t));
    return true;
  }
  d_.opposite[s] = t;
  d_.opposite[t] = s;
  if (isWithinFace(d_, s, t)) d_.slits.insert(d_.slits.end(), {s, t});
  return true;
}

bool BorderWelder::run(GlueFindings& found) {
  const std::vector<bool> places = placesOfPairs();
  if (places.empty()) return false;
  const std::vector<PlacedSide> sides = sidesAt(places, false);
  forEachEdge(sides, [&](std::span<const PlacedSide> edge) { noteCrowded(edge); });
  std::sort(crowded_.begin(), crowded_.end());
  bool any = false;
  forEachEdge(sides, [&](std::span<const PlacedSide> edge) {
    if (edge.size() == 2) {
      any = glue(edge[0], edge[1], found) || any;
    } else if (edge.size() > 2 && !edge.front().sameVertices(edge.back()) &&
               std::all_of(edge.begin(), edge.end(),
                           [&](const PlacedSide& s) { return d_.opposite[s.side] == kNone; })) {
      ++found.nonManifoldEdges;
      for (const PlacedSide& s : edge) found.nonManifoldSides.push_back(s.side);
    }
  });
  std::sort(found.conflicts.begin(), found.conflicts.end());
  return any;
}

}  // namespace

bool weldBorders(MeshData& d, std::span<const glm::dvec3> positions, double distance,
                 GlueFindings& found) {
  return BorderWelder(d, positions, distance).run(found);
}

}  // namespace chartflood
