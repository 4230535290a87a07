#pragma once
/// Shapes placed in a square, and the space to keep free between them.

#include <vector>

namespace chartflood {

/// Place of a shape: its centre, and its turn in radians, counter-clockwise.
struct Pose {
  double x = 0, y = 0, angle = 0;
};

/// Shapes in a square about the origin, layout units.
struct PackLayout {
  double side = 0;
  std::vector<Pose> poses;
};

/// Space to keep free, as shares of the square's side.
struct PackGaps {
  /// Between two shapes, along each axis: one of the two coordinates must differ by as much.
  double between = 0;
  double border = 0;  ///< to the square's sides
};

}  // namespace chartflood
