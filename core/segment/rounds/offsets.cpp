#include "core/segment/rounds/offsets.h"

#include <algorithm>

namespace chartflood {

void updateOffsets(std::vector<double>& offsets, std::span<const double> chartGaussArea,
                   double damping) {
  const double smallestArea = *std::min_element(chartGaussArea.begin(), chartGaussArea.end());
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    offsets[i] += damping * (chartGaussArea[i] - smallestArea);
  }
  const double smallest = *std::min_element(offsets.begin(), offsets.end());
  for (double& offset : offsets) offset -= smallest;
}

}  // namespace chartflood
