#pragma once
/// Shapes placed in a square, and the space to keep free between them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace chartflood {

/// What all charts cover together, layout units. It grows with many charts, so that lengths of
/// single charts, and all that is set for them, are about the same for any number.
inline double layoutArea(std::size_t charts) {
  return std::max(1.0, static_cast<double>(charts) / 20);
}

/// Place of a shape: its centre, and its turn in radians, counter-clockwise.
struct Pose {
  double x = 0, y = 0, angle = 0;
};

/// Shapes in a square about the origin, layout units.
struct PackLayout {
  double side = 0;
  std::vector<Pose> poses;
};

/// A small length beside the charts, layout units: a 1024th of the side of a square of twenty.
inline double grainOf(double side, std::size_t charts) {
  return side / std::sqrt(layoutArea(charts)) / 1024;
}

/// Space to keep free, as shares of the square's side.
struct PackGaps {
  /// Between two shapes, along each axis: one of the two coordinates must differ by as much.
  double between = 0;
  double border = 0;  ///< to the square's sides
};

}  // namespace chartflood
