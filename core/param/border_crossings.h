#pragma once
/// Whether the boundary of a flat chart crosses itself. A map without flips whose boundary does not
/// is one-to-one.

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/index.h"

namespace chartflood {

/// How near two segments have to come to cross.
enum class Contact {
  Any,   ///< touching is crossing
  Deep,  ///< each has its ends on different sides of the other, by more than 1e-5 times the product
         ///< of their lengths in twice the area: the sides of a closed slit shall not count
};

/// Whether the segments from a to b and from c to d cross.
bool segmentsCross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                   const glm::dvec2& d, Contact contact);

/// Marks the segments (from `loop[i]` to the next) that cross another that is not their neighbour.
/// \return true when there is any; `crossing` then says which
/// Cost: linear for even segments (uniform grid).
bool findCrossings(std::span<const Index> loop, std::span<const glm::dvec2> uv, Contact contact,
                   std::vector<bool>& crossing);

/// Marks the vertices (of `loop[i]`) that come nearer to a segment that is not their own than
/// `share` of the shorter of their two segments, or of `room[i]` if that is less (empty: it never
/// is), and the ends of segments that cross another however little. \return true when there is any
bool findTouches(std::span<const Index> loop, std::span<const glm::dvec2> uv, double share,
                 std::span<const double> room, std::vector<bool>& touching);

}  // namespace chartflood
