#include "core/segment/parts/balance.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

Balance balanceOf(std::span<const double> chartGaussArea) {
  Balance b;
  if (chartGaussArea.empty()) return b;
  const double n = static_cast<double>(chartGaussArea.size());
  for (const double a : chartGaussArea) {
    b.mean += a / n;
    b.max = std::max(b.max, a);
  }
  double squares = 0;
  for (const double a : chartGaussArea) squares += (b.mean - a) * (b.mean - a);
  b.stdEq3 = std::sqrt(squares);
  b.std = std::sqrt(squares / n);
  b.defined = b.mean >= 1e-9;
  return b;
}

}  // namespace chartflood
