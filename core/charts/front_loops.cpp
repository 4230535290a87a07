#include "core/charts/front_loops.h"

#include <algorithm>

#include "core/base/check.h"

namespace chartflood {

LiddedSurface::LiddedSurface(const ChartSurface& surface)
    : surface_(surface), faceOfTriangle_(surface.triangleCount(), kNone),
      lidOf_(surface.opposite.size(), kNone), lidNext_(surface.opposite.size(), kNone),
      faceSide_(surface.triangleCount(), kNone) {
  std::vector<Index> stack;
  std::vector<std::size_t> sides(surface.triangleCount(), 0);
  for (Index t = 0; t < surface.triangleCount(); ++t) {
    if (faceOfTriangle_[t] != kNone) continue;
    faceOfTriangle_[t] = t;
    stack.push_back(t);
    while (!stack.empty()) {
      const Index at = stack.back();
      stack.pop_back();
      for (Index side = 3 * at; side < 3 * at + 3; ++side) {
        if (!surface.isDiagonal(side)) {
          ++sides[t];
          faceSide_[t] = std::min(faceSide_[t], side);
          continue;
        }
        const Index other = surface.opposite[side] / 3;
        if (faceOfTriangle_[other] != kNone) continue;
        faceOfTriangle_[other] = t;
        stack.push_back(other);
      }
    }
  }
  for (const auto& loop : boundaryLoops(surface)) {
    const Index lid = static_cast<Index>(faceSide_.size());
    faceSide_.push_back(loop.front() + sideCount());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      lidOf_[loop[i]] = lid;
      // The lid lies on the other side, so that its sides run the other way round.
      lidNext_[loop[(i + 1) % loop.size()]] = loop[i];
    }
  }
  for (Index t = 0; t < surface.triangleCount(); ++t) {
    if (faceOfTriangle_[t] != t) continue;
    regular_ = regular_ && faceSide_[t] != kNone && sidesOf(t).size() == sides[t];
    for (Index side = 3 * t; side < 3 * t + 3; ++side) {
      regular_ = regular_ && surface.opposite[side] / 3 != t;
    }
  }
}

Index LiddedSurface::next(Index side) const {
  if (onLid(side)) return lidNext_[side - sideCount()] + sideCount();
  side = ChartSurface::nextSide(side);
  while (surface_.isDiagonal(side)) side = ChartSurface::nextSide(surface_.opposite[side]);
  return side;
}

std::vector<Index> LiddedSurface::sidesOf(Index face) const {
  std::vector<Index> sides;
  Index side = faceSide_[face];
  do {
    sides.push_back(side);
    side = next(side);
  } while (side != faceSide_[face]);
  return sides;
}

std::vector<Index> LiddedSurface::trianglesOf(Index face) const {
  std::vector<Index> triangles{face};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (Index side = 3 * triangles[i]; side < 3 * triangles[i] + 3; ++side) {
      if (!surface_.isDiagonal(side)) continue;
      const Index other = surface_.opposite[side] / 3;
      if (std::find(triangles.begin(), triangles.end(), other) == triangles.end()) {
        triangles.push_back(other);
      }
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

double LiddedSurface::length(Index side) const {
  if (onLid(side) || surface_.opposite[side] == kNone) return 0;
  return sideLength(surface_, side);
}

glm::dvec3 LiddedSurface::centreOf(Index face) const {
  glm::dvec3 sum(0);
  double count = 0;
  for (const Index t : trianglesOf(face)) {
    for (const Index v : surface_.triangles[t]) sum += surface_.positions[v];
    count += 3;
  }
  return sum / count;
}

std::vector<Index> traceFront(const LiddedSurface& surface, const std::vector<Index>& stepOfFace,
                              Index step, Index start) {
  const auto taken = [&](Index side) {
    const Index at = stepOfFace[surface.faceOf(side)];
    return at != kNone && at <= step;
  };
  std::vector<Index> sides;
  Index side = start;
  do {
    sides.push_back(side);
    side = surface.next(side);
    while (taken(surface.opposite(side))) side = surface.next(surface.opposite(side));
  } while (side != start);
  return sides;
}

FrontLoops::FrontLoops(const LiddedSurface& surface)
    : surface_(surface), next_(2 * surface.sideCount(), kNone), previous_(next_.size(), kNone),
      slotOf_(next_.size(), kNone) {}

void FrontLoops::take(Index face, const std::function<void(const HandleEvent&)>& happened) {
  std::vector<Index> sides = surface_.sidesOf(face);
  const auto met = [&](Index side) { return onFront(surface_.opposite(side)); };
  // Begin with the first of a run of edges that touch the region, so that a run zips up.
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (met(sides[i]) && !met(sides[(i + sides.size() - 1) % sides.size()])) {
      std::rotate(sides.begin(), sides.begin() + static_cast<long>(i), sides.end());
      break;
    }
  }
  std::vector<Index> gluing;
  double length = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (met(sides[i])) gluing.push_back(sides[i]);
    link(sides[i], sides[(i + 1) % sides.size()]);
    length += surface_.length(sides[i]);
  }
  Index slot = static_cast<Index>(slots_.size());
  if (gluing.empty()) {
    CF_CHECK(slots_.empty());
    slots_.push_back({fronts_++, sides.front(), length});
  } else {
    slot = slotOf_[surface_.opposite(gluing.front())];
  }
  for (const Index side : sides) slotOf_[side] = slot;
  changed_.push_back(slot);
  for (std::size_t i = 0; i < gluing.size(); ++i) {
    if (i == 0) {
      attach(gluing[i], length);
    } else {
      glue(gluing[i], happened);
    }
  }
}

/// Joins a face that is a chain of its own to the front that it meets at `x`: no event.
void FrontLoops::attach(Index x, double faceLength) {
  const Index y = surface_.opposite(x);
  const Index nx = next_[x], px = previous_[x], ny = next_[y], py = previous_[y];
  Slot& slot = slots_[slotOf_[y]];
  if (nx != x && ny != y) {
    link(py, nx);
    link(px, ny);
  } else if (ny != y) {
    link(py, ny);
  } else if (nx != x) {
    link(px, nx);
  }
  slot.length += faceLength - 2 * surface_.length(x);
  slot.side = nx != x ? nx : (ny != y ? ny : kNone);
  slotOf_[x] = slotOf_[y] = kNone;
}

void FrontLoops::glue(Index x, const std::function<void(const HandleEvent&)>& happened) {
  const Index y = surface_.opposite(x);
  const Index nx = next_[x], px = previous_[x], ny = next_[y], py = previous_[y];
  const Index slotX = slotOf_[x], slotY = slotOf_[y];
  slotOf_[x] = slotOf_[y] = kNone;
  changed_.push_back(slotX);
  changed_.push_back(slotY);
  const double gone = surface_.length(x);
  if (slotX != slotY) {
    slots_[slotX].length -= gone;
    slots_[slotY].length -= gone;
    if (nx != x && ny != y) {
      link(py, nx);
      link(px, ny);
    } else if (nx != x) {
      link(px, nx);
    } else if (ny != y) {
      link(py, ny);
    }
    join(slotX, slotY, nx != x ? nx : kNone, ny != y ? ny : kNone, happened);
    return;
  }
  Slot& slot = slots_[slotX];
  slot.length -= 2 * gone;
  // Two chains are left: from behind x to before y, and from behind y to before x.
  const bool first = nx != y, second = ny != x;
  if (first) link(py, nx);
  if (second) link(px, ny);
  slot.side = first ? nx : (second ? ny : kNone);
  if (first && second) {
    split(slotX, nx, ny, happened);
  } else if (!first && !second) {
    happened({HandleEventKind::Close, 0, {slot.front, kNone, kNone}});
  }
}

/// True when the chain of `a` has no more sides than that of `b`, in time of the shorter one.
bool FrontLoops::firstIsShorter(Index a, Index b) const {
  Index i = a, j = b;
  do {
    i = next_[i];
    j = next_[j];
  } while (i != a && j != b);
  return i == a;
}

/// Moves a chain into a slot; returns its length.
double FrontLoops::moveTo(Index slot, Index start) {
  double length = 0;
  Index side = start;
  do {
    slotOf_[side] = slot;
    length += surface_.length(side);
    side = next_[side];
  } while (side != start);
  return length;
}

void FrontLoops::split(Index slot, Index a, Index b,
                       const std::function<void(const HandleEvent&)>& happened) {
  if (firstIsShorter(b, a)) std::swap(a, b);
  const Index old = slots_[slot].front, added = static_cast<Index>(slots_.size());
  slots_.push_back({});
  const double length = moveTo(added, a);
  slots_[added] = {fronts_++, a, length};
  slots_[slot] = {fronts_++, b, slots_[slot].length - length};
  changed_.push_back(added);
  happened({HandleEventKind::Split, 0, {old, slots_[added].front, slots_[slot].front}});
}

void FrontLoops::join(Index a, Index b, Index sideA, Index sideB,
                      const std::function<void(const HandleEvent&)>& happened) {
  // Both chains are one already: give all its sides one slot.
  const Index oldA = slots_[a].front, oldB = slots_[b].front;
  const double length = slots_[a].length + slots_[b].length;
  const Index side = sideA != kNone ? sideA : sideB;
  if (side != kNone) moveTo(a, side);
  slots_[a] = {fronts_++, side, length};
  slots_[b] = {};
  happened({HandleEventKind::Touch, 0, {oldA, oldB, slots_[a].front}});
  if (side == kNone) happened({HandleEventKind::Close, 0, {slots_[a].front, kNone, kNone}});
}

std::vector<FrontState> FrontLoops::changed() {
  std::vector<FrontState> states;
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  for (const Index slot : changed_) {
    const Slot& s = slots_[slot];
    if (s.side != kNone) states.push_back({0, s.front, s.side, s.length});
  }
  std::sort(states.begin(), states.end(),
            [](const FrontState& a, const FrontState& b) { return a.front < b.front; });
  changed_.clear();
  return states;
}

}  // namespace chartflood
