#pragma once
/// The free part of a square while shapes are placed one by one.

#include <span>
#include <vector>

#include "core/pack/lanes.h"
#include "core/pack/pack_layout.h"
#include "core/pack/pack_shape.h"

namespace chartflood {

/// Distances to a placed shape, on the cells of a square around it.
struct Footprint {
  int left = 0, bottom = 0, width = 0, height = 0;  ///< cells; left and width fill whole lanes
  std::vector<short> room;                          ///< row by row, as FreeSpace has it
};

/// Distance to the nearest placed shape or side of the square, on a grid of cells.
class FreeSpace {
 public:
  /// \param gap distance to keep between shapes, \param border to the sides; layout units
  FreeSpace(double side, double gap, double border);

  /// To be used again in all squares of the same size.
  Footprint footprint(const PackShape& shape, const Pose& pose) const;
  void add(const Footprint& footprint);

  /// The place where the shape lies closest to what is there and overlaps it least, over all cells
  /// and `turns` turns from `firstAngle` on.
  Pose bestPose(const PackShape& shape, double firstAngle, int turns);

 private:
  static constexpr int kCells = 72;  ///< a side of the square
  static constexpr int kFrame = 4;   ///< cells around it
  static constexpr int kStride = kCells + 2 * kFrame;
  static_assert(kStride % kShortLanes == 0);

  void findCosts();

  double side_, cell_;
  short need_;
  std::vector<short> room_;  ///< the distance, in small parts of a layout unit
  std::vector<short> cost_;  ///< of having a point of a shape there
};

}  // namespace chartflood
