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
    stats.charts[chart].area = cursor.area(chart);
    stats.charts[chart].faces = cursor.faces(chart);
    stats.surfaceArea += cursor.area(chart);
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
  seams_.reset();
  cursor_.reset();
  stats_.reset();
}

std::span<const Index> MomentCharts::labels() const {
  return cursor_ ? cursor_->labels() : std::span<const Index>{};
}

bool MomentCharts::closedOff(Index chart) const {
  return cursor_ && chart < cursor_->chartCount() && cursor_->faces(chart) > 0 &&
         cursor_->openSides(chart) == 0 && cursor_->step() < cursor_->labels().size();
}

/// Makes a cursor for another mesh; false when there is nothing to stand on.
bool MomentCharts::prepare(const Results& results) {
  if (!results.mesh || !results.gaussArea) {
    clear();
    return false;
  }
  if (results.mesh != mesh_ || results.gaussArea != gauss_ || !cursor_) {
    mesh_ = results.mesh;
    gauss_ = results.gaussArea;
    cursor_ = std::make_unique<FloodCursor>(mesh_, gauss_);
    stats_.reset();
  }
  return true;
}

void MomentCharts::count(std::size_t charts) {
  stats_ = std::make_shared<const ChartStats>(statsOf(*cursor_, charts));
}

void MomentCharts::show(const Results& results, const std::shared_ptr<const FloodRecord>& record,
                        std::size_t step) {
  if (!prepare(results)) return;
  if (stats_ && !seams_ && record == record_ && step == step_) return;
  record_ = record;
  seams_.reset();
  step_ = step;
  cursor_->go(record, step);
  count(std::max(cursor_->chartCount(), record ? results.seeds.size() : 0));
}

void MomentCharts::showBorders(const Results& results, std::size_t step) {
  if (!results.record || !results.seamRecord || !prepare(results)) return;
  const bool same = results.seamRecord == seams_ && results.record == record_;
  if (stats_ && same && step == step_) return;
  record_ = results.record;
  seams_ = results.seamRecord;
  step_ = step;
  if (!same) cursor_->go(record_, record_->size());
  cursor_->refine(seams_, step);
  count(cursor_->chartCount());
}

}  // namespace chartflood
