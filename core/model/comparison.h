#pragma once
/// Methods side by side: the figures of tables 1 and 2 of the paper, for one division each.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace chartflood {

/// One method's charts with one way to finish their borders.
struct ComparisonRow {
  std::string method;
  bool alike = false;  ///< borders finished in the same way for all methods; else as it leaves them
  std::size_t charts = 0;
  double gaussStdEq3 = 0;                  ///< table 2, steradians
  std::optional<double> gaussStdOverMean;  ///< stdEq3 over the mean; absent when that is too small
  /// L2 stretch with charts on circles, each chart counting the same (table 1).
  double circleMean = 0, circleStd = 0, circleMedian = 0, circleMax = 0;
  double freeMean = 0, freeMax = 0;   ///< the same with free outlines
  double seamLengthOverSqrtArea = 0;  ///< borders and cuts
  double cutShare = 0;                ///< of that length
  double segmentMilliseconds = 0;     ///< elapsed, borders included
};

}  // namespace chartflood
