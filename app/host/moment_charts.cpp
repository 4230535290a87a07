#include "app/host/moment_charts.h"

#include <algorithm>
#include <vector>

#include "core/segment/balance.h"

namespace chartflood {

namespace {

ChartStats statsOf(const FloodCursor& cursor, std::size_t charts) {
  ChartStats stats;
  std::vector<double> areas(charts, 0);
  stats.charts.resize(charts);
  for (std::size_t chart = 0; chart < std::min(charts, cursor.chartCount()); ++chart) {
    areas[chart] = stats.charts[chart].gaussArea = cursor.gaussArea(chart);
    stats.charts[chart].faces = cursor.faces(chart);
  }
  const Balance balance = balanceOf(areas);
  stats.gaussMean = balance.mean;
  stats.gaussStdEq3 = balance.stdEq3;
  stats.gaussStd = balance.std;
  stats.gaussMaxOverMean = balance.defined ? balance.max / balance.mean : 0;
  stats.balanceDefined = balance.defined;
  return stats;
}

}  // namespace

void MomentCharts::clear() {
  mesh_.reset();
  gauss_.reset();
  record_.reset();
  cursor_.reset();
  stats_.reset();
}

std::span<const Index> MomentCharts::labels() const {
  return cursor_ ? cursor_->labels() : std::span<const Index>{};
}

bool MomentCharts::closedOff(Index chart) const {
  return cursor_ && chart < cursor_->chartCount() && cursor_->faces(chart) > 0 &&
         cursor_->openSides(chart) == 0 && step_ < cursor_->labels().size();
}

void MomentCharts::show(const Results& results, const std::shared_ptr<const FloodRecord>& record,
                        std::size_t step) {
  if (!results.mesh || !results.gaussArea) return clear();
  if (results.mesh != mesh_ || results.gaussArea != gauss_ || !cursor_) {
    mesh_ = results.mesh;
    gauss_ = results.gaussArea;
    cursor_ = std::make_unique<FloodCursor>(mesh_, gauss_);
    stats_.reset();
  }
  if (stats_ && record == record_ && step == step_) return;
  record_ = record;
  step_ = step;
  cursor_->go(record, step);
  const std::size_t charts = std::max(cursor_->chartCount(), record ? results.seeds.size() : 0);
  stats_ = std::make_shared<const ChartStats>(statsOf(*cursor_, charts));
}

}  // namespace chartflood
