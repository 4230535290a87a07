#pragma once
/// How evenly Gauss area is spread over charts (paper equation 3).

#include <span>

namespace chartflood {

/// Figures over the charts' Gauss areas, steradians.
struct Balance {
  double mean = 0;
  double stdEq3 = 0;  ///< sqrt(sum (mean - A_i)^2), as printed: not divided by n
  double std = 0;     ///< sqrt(sum (mean - A_i)^2 / n)
  double max = 0;
  bool defined = false;  ///< mean is at least 1e-9, so that ratios to it mean something

  /// The coefficient of variation, 0 when undefined.
  double stdOverMean() const { return defined ? std / mean : 0; }
};

Balance balanceOf(std::span<const double> chartGaussArea);

}  // namespace chartflood
