#pragma once
/// Squeezes a layout: shapes that push each other apart where they come too close, inside a square
/// whose walls press on them. They slide and turn until they jam.

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/pack/pack_shape.h"

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

struct SqueezeOptions {
  double pressure =
      0;  ///< force on the walls; what shapes are pressed into each other grows with it
  int steps = 0;
};

/// Minimises the energy of the contacts and the walls with the fast inertial relaxation engine
/// (Bitzek et al. 2006): places, turns and the square's side together. A point of an outline that
/// is too deep in another shape's field pushes with a force that grows with the depth.
/// Reads the shapes, which must live as long as the object does.
class Squeezer {
 public:
  Squeezer(std::span<const PackShape> shapes, const PackGaps& gaps);

  /// Moves the layout on. Stops early when cancelled.
  void run(PackLayout& layout, const SqueezeOptions& options, const Progress& progress);

  /// Energy of the contacts in the last step, without the walls' pressure.
  double energy() const { return energy_; }
  /// How deep any point lay in another shape or a wall in the last step, gaps counted.
  double depth() const { return depth_; }

 private:
  struct Item {
    float x = 0, y = 0, cos = 1, sin = 0;
    float fx = 0, fy = 0, torque = 0;
  };

  void findPairs(const PackLayout& layout, double skin);
  void computeForces(const PackLayout& layout);
  void pushFromField(Index fieldOf, Index pointsOf);
  void pushFromWalls(Index item);
  void step(PackLayout& layout, double pressure);

  std::span<const PackShape> shapes_;
  PackGaps gaps_;
  std::vector<std::pair<Index, Index>> pairs_;
  std::vector<Pose> pairedAt_;
  double pairedSide_ = 0;
  std::vector<Item> items_;
  std::vector<double> inverseRoot_;  ///< of the mass: three a shape, then the side's
  std::vector<double> force_, velocity_;
  float gap_ = 0, wall_ = 0, depth_ = 0;
  double energy_ = 0, sideForce_ = 0;
  double dt_ = 0, mixing_ = 0;
  int downhill_ = 0;
};

}  // namespace chartflood
