#include "core/segment/parts/part_shares.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/segment/parts/chart_areas.h"

namespace chartflood {

namespace {

// Of the area that a chart has on average:
constexpr double kCrumb = 0.04;           // less is a crumb
constexpr double kSmallPart = 0.25;       // less is small where parts outnumber charts
constexpr double kSmallestChart = 0.125;  // least of a chart of a part that gets several
constexpr double kNoGauss = 1e-6;         // steradians that are none

/// Share of each part in the surface; of faces where there is no area.
std::vector<double> surfaceShares(const Mesh& mesh) {
  std::vector<double> share(mesh.componentCount(), 0);
  const auto part = mesh.faceComponent();
  const bool area = mesh.surfaceArea() > 0;
  for (Index f = 0; f < part.size(); ++f) {
    if (!area) share[part[f]] += 1.0 / static_cast<double>(part.size());
    for (Index t = mesh.triangleBegin(f); area && t < mesh.triangleBegin(f + 1); ++t) {
      share[part[f]] += mesh.triangleArea()[t] / mesh.surfaceArea();
    }
  }
  return share;
}

/// Counts charts for any number that is asked for.
class PartCounter {
 public:
  explicit PartCounter(std::vector<double> share) : share_(std::move(share)), sum_(1, 0) {
    std::sort(share_.begin(), share_.end());
    for (const double s : share_) sum_.push_back(sum_.back() + s);
  }

  /// Parts with less of the surface than so many of the charts' mean areas.
  std::size_t smaller(double charts, std::size_t asked) const {
    const double least = charts / static_cast<double>(asked);
    return static_cast<std::size_t>(std::lower_bound(share_.begin(), share_.end(), least) -
                                    share_.begin());
  }
  std::size_t small(std::size_t asked) const {
    return smaller(asked < share_.size() ? kSmallPart : kCrumb, asked);
  }
  /// What this very number comes to.
  std::size_t at(std::size_t asked) const {
    const std::size_t crumbs = smaller(kCrumb, asked), small = this->small(asked);
    const std::size_t bodies = share_.size() - small;
    if (bodies == 0) return small;
    const double left = static_cast<double>(asked) * (1 - (sum_[small] - sum_[crumbs]));
    // A hair less, so that rounding does not add a chart.
    const auto wanted = static_cast<std::size_t>(std::ceil(std::max(0.0, left - 1e-9)));
    return small + std::max(bodies, wanted);
  }
  /// The most of this and all smaller numbers: between those where a part stops being small, more
  /// charts come from asking for more.
  PartCount upTo(std::size_t asked) const {
    PartCount best{std::max(asked, at(asked)), share_.size(), small(asked)};
    const auto offer = [&](double number) {
      if (!(number >= 1) || !(number < static_cast<double>(asked))) return;
      const auto fewer = static_cast<std::size_t>(number);
      if (const std::size_t charts = at(fewer); charts > best.charts) {
        best = {charts, share_.size(), small(fewer)};
      }
    };
    offer(static_cast<double>(share_.size()) - 1);
    for (std::size_t i = 0; i < share_.size(); ++i) {
      if (i > 0 && share_[i] == share_[i - 1]) continue;
      for (const double limit : {kCrumb, kSmallPart}) offer(std::ceil(limit / share_[i]) - 1);
    }
    return best;
  }

 private:
  std::vector<double> share_;  ///< ascending
  std::vector<double> sum_;    ///< of the first so many
};

}  // namespace

PartCount countWithParts(const Mesh& mesh, std::size_t asked) {
  asked = std::max<std::size_t>(asked, 1);
  PartCount count{asked, mesh.componentCount(), 0};
  if (count.parts > 1) count = PartCounter(surfaceShares(mesh)).upTo(asked);
  count.charts = std::min(std::max(count.charts, count.parts), mesh.faceCount());
  return count;
}

PartShares partShares(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
                      double eta, std::size_t asked) {
  const auto part = mesh.faceComponent();
  PartShares shares;
  shares.weight = chartAreas(mesh, gauss, faceGauss, part, mesh.componentCount()).gaussArea;
  shares.most.assign(shares.weight.size(), std::numeric_limits<std::size_t>::max());
  if (shares.weight.size() < 2) return shares;
  const std::vector<double> surface = surfaceShares(mesh);
  for (std::size_t p = 0; p < surface.size(); ++p) {
    const double room = surface[p] * static_cast<double>(asked) / kSmallestChart;
    const bool one = room < 2 || shares.weight[p] < kNoGauss;
    shares.most[p] = one ? 1 : static_cast<std::size_t>(std::min(room, 1e15));
    shares.weight[p] += eta * mesh.surfaceArea() * surface[p];
  }
  return shares;
}

}  // namespace chartflood
