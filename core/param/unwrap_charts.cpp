#include "core/param/unwrap_charts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/param/unwrap_chart.h"

namespace chartflood {

namespace {

/// Numbers of the charts, those with most triangles first: threads that take them in this order end
/// at about the same time.
std::vector<Index> largestFirst(const ChartSet& set) {
  std::vector<Index> order(set.charts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return set.charts[a].surface.triangleCount() > set.charts[b].surface.triangleCount();
  });
  return order;
}

void storeTriangles(const ChartSurface& surface, std::span<const TriangleDistortion> triangles,
                    Unwrap& unwrap) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Index at = surface.meshTriangle[t];
    unwrap.stretch[at] = static_cast<float>(triangles[t].l2);
    unwrap.area[at] = static_cast<float>(std::log2(triangles[t].areaRatio));
    unwrap.angle[at] = static_cast<float>(triangles[t].angle);
  }
}

}  // namespace

UnwrapResult unwrapCharts(const Mesh& mesh, const std::shared_ptr<const ChartSet>& charts,
                          const UnwrapOptions& options, Progress& progress) {
  CF_CHECK(charts != nullptr);
  progress.beginPhase("Unwrapping");
  auto set = std::make_shared<ChartSet>(*charts);
  auto unwrap = std::make_shared<Unwrap>();
  unwrap->charts.resize(set->charts.size());
  for (std::vector<float>* values : {&unwrap->stretch, &unwrap->area, &unwrap->angle}) {
    values->assign(mesh.triangleCount(), std::numeric_limits<float>::quiet_NaN());
  }
  const std::vector<Index> order = largestFirst(*set);
  std::atomic<std::size_t> done{0};
  const auto total = static_cast<float>(std::max<std::size_t>(1, mesh.triangleCount()));
  parallelFor(order.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    FlatChart flat = unwrapChart(set->charts[order[i]], options, progress);
    if (progress.cancelled()) return;
    if (flat.relieved) set->charts.put(order[i], *std::move(flat.relieved));
    const CutChart& chart = set->charts[order[i]];
    storeTriangles(chart.surface, flat.triangles, *unwrap);
    unwrap->charts[order[i]] = std::move(flat.chart);
    done += chart.surface.triangleCount();
    progress.setFraction(static_cast<float>(done) / total);
  });
  if (progress.cancelled()) return {};
  return {std::move(set), std::move(unwrap)};
}

}  // namespace chartflood
