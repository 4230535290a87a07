#pragma once
/// Parts the charts of a pressed layout exactly: to the last corner of their outlines.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/pack/free_space.h"
#include "core/pack/gap_check.h"
#include "core/pack/pack_shape.h"

namespace chartflood {

/// Share of the largest scale that a layout of upright charts may have and still be taken.
inline constexpr double kUprightWorth = 0.997;

/// A layout in the texture, exact.
struct Fitted {
  double scale = 0;  ///< texture units per unit of the charts' plane; 0: the charts are not apart
  std::vector<PlacedOutline> charts;
};

/// Moves charts a little, and those that stay stuck in others or have no place yet into free
/// places, until all are apart. Reads the shapes and outlines, which must live as long as the
/// object does.
class Parting {
 public:
  /// \param layoutScale layout units per unit of the charts' plane, as the shapes have them
  /// \param leastScale the work is given up below it
  Parting(std::span<const PackShape> shapes, double layoutScale, double leastScale,
          const PackGaps& gaps, const Progress& progress)
      : shapes_(shapes), layoutScale_(layoutScale), leastScale_(leastScale), gaps_(gaps),
        progress_(progress) {}

  /// \param fitted charts at a scale at which they are nearly apart; crumbs wherever they are
  /// \param crumbs from which chart on all are put into any free places
  /// \param hanging others that should have another place
  void part(Fitted& fitted, std::size_t crumbs, std::vector<std::size_t> hanging) const;

  /// Boxes that lie nearly upright are turned to lie so exactly, unless that costs much.
  void makeUpright(Fitted& fitted) const;

 private:
  void settleSomehow(Fitted& fitted, std::size_t count) const;
  bool settleFirst(Fitted& fitted, std::size_t count, int steps,
                   std::vector<std::size_t>& stuck) const;
  bool replaceStuck(Fitted& fitted, std::size_t count, std::vector<std::size_t> stuck) const;
  void placeCrumbs(Fitted& fitted, std::size_t crumbs) const;
  FreeSpace spaceAround(const Fitted& fitted, std::size_t count, double cells) const;
  bool tryPlace(Fitted& fitted, std::size_t chart, int turns, FreeSpace& space) const;
  void largeFirst(std::vector<std::size_t>& charts) const;

  std::span<const PackShape> shapes_;
  double layoutScale_, leastScale_;
  PackGaps gaps_;
  const Progress& progress_;
};

}  // namespace chartflood
