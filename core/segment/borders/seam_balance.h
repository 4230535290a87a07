#pragma once
/// The balance term of the seam cuts: what unequal charts cost, and the price of moving Gauss area
/// that follows from it.

#include <algorithm>
#include <span>

namespace chartflood {

/// w * mean over charts of ((B_i - mean) / mean)^2 from running sums; or one-sided, where only
/// charts above a fixed share T of the whole cost: w * mean of (max(0, B_i - T) / T)^2.
struct SeamBalance {
  double weight = 0;
  double charts = 1;
  double share = 0;    ///< T of the one-sided term; 0: two-sided
  double sum = 0;      ///< of B
  double squares = 0;  ///< of B, or of what is above T

  bool oneSided() const { return share > 0; }
  double square(double b) const {
    const double over = oneSided() ? std::max(0.0, b - share) : b;
    return over * over;
  }
  void add(double b) {
    sum += b;
    squares += square(b);
  }
  void remove(double b) {
    sum -= b;
    squares -= square(b);
  }
  double energy() const {
    if (oneSided()) return weight * squares / (charts * share * share);
    const double mean = sum / charts;
    return mean > 1e-12 ? weight * (squares / (charts * mean * mean) - 1) : 0;
  }
  /// How much the price below rises with each unit of B that goes from b to a, where that is the
  /// same everywhere; 0 where it is not.
  double curvature() const {
    const double mean = sum / charts;
    return !oneSided() && mean > 1e-12 ? 4 * weight / (charts * mean * mean) : 0;
  }
  /// What a unit of B costs more in a chart of size a than in one of size b.
  double price(double a, double b) const {
    if (oneSided()) {
      const double over = std::max(0.0, a - share) - std::max(0.0, b - share);
      return 2 * weight * over / (charts * share * share);
    }
    const double mean = sum / charts;
    return mean > 1e-12 ? 2 * weight * (a - b) / (charts * mean * mean) : 0;
  }
};

}  // namespace chartflood
