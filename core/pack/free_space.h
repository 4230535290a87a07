#pragma once
/// The free part of a square while shapes are placed one by one.

#include <span>
#include <vector>

#include "core/pack/pack_shape.h"
#include "core/pack/squeeze.h"

namespace chartflood {

/// Distance to the nearest placed shape or side of the square, on a grid of cells.
class FreeSpace {
 public:
  /// \param gap distance to keep between shapes, \param border to the sides; layout units
  FreeSpace(double side, double gap, double border);

  void add(const PackShape& shape, const Pose& pose);

  /// The place where the shape lies closest to what is there and overlaps it least, over all cells
  /// and `turns` turns from `firstAngle` on.
  Pose bestPose(const PackShape& shape, double firstAngle, int turns);

 private:
  static constexpr int kCells = 72;  ///< a side of the square
  static constexpr int kFrame = 24;  ///< cells around it

  double side_, cell_, gap_;
  int stride_;
  std::vector<float> distance_;
  std::vector<float> cost_;
};

}  // namespace chartflood
