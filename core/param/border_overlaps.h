#pragma once
/// Charts of a texture that may lie over themselves or each other, told by their borders alone. A
/// chart without flips whose border does not cross itself is one-to-one, and two such charts share
/// a place only when their borders cross or one holds the other.

#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace chartflood {

/// Parallel to the axes; meets nothing while nothing was added.
struct PlaneBox {
  glm::dvec2 low{1e300}, high{-1e300};

  void add(const glm::dvec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool meets(const PlaneBox& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
};

/// The corners of a closed border in order.
using FlatBorder = std::vector<glm::dvec2>;

/// Marks the charts whose border crosses itself or another one, holds another or is held by one.
/// Touching is no crossing (Contact::Deep). Empty borders meet nothing.
/// Cost: linear in the number of corners, times the number of charts whose boxes lie over one
/// another. \throws Interrupted
std::vector<bool> findMeetingCharts(std::span<const FlatBorder> borders);

}  // namespace chartflood
