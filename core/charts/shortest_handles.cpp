#include "core/charts/shortest_handles.h"

#include <algorithm>

namespace chartflood {

namespace {

/// How much farther than needed a search looks, to spare its surroundings searches of their own.
constexpr double kReach = 1.5;
/// Sums along different ways differ by rounding.
constexpr double kRounding = 1 - 1e-12;

}  // namespace

ShortestHandles::ShortestHandles(OpenSurface& surface)
    : surface_(surface), bound_(surface.vertexCount(), 0) {
  resize();
  relabel();
}

void ShortestHandles::resize() {
  const std::size_t count = surface_.vertexCount();
  bound_.resize(count, 0);
  distance_.resize(count, 0);
  side_.resize(count, kNone);
  word_.resize(count, 0);
  stamp_.resize(count, 0);
  settled_.resize(count, 0);
}

/// Only vertices at labelled edges can be bases: every loop around a handle has such an edge.
void ShortestHandles::relabel() {
  labels_.label(surface_);
  bases_.clear();
  for (Index v = 0; v < bound_.size(); ++v) {
    if (labels_.at(surface_, v)) bases_.push(bound_[v], v);
  }
}

std::optional<std::vector<Index>> ShortestHandles::find(const Progress& progress) {
  if (!labels_.sure()) relabel();
  bool again = false;
  while (!progress.cancelled()) {
    const Walk* best = bestWalk();
    if (bases_.empty()) {
      if (best != nullptr) return best->sides;
      if (labels_.exact() || again) return std::nullopt;
      again = true;
      relabel();
      continue;
    }
    const auto [bound, vertex] = bases_.top();
    if (best != nullptr && bound >= best->length * kRounding) return best->sides;
    bases_.pop();
    if (!labels_.at(surface_, vertex)) continue;
    if (bound < bound_[vertex]) {
      if (bound_[vertex] < kNoWay) bases_.push(bound_[vertex], vertex);
      continue;
    }
    if (bound > bound_[vertex]) continue;
    const double reach = best != nullptr ? best->length : bound;
    search(vertex, reach > 0 ? kReach * reach : kNoWay);
    if (bound_[vertex] < kNoWay) bases_.push(bound_[vertex], vertex);
  }
  return std::nullopt;
}

void ShortestHandles::search(Index base, double limit) {
  grow(base, limit);
  if (foundSide_ != kNone) keepWalk(foundSide_);
  const double least = std::min(found_, limit);
  for (const Index v : order_) {
    bound_[v] = std::max(bound_[v], (least - 2 * distance_[v]) * kRounding);
  }
  bound_[base] = std::max(bound_[base], least);
}

void ShortestHandles::grow(Index base, double limit) {
  ++search_;
  queue_.clear();
  order_.clear();
  found_ = kNoWay;
  foundSide_ = kNone;
  stamp_[base] = search_;
  distance_[base] = 0;
  side_[base] = kNone;
  word_[base] = 0;
  queue_.push(0, base);
  while (!queue_.empty()) {
    const auto [reached, vertex] = queue_.pop();
    if (settled_[vertex] == search_) continue;
    // The middle of a loop is at half its length.
    if (2 * reached >= std::min(found_, limit)) break;
    settled_[vertex] = search_;
    order_.push_back(vertex);
    const auto visit = [&, reached = reached, vertex = vertex](Index side, Index end) {
      const double way = reached + surface_.wayLength(side);
      const std::uint64_t word = word_[vertex] ^ labels_.of(side);
      if (stamp_[end] != search_ || (settled_[end] != search_ && way < distance_[end])) {
        stamp_[end] = search_;
        distance_[end] = way;
        side_[end] = side;
        word_[end] = word;
        queue_.push(way, end);
      } else if (settled_[end] == search_ && word != word_[end] && way + distance_[end] < found_) {
        found_ = way + distance_[end];
        foundSide_ = side;
      }
    };
    forEachEdge(surface_.surface(), surface_.firstSide(vertex), visit);
  }
}

void ShortestHandles::keepWalk(Index side) {
  const ChartSurface& s = surface_.surface();
  const auto otherEnd = [&](Index edge, Index vertex) {
    return s.sideStart(edge) == vertex ? s.sideEnd(edge) : s.sideStart(edge);
  };
  const auto wayTo = [&](Index vertex) {
    std::vector<Index> way;
    for (; side_[vertex] != kNone; vertex = otherEnd(way.back(), vertex)) {
      way.push_back(side_[vertex]);
    }
    return way;
  };
  std::vector<Index> out = wayTo(s.sideStart(side)), back = wayTo(s.sideEnd(side));
  // What both ways share at the base is no part of the loop.
  while (!out.empty() && !back.empty() && out.back() == back.back()) {
    out.pop_back();
    back.pop_back();
  }
  Walk walk;
  walk.sides.assign(out.rbegin(), out.rend());
  walk.sides.push_back(side);
  for (const Index edge : back) {
    walk.sides.push_back(surface_.boundarySide(edge) ? edge : s.opposite[edge]);
  }
  for (const Index edge : walk.sides) walk.length += surface_.wayLength(edge);
  known_.push(walk.length, static_cast<Index>(walks_.size()));
  walks_.push_back(std::move(walk));
}

const ShortestHandles::Walk* ShortestHandles::bestWalk() {
  while (!known_.empty()) {
    const auto [length, number] = known_.top();
    Walk& walk = walks_[number];
    if (stillAround(walk)) {
      if (walk.length == length) return &walk;
      known_.pop();
      known_.push(walk.length, number);
    } else {
      known_.pop();
      walk.sides = {};
    }
  }
  return nullptr;
}

/// Looks again at a walk that was found before the last cuts; its length may have become less.
bool ShortestHandles::stillAround(Walk& walk) const {
  if (wordOf(walk.sides) == 0) return false;
  const ChartSurface& s = surface_.surface();
  // An edge that was opened since may have its other side on the walk's side: then it is given up.
  const Index last = walk.sides.back();
  for (Index start : {s.sideStart(last), s.sideEnd(last)}) {
    Index at = start;
    double length = 0;
    for (const Index side : walk.sides) {
      const Index a = s.sideStart(side), b = s.sideEnd(side);
      if (at != a && (at != b || !surface_.boundarySide(side))) {
        at = kNone;
        break;
      }
      at = at == a ? b : a;
      length += surface_.wayLength(side);
    }
    if (at == kNone || at != start) continue;
    walk.length = length;
    return true;
  }
  return false;
}

std::uint64_t ShortestHandles::wordOf(const std::vector<Index>& sides) const {
  std::uint64_t word = 0;
  for (const Index side : sides) word ^= labels_.of(side);
  return word;
}

void ShortestHandles::open(const std::vector<Index>& walk, const HandlePath& path) {
  const std::uint64_t word = wordOf(walk);
  const ChartSurface& s = surface_.surface();
  std::vector<Index> opened;
  for (const auto& piece : path.pieces) {
    for (const Index side : piece) {
      opened.push_back(side);
      opened.push_back(s.opposite[side]);
    }
    surface_.open(piece);
  }
  resize();
  if (path.whole) {
    labels_.open(word);
  } else {
    relabel();
  }
  std::vector<Index> vertices;
  for (const Index side : opened) {
    vertices.push_back(s.sideStart(side));
    vertices.push_back(s.sideEnd(side));
  }
  lowerBoundsNear(vertices);
}

/// A loop that became shorter by the cut runs along it: from a vertex d away there and back.
void ShortestHandles::lowerBoundsNear(const std::vector<Index>& vertices) {
  double highest = 0;
  for (const double bound : bound_) {
    if (bound < kNoWay) highest = std::max(highest, bound);
  }
  ++search_;
  queue_.clear();
  for (const Index v : vertices) {
    stamp_[v] = search_;
    distance_[v] = 0;
    queue_.push(0, v);
  }
  while (!queue_.empty()) {
    const auto [reached, vertex] = queue_.pop();
    if (settled_[vertex] == search_) continue;
    settled_[vertex] = search_;
    if (2 * reached * kRounding < bound_[vertex] || reached == 0) {
      bound_[vertex] = std::min(bound_[vertex], 2 * reached * kRounding);
      bases_.push(bound_[vertex], vertex);
    }
    if (2 * reached > highest) continue;
    const auto visit = [&, reached = reached](Index side, Index end) {
      const double way = reached + surface_.wayLength(side);
      if (stamp_[end] == search_ && !(way < distance_[end])) return;
      stamp_[end] = search_;
      distance_[end] = way;
      queue_.push(way, end);
    };
    forEachEdge(surface_.surface(), surface_.firstSide(vertex), visit);
  }
}

}  // namespace chartflood
