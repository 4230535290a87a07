#pragma once
/// Figures of a segmentation: what the report and the chart table show.

#include <cstddef>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// One chart. Lengths and areas in model units, Gauss areas in steradians.
struct ChartFigures {
  Index seedFace = kNone;
  std::size_t faces = 0;
  double area = 0;
  double gaussArea = 0;
  double perimeter = 0;  ///< border sides: against other charts and mesh borders
  long euler = 0;        ///< V - E + F of the chart as a surface of its own
  std::size_t boundaryLoops = 0;
  bool connected = true;
  bool disk = false;  ///< Euler number 1 and one boundary loop
};

struct ChartStats {
  std::vector<ChartFigures> charts;
  double gaussMean = 0;    ///< mean A(c)
  double gaussStdEq3 = 0;  ///< sqrt of the sum of squared differences (paper equation 3)
  double gaussStd = 0;     ///< divides by n first
  double gaussMaxOverMean = 0;
  bool balanceDefined = false;  ///< false when the mean is below 1e-9: ratios are undefined
  double onSeams = 0;           ///< Gauss area of elements that no chart holds
  double seamLength = 0;        ///< edges between two charts, each once, model units
  double surfaceArea = 0;       ///< model units
  /// gaussStd / gaussMean; 0 when balanceDefined is false.
  double stdOverMean() const { return balanceDefined ? gaussStd / gaussMean : 0; }
};

}  // namespace chartflood
