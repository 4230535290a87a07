#include "core/charts/handle_labels.h"

#include <numeric>

namespace chartflood {

namespace {

/// A spanning tree of the faces, breadth first: triangles, then one lid for each boundary loop.
/// Triangles of a polygon hang together across its diagonals.
class FaceTree {
 public:
  explicit FaceTree(const OpenSurface& surface)
      : open_(surface), s_(surface.surface()), triangles_(static_cast<Index>(s_.triangleCount())),
        parent_(triangles_ + surface.loopNumbers(), kNone), across_(parent_.size(), kNone),
        reached_(parent_.size(), false), crossed_(s_.opposite.size(), false) {
    for (Index t = 0; t < triangles_; ++t) {
      if (reached_[t]) continue;
      reach(t, kNone, kNone);
      for (; next_ < order_.size(); ++next_) visit(order_[next_]);
    }
  }

  bool crosses(Index side) const { return crossed_[side]; }
  Index faceBeyond(Index side) const {
    const Index other = s_.opposite[side];
    return other == kNone ? triangles_ + open_.loopOf(s_.sideStart(side)) : other / 3;
  }
  std::size_t size() const { return parent_.size(); }
  /// Adds up what hangs below each edge of the tree.
  void sumUp(std::vector<std::uint64_t>& word, std::vector<std::uint64_t>& label) const {
    for (std::size_t i = order_.size(); i-- > 0;) {
      const Index face = order_[i];
      if (parent_[face] == kNone) continue;
      const Index side = across_[face];
      label[side] = word[face];
      if (s_.opposite[side] != kNone) label[s_.opposite[side]] = word[face];
      word[parent_[face]] ^= word[face];
    }
  }

 private:
  void reach(Index face, Index parent, Index side) {
    reached_[face] = true;
    parent_[face] = parent;
    across_[face] = side;
    order_.push_back(face);
    if (side != kNone) {
      crossed_[side] = true;
      if (s_.opposite[side] != kNone) crossed_[s_.opposite[side]] = true;
    }
    if (face >= triangles_ || s_.diagonal.empty()) return;
    for (Index d = 3 * face; d < 3 * face + 3; ++d) {
      if (s_.isDiagonal(d) && !reached_[s_.opposite[d] / 3]) reach(s_.opposite[d] / 3, face, d);
    }
  }
  void visit(Index face) {
    if (face < triangles_) {
      for (Index side = 3 * face; side < 3 * face + 3; ++side) {
        if (!reached_[faceBeyond(side)]) reach(faceBeyond(side), face, side);
      }
      return;
    }
    const Index start = open_.loopStart(face - triangles_);
    Index side = start;
    do {
      if (!reached_[side / 3]) reach(side / 3, face, side);
      side = open_.nextOnBoundary(side);
    } while (side != start);
  }

  const OpenSurface& open_;
  const ChartSurface& s_;
  Index triangles_;
  std::vector<Index> parent_, across_, order_;
  std::vector<bool> reached_, crossed_;
  std::size_t next_ = 0;
};

Index rootOf(std::vector<Index>& parent, Index v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

/// The i-th word of a fixed random sequence (SplitMix64, Steele et al. 2014).
std::uint64_t randomWord(std::uint64_t i) {
  std::uint64_t z = (i + 1) * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

}  // namespace

void HandleLabels::label(const OpenSurface& surface) {
  const ChartSurface& s = surface.surface();
  const FaceTree tree(surface);
  label_.assign(s.opposite.size(), 0);
  std::vector<Index> parent(s.vertexCount());
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<Index> leftOver;
  for (Index side = 0; side < s.opposite.size(); ++side) {
    const Index other = s.opposite[side];
    if ((other != kNone && other < side) || tree.crosses(side) || s.isDiagonal(side)) continue;
    const Index a = rootOf(parent, s.sideStart(side)), b = rootOf(parent, s.sideEnd(side));
    if (a == b) {
      leftOver.push_back(side);
    } else {
      parent[a] = b;
    }
  }
  exact_ = leftOver.size() <= 64;
  bits_ = 64;
  std::vector<std::uint64_t> word(tree.size(), 0);
  for (std::size_t i = 0; i < leftOver.size(); ++i) {
    const Index side = leftOver[i], other = s.opposite[side];
    const std::uint64_t own = exact_ ? std::uint64_t{1} << i : randomWord(i);
    word[side / 3] ^= own;
    word[tree.faceBeyond(side)] ^= own;
    label_[side] = own;
    if (other != kNone) label_[other] = own;
  }
  tree.sumUp(word, label_);
}

bool HandleLabels::at(const OpenSurface& surface, Index vertex) const {
  std::uint64_t any = 0;
  forEachEdge(surface.surface(), surface.firstSide(vertex),
              [&](Index side, Index) { any |= label_[side]; });
  return any != 0;
}

void HandleLabels::open(std::uint64_t word) {
  const std::uint64_t pivot = word & (~word + 1);
  for (std::uint64_t& label : label_) {
    if ((label & pivot) != 0) label ^= word;
  }
  --bits_;
}

}  // namespace chartflood
