#pragma once
/// What a face costs in one chart or another, as the method that made the charts sees it: so that
/// shorter seams do not undo what the method was after.

#include <span>

#include "core/base/index.h"

namespace chartflood {

/// Costs in the unit of the seam cuts' energy, seam length over the square root of the area. What
/// charts are judged by, such as a mean normal, rests between two calls of fit().
class ChartPrice {
 public:
  virtual ~ChartPrice() = default;
  /// Fits what the charts are judged by to their faces, where that lowers what they cost.
  virtual void fit(std::span<const Index> label) = 0;
  /// Of a face in a chart: any thread may ask.
  virtual double of(Index face, Index chart) const = 0;

  double total(std::span<const Index> label) const {
    double sum = 0;
    for (Index f = 0; f < label.size(); ++f) sum += of(f, label[f]);
    return sum;
  }
};

}  // namespace chartflood
