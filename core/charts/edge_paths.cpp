#include "core/charts/edge_paths.h"

#include <algorithm>

namespace chartflood {

std::vector<Index> firstSides(const ChartSurface& surface) {
  std::vector<Index> first(surface.vertexCount(), kNone);
  for (Index side = 0; side < surface.opposite.size(); ++side) {
    Index& entry = first[surface.sideStart(side)];
    if (entry == kNone || surface.opposite[side] == kNone) entry = side;
  }
  return first;
}

void VertexQueue::push(double distance, Index vertex) {
  const Entry entry{distance, vertex};
  std::size_t i = entries_.size();
  entries_.push_back(entry);
  while (i > 0) {
    const std::size_t parent = (i - 1) / 4;
    if (!(entry < entries_[parent])) break;
    entries_[i] = entries_[parent];
    i = parent;
  }
  entries_[i] = entry;
}

VertexQueue::Entry VertexQueue::pop() {
  const Entry top = entries_.front();
  const Entry last = entries_.back();
  entries_.pop_back();
  const std::size_t size = entries_.size();
  if (size == 0) return top;
  std::size_t i = 0;
  while (true) {
    const std::size_t first = 4 * i + 1;
    if (first >= size) break;
    std::size_t least = first;
    for (std::size_t c = first + 1; c < std::min(first + 4, size); ++c) {
      if (entries_[c] < entries_[least]) least = c;
    }
    if (!(entries_[least] < last)) break;
    entries_[i] = entries_[least];
    i = least;
  }
  entries_[i] = last;
  return top;
}

EdgeDistances::EdgeDistances(const ChartSurface& surface)
    : surface_(surface), firstSide_(firstSides(surface)), distance_(surface.vertexCount(), kNoWay),
      side_(surface.vertexCount(), kNone) {}

void EdgeDistances::addSource(Index vertex) {
  distance_[vertex] = 0;
  side_[vertex] = kNone;
  queue_.push(0, vertex);
}

Index EdgeDistances::next() {
  while (!queue_.empty()) {
    const auto [reached, vertex] = queue_.pop();
    if (reached > distance_[vertex]) continue;
    const auto visit = [&, reached = reached, vertex = vertex](Index side, Index end) {
      const auto [a, b] = forbidden_;
      if ((vertex == a && end == b) || (vertex == b && end == a)) return;
      const double way = reached + sideLength(surface_, side);
      if (!(way < distance_[end])) return;
      distance_[end] = way;
      side_[end] = side;
      queue_.push(way, end);
    };
    forEachEdge(surface_, firstSide_[vertex], visit);
    return vertex;
  }
  return kNone;
}

std::vector<Index> EdgeDistances::pathTo(Index vertex) const {
  std::vector<Index> path;
  for (Index at = vertex; side_[at] != kNone;) {
    path.push_back(side_[at]);
    const Index start = surface_.sideStart(side_[at]);
    at = start == at ? surface_.sideEnd(side_[at]) : start;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace chartflood
