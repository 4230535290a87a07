#pragma once
/// Edges that the user wants cut, or kept whole.

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

enum class HintKind : std::uint8_t {
  Cut,    ///< a seam is welcome here
  Never,  ///< a seam is to stay away
};

/// An edge by its vertices in the input file, the smaller number first.
struct EdgeHint {
  Index a = kNone, b = kNone;
  HintKind kind = HintKind::Cut;

  bool operator==(const EdgeHint&) const = default;
  bool operator<(const EdgeHint& other) const {
    return std::tie(a, b) < std::tie(other.a, other.b);
  }
};

/// Ascending, each edge once.
using EdgeHints = std::vector<EdgeHint>;

/// Gives an edge a hint, in the place of one it had. Cost: linear.
inline void addHint(EdgeHints& hints, Index a, Index b, HintKind kind) {
  const EdgeHint hint{std::min(a, b), std::max(a, b), kind};
  const auto place = std::lower_bound(hints.begin(), hints.end(), hint);
  if (place != hints.end() && place->a == hint.a && place->b == hint.b) {
    *place = hint;
  } else {
    hints.insert(place, hint);
  }
}

}  // namespace chartflood
