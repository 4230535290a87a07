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
  /// Whether a shape may lie in others a little when it lies closer to them so, as for squeezing,
  /// or only where it fits.
  enum class Overlap { Dear, Barred };
  /// All in layout units. \param gap distance to keep between shapes, \param border to the sides,
  /// \param cell about what the cells' sides shall be
  FreeSpace(double side, double gap, double border, double cell, Overlap overlap = Overlap::Dear);

  /// To be used again in all squares of the same size.
  Footprint footprint(const PackShape& shape, const Pose& pose) const;
  void add(const Footprint& footprint);

  /// The place where the shape lies closest to what is there and overlaps it least, over all cells
  /// and `turns` turns from `firstAngle` on.
  Pose bestPose(const PackShape& shape, double firstAngle, int turns);

  /// How many times eight places side by side were looked at so far, all turns counted.
  std::size_t looks() const { return looks_; }

  /// Whether the shape keeps the gap there from all that was added.
  bool fits(const PackShape& shape, const Pose& pose) const;

 private:
  static constexpr int kFrame = 4;  ///< cells around the square

  struct Stamp;
  /// What must be free around a shape's deepest point.
  struct Room {
    short least, most;
  };
  struct Best {
    Pose pose;
    short cost = 32767;
  };
  /// The least and the most room in a block of cells.
  struct Span {
    short least, most;
  };
  /// Places of a shape at one turn, as the cells that its deepest point may lie in.
  struct Places {
    int left, right, bottom, top;
  };

  void findCosts(std::size_t at);                            ///< of eight cells
  void findSpans(int left, int right, int bottom, int top);  ///< of the blocks of these cells
  static ShortLanes costOf(const Stamp& stamp, const short* costs, short best);
  void lookAt(const Stamp& stamp, double angle, const Room& room, Best& best);
  void lookAtRow(const Stamp& stamp, int j, const Places& places, double angle, const Room& room,
                 Best& best);

  int cells_;   ///< a side of the square
  int stride_;  ///< whole lanes
  double side_, cell_;
  short need_, leastOverlap_;
  std::vector<short> room_;  ///< the distance, in small parts of a layout unit
  std::vector<short> cost_;  ///< of having a point of a shape there
  std::vector<Span> spans_;  ///< of blocks of lanes by as many rows
  std::vector<int> open_;    ///< blocks of a row that the deepest point of a shape may lie in
  std::size_t looks_ = 0;
};

}  // namespace chartflood
