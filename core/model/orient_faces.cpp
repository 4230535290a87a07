#include "core/model/orient_faces.h"

#include <algorithm>
#include <numeric>

namespace chartflood {

namespace {

/// Parts of faces whose turns against each other are known.
class TurnedParts {
 public:
  explicit TurnedParts(std::size_t faces) : parent_(faces), turn_(faces, false), size_(faces, 1) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  struct Place {
    Index root;
    bool turned;  ///< against the root
  };
  Place find(Index face) {
    Index root = face;
    bool turned = false;
    while (parent_[root] != root) {
      turned = turned != turn_[root];
      root = parent_[root];
    }
    for (bool rest = turned; parent_[face] != root && face != root;) {
      const Index up = parent_[face];
      const bool own = turn_[face];
      parent_[face] = root;
      turn_[face] = rest;
      rest = rest != own;
      face = up;
    }
    return {root, turned};
  }

  /// Two faces that agree (or do not) along an edge; nothing when their turns are known.
  void unite(Index a, Index b, bool disagree) {
    Place x = find(a), y = find(b);
    if (x.root == y.root) return;
    if (size_[x.root] < size_[y.root]) std::swap(x, y);
    parent_[y.root] = x.root;
    turn_[y.root] = (x.turned != y.turned) != disagree;
    size_[x.root] += size_[y.root];
  }

  std::size_t size(Index root) const { return size_[root]; }

 private:
  std::vector<Index> parent_;
  std::vector<bool> turn_;
  std::vector<std::size_t> size_;
};

/// The faces to turn: the smaller number in every part.
std::vector<bool> minority(TurnedParts& parts, std::size_t faces) {
  std::vector<std::size_t> turned(faces, 0);  // of each part
  std::vector<bool> firstTurned(faces, false), met(faces, false);
  for (Index f = 0; f < faces; ++f) {
    const auto [root, isTurned] = parts.find(f);
    turned[root] += isTurned ? 1 : 0;
    if (!met[root]) firstTurned[root] = isTurned;
    met[root] = true;
  }
  std::vector<bool> turn(faces, false);
  for (Index f = 0; f < faces; ++f) {
    const auto [root, isTurned] = parts.find(f);
    const std::size_t others = parts.size(root) - turned[root];
    const bool turnTheTurned = turned[root] != others ? turned[root] < others : !firstTurned[root];
    turn[f] = isTurned == turnTheTurned;
  }
  return turn;
}

/// A triangle a b c becomes a c b: its sides swap places.
Index mirroredSide(Index side) { return side - side % 3 + (2 - side % 3); }

/// Turns the triangles of faces over, with all that belongs to their sides.
void turnOver(MeshData& d, const std::vector<bool>& turn) {
  const auto isTurned = [&](Index side) {
    return turn[d.faceOfTriangle.empty() ? side / 3 : d.faceOfTriangle[side / 3]];
  };
  const std::size_t sides = d.opposite.size();
  if (d.inputCorner.empty()) {
    d.inputCorner.resize(sides);
    std::iota(d.inputCorner.begin(), d.inputCorner.end(), Index{0});
  }
  const auto moved = [&](Index side) { return isTurned(side) ? mirroredSide(side) : side; };
  std::vector<Index> opposite(sides, kNone);
  for (Index s = 0; s < sides; ++s) {
    if (d.opposite[s] != kNone) opposite[moved(s)] = moved(d.opposite[s]);
  }
  d.opposite = std::move(opposite);
  for (Index& side : d.slits) side = moved(side);
  std::sort(d.slits.begin(), d.slits.end());
  for (Index t = 0; t < d.triangles.size(); ++t) {
    if (!isTurned(3 * t)) continue;
    std::swap(d.triangles[t][1], d.triangles[t][2]);
    std::swap(d.inputCorner[3 * t + 1], d.inputCorner[3 * t + 2]);
  }
  d.turned = turn;
}

}  // namespace

std::size_t orientFaces(MeshData& d, std::vector<std::pair<Index, Index>>& conflicts) {
  if (conflicts.empty()) return 0;
  const auto faceOf = [&](Index side) {
    return d.faceOfTriangle.empty() ? side / 3 : d.faceOfTriangle[side / 3];
  };
  TurnedParts parts(d.faceCount);
  for (Index s = 0; s < d.opposite.size(); ++s) {
    if (d.opposite[s] != kNone && s < d.opposite[s]) {
      parts.unite(faceOf(s), faceOf(d.opposite[s]), false);
    }
  }
  for (const auto& [a, b] : conflicts) parts.unite(faceOf(a), faceOf(b), true);
  const std::vector<bool> turn = minority(parts, d.faceCount);
  const auto count = static_cast<std::size_t>(std::count(turn.begin(), turn.end(), true));
  if (count > 0) turnOver(d, turn);
  std::vector<std::pair<Index, Index>> left;
  for (auto [a, b] : conflicts) {
    const bool agree = turn[faceOf(a)] != turn[faceOf(b)];
    if (turn[faceOf(a)]) a = mirroredSide(a);
    if (turn[faceOf(b)]) b = mirroredSide(b);
    if (agree) {
      d.opposite[a] = b;
      d.opposite[b] = a;
    } else {
      left.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  conflicts = std::move(left);
  return count;
}

}  // namespace chartflood
