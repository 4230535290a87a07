#include "core/charts/open_surface.h"

#include <algorithm>
#include <map>

#include "core/base/check.h"

namespace chartflood {

OpenSurface::OpenSurface(ChartSurface& surface)
    : surface_(surface), firstSide_(firstSides(surface)), length_(surface.opposite.size()),
      loopOf_(surface.vertexCount(), kNone), triangleMark_(surface.triangleCount(), 0),
      sideMark_(surface.opposite.size(), 0) {
  std::vector<Index> boundary;
  for (Index side = 0; side < length_.size(); ++side) {
    if (boundarySide(side)) boundary.push_back(side);
    length_[side] = boundarySide(side) ? 0 : sideLength(surface, side);
  }
  traceLoops(boundary);
  const std::size_t edges = (length_.size() + boundary.size()) / 2;
  euler_ = static_cast<long>(surface.vertexCount()) - static_cast<long>(edges) +
           static_cast<long>(surface.triangleCount());
}

Index OpenSurface::nextOnBoundary(Index side) const {
  side = ChartSurface::nextSide(side);
  while (!boundarySide(side)) side = ChartSurface::nextSide(surface_.opposite[side]);
  return side;
}

void OpenSurface::open(std::span<const Index> sides) {
  // All sides that start at a vertex of the path; every vertex has one fan so far.
  std::vector<Index> corners;
  ++mark_;
  const auto collect = [&](Index vertex) {
    const Index first = firstSide_[vertex];
    if (sideMark_[first] == mark_) return;
    Index side = first;
    do {
      sideMark_[side] = mark_;
      corners.push_back(side);
      side = surface_.opposite[ChartSurface::previousSide(side)];
    } while (side != kNone && side != first);
    const Index loop = loopOf_[vertex];
    if (loop != kNone && loopStart_[loop] != kNone) {
      loopStart_[loop] = kNone;
      --loopCount_;
    }
  };
  for (const Index side : sides) {
    collect(surface_.sideStart(side));
    collect(surface_.sideEnd(side));
  }
  for (const Index side : sides) {
    const Index other = surface_.opposite[side];
    if (other == kNone) continue;
    CF_CHECK(!surface_.isDiagonal(side));
    surface_.opposite[side] = surface_.opposite[other] = kNone;
    length_[side] = length_[other] = 0;
    --euler_;
  }
  renumberFans(corners);
  traceLoops(corners);
}

void OpenSurface::renumberFans(std::vector<Index>& corners) {
  std::sort(corners.begin(), corners.end());
  std::vector<Index> old;
  old.reserve(corners.size());
  for (const Index side : corners) old.push_back(surface_.sideStart(side));
  std::vector<Index> kept;
  ++mark_;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (sideMark_[corners[i]] == mark_) continue;
    Index vertex = old[i];
    // The fan met first keeps the number of its vertex.
    if (std::find(kept.begin(), kept.end(), vertex) != kept.end()) {
      const glm::dvec3 position = surface_.positions[vertex];
      surface_.meshVertex.push_back(surface_.meshVertex[vertex]);
      surface_.positions.push_back(position);
      vertex = static_cast<Index>(firstSide_.size());
      firstSide_.push_back(kNone);
      loopOf_.push_back(kNone);
      ++euler_;
    } else {
      kept.push_back(vertex);
    }
    Index first = corners[i];
    for (Index back = surface_.opposite[first]; back != kNone; back = surface_.opposite[first]) {
      first = ChartSurface::nextSide(back);
      if (first == corners[i]) break;
    }
    firstSide_[vertex] = first;
    Index turn = first;
    do {
      sideMark_[turn] = mark_;
      surface_.triangles[turn / 3][turn % 3] = vertex;
      turn = surface_.opposite[ChartSurface::previousSide(turn)];
    } while (turn != kNone && turn != first);
  }
}

void OpenSurface::traceLoops(const std::vector<Index>& corners) {
  ++mark_;
  for (const Index start : corners) {
    if (!boundarySide(start) || sideMark_[start] == mark_) continue;
    const Index loop = loopNumbers();
    loopStart_.push_back(start);
    ++loopCount_;
    for (Index side = start; sideMark_[side] != mark_; side = nextOnBoundary(side)) {
      sideMark_[side] = mark_;
      loopOf_[surface_.sideStart(side)] = loop;
    }
  }
}

bool OpenSurface::staysConnected(std::span<const Index> sides) {
  ++mark_;
  for (const Index side : sides) {
    sideMark_[side] = mark_;
    if (!boundarySide(side)) sideMark_[surface_.opposite[side]] = mark_;
  }
  const Index target = surface_.opposite[sides.front()] / 3;
  stack_.assign(1, sides.front() / 3);
  triangleMark_[stack_.front()] = mark_;
  for (std::size_t i = 0; i < stack_.size(); ++i) {
    if (stack_[i] == target) return true;
    for (Index side = 3 * stack_[i]; side < 3 * stack_[i] + 3; ++side) {
      const Index other = surface_.opposite[side];
      if (other == kNone || sideMark_[side] == mark_ || triangleMark_[other / 3] == mark_) continue;
      triangleMark_[other / 3] = mark_;
      stack_.push_back(other / 3);
    }
  }
  return false;
}

namespace {

/// Inner vertices are places of their own, each boundary loop is one.
class Places {
 public:
  explicit Places(const OpenSurface& surface) : surface_(surface) {}
  bool onLoop(Index vertex) const { return surface_.loopOf(vertex) != kNone; }
  std::size_t of(Index vertex) const {
    return onLoop(vertex) ? surface_.vertexCount() + surface_.loopOf(vertex) : vertex;
  }
  std::size_t start(Index side) const { return of(surface_.surface().sideStart(side)); }
  std::size_t end(Index side) const { return of(surface_.surface().sideEnd(side)); }

 private:
  const OpenSurface& surface_;
};

/// Cuts a closed walk that meets each place once into pieces at the boundary.
HandlePath piecesOf(const OpenSurface& surface, std::vector<Index> part) {
  const auto startsOnLoop = [&](Index side) {
    return surface.loopOf(surface.surface().sideStart(side)) != kNone;
  };
  const auto first = std::find_if(part.begin(), part.end(), startsOnLoop);
  if (first != part.end()) std::rotate(part.begin(), first, part.end());
  HandlePath path;
  for (const Index side : part) {
    if (path.pieces.empty() || startsOnLoop(side)) path.pieces.emplace_back();
    path.pieces.back().push_back(side);
  }
  return path;
}

}  // namespace

std::optional<HandlePath> handlePath(OpenSurface& surface, std::span<const Index> walk) {
  std::vector<Index> inner;
  for (const Index side : walk) {
    if (!surface.boundarySide(side)) inner.push_back(side);
  }
  if (inner.empty()) return std::nullopt;
  const Places places(surface);
  std::size_t at = places.end(inner.back());
  for (const Index side : inner) {
    if (places.start(side) != at) return std::nullopt;
    at = places.end(side);
  }
  // Whenever the walk returns to a place, the part since then is a closed curve without crossings.
  std::vector<Index> stack, best;
  double bestLength = kNoWay;
  std::map<std::size_t, std::size_t> depth{{places.start(inner.front()), 0}};
  for (const Index side : inner) {
    stack.push_back(side);
    const auto [met, isNew] = depth.try_emplace(places.end(side), stack.size());
    if (isNew) continue;
    const std::size_t from = met->second;
    const std::vector<Index> part(stack.begin() + static_cast<long>(from), stack.end());
    for (std::size_t i = from; i + 1 < stack.size(); ++i) depth.erase(places.end(stack[i]));
    stack.resize(from);
    const bool thereAndBack = part.size() == 2 && surface.surface().opposite[part[0]] == part[1];
    double length = 0;
    for (const Index s : part) length += surface.wayLength(s);
    if (thereAndBack || !(length < bestLength) || !surface.staysConnected(part)) continue;
    best = part;
    bestLength = length;
  }
  if (best.empty()) return std::nullopt;
  HandlePath path = piecesOf(surface, best);
  path.whole = best.size() == inner.size();
  return path;
}

}  // namespace chartflood
