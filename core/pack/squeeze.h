#pragma once
/// Squeezes a layout: shapes that push each other apart where they come too close, inside a square
/// whose walls press on them. They slide and turn until they jam.

#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/pack/contacts.h"
#include "core/pack/pack_layout.h"
#include "core/pack/pack_shape.h"

namespace chartflood {

struct SqueezeOptions {
  double pressure =
      0;  ///< force on the walls; what shapes are pressed into each other grows with it
  int steps = 0;
  double skin = 0.012;  ///< layout units, see Contacts
};

/// The pressure that presses shapes about so many grains deep into each other.
inline double pressureFor(double depth, double side) { return 4 * depth / 1024 * side; }

/// Minimises the energy of the contacts and the walls with the fast inertial relaxation engine
/// (Bitzek et al. 2006): places, turns and the square's side together. A point of an outline that
/// is too deep in another shape's field pushes with a force that grows with the depth.
/// Reads the shapes, which must live as long as the object does.
class Squeezer {
 public:
  Squeezer(std::span<const PackShape> shapes, const PackGaps& gaps);

  /// Stops all motion, as before another layout or another pressure.
  void rest();
  /// Moves the layout on. Stops early when cancelled.
  void run(PackLayout& layout, const SqueezeOptions& options, const Progress& progress);

  /// Energy of the contacts in the last step, without the walls' pressure.
  double energy() const { return contacts_.energy(); }
  /// How deep any point lay in another shape or a wall in the last step, gaps counted.
  double depth() const { return contacts_.depth(); }
  std::span<const float> depths() const { return contacts_.depths(); }  ///< of each shape

 private:
  void step(PackLayout& layout, const SqueezeOptions& options);

  std::span<const PackShape> shapes_;
  Contacts contacts_;
  double sideInCharts_;              ///< over that of twenty
  std::vector<double> inverseRoot_;  ///< of the mass: three a shape, then the side's
  std::vector<double> force_, velocity_;
  double dt_ = 0, mixing_ = 0;
  int downhill_ = 0;
};

}  // namespace chartflood
