#include "core/segment/offset_steps.h"

#include <algorithm>
#include <numeric>

namespace chartflood {

namespace {

// Shares of the surplus; measured on what is left of the spread after eight rounds.
constexpr double kFirstShare = 0.8, kLeastShare = 0.2, kMostShare = 3;
constexpr double kGrowth = 1.3, kShrinkage = 0.5;

}  // namespace

void OffsetSteps::update(std::vector<double>& offsets, std::span<const double> chartGauss) {
  const double count = static_cast<double>(chartGauss.size());
  const double mean = std::accumulate(chartGauss.begin(), chartGauss.end(), 0.0) / count;
  steps_.resize(offsets.size(), {kFirstShare});
  for (std::size_t c = 0; c < offsets.size(); ++c) {
    Step& step = steps_[c];
    const double surplus = chartGauss[c] - mean;
    if (step.surplus * surplus > 0) step.share = std::min(kMostShare, kGrowth * step.share);
    if (step.surplus * surplus < 0) step.share = std::max(kLeastShare, kShrinkage * step.share);
    step.surplus = surplus;
    offsets[c] += step.share * surplus;
  }
  const double smallest = *std::min_element(offsets.begin(), offsets.end());
  for (double& offset : offsets) offset -= smallest;
}

}  // namespace chartflood
