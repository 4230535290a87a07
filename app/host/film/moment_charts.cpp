#include "app/host/film/moment_charts.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/segment/parts/balance.h"

namespace chartflood {

namespace {

/// Faces taken or given back within one call: some milliseconds.
constexpr std::size_t kStepsAtOnce = 100'000;

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

bool standsOn(const FloodCursor* cursor, const Mesh& mesh, const GaussArea& gauss) {
  return cursor != nullptr && &cursor->measures()->mesh() == &mesh &&
         cursor->measures()->gaussArea().get() == &gauss;
}

}  // namespace

MomentCharts::MomentCharts(WorkPlace place) : place_(std::move(place)) {}

void MomentCharts::clear() {
  shown_ = {};
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

void MomentCharts::show(const Results& results, const std::shared_ptr<const FloodRecord>& record,
                        std::size_t step) {
  go({results.mesh, results.gaussArea, record, nullptr, step,
      record ? results.start.seeds.size() : 0});
}

void MomentCharts::showBorders(const Results& results, std::size_t step) {
  if (!results.record || !results.seamRecord) return;
  go({results.mesh, results.gaussArea, results.record, results.seamRecord, step, 0});
}

void MomentCharts::go(const Moment& wanted) {
  if (!wanted.mesh || !wanted.gauss) return clear();
  take(wanted.mesh);
  if (stats_ && shown_ == wanted) return;
  if (place_.immediate || isNear(wanted)) {
    Arrival here = arrive(wanted, std::move(cursor_));
    cursor_ = std::move(here.cursor);
    stats_ = std::move(here.stats);
    shown_ = wanted;
    return;
  }
  if (errand_.running()) return;
  const bool here = standsOn(cursor_.get(), *wanted.mesh, *wanted.gauss);
  if (here && !standsOn(spare_.get(), *wanted.mesh, *wanted.gauss)) {
    spare_ = std::make_unique<FloodCursor>(cursor_->measures());
  }
  errand_.begin(place_.wake, [wanted, cursor = std::move(spare_)]() mutable {
    return arrive(wanted, std::move(cursor));
  });
}

/// True when the way from the moment shown is short enough for a pass of the window.
bool MomentCharts::isNear(const Moment& wanted) const {
  const std::size_t faces = wanted.mesh->faceCount();
  if (faces <= kStepsAtOnce) return true;
  if (!standsOn(cursor_.get(), *wanted.mesh, *wanted.gauss)) return false;
  if (cursor_->record() != wanted.record) return false;
  const auto apart = [](std::size_t a, std::size_t b) { return a < b ? b - a : a - b; };
  if (!wanted.seams && !shown_.seams) return apart(wanted.step, shown_.step) <= kStepsAtOnce;
  if (wanted.seams != shown_.seams) return false;
  const auto& steps = wanted.seams->steps;
  const auto end = [&](std::size_t step) {
    return step == 0 ? 0 : steps[std::min(step, steps.size()) - 1].end;
  };
  return apart(end(wanted.step), end(shown_.step)) <= kStepsAtOnce;
}

/// Takes over what has arrived, unless it is another mesh by now.
void MomentCharts::take(const std::shared_ptr<const Mesh>& mesh) {
  std::optional<Arrival> there = errand_.take();
  if (!there || there->moment.mesh != mesh) return;
  spare_ = std::move(cursor_);
  cursor_ = std::move(there->cursor);
  stats_ = std::move(there->stats);
  shown_ = std::move(there->moment);
}

MomentCharts::Arrival MomentCharts::arrive(const Moment& wanted,
                                           std::unique_ptr<FloodCursor> cursor) {
  if (!standsOn(cursor.get(), *wanted.mesh, *wanted.gauss)) {
    cursor = std::make_unique<FloodCursor>(
        std::make_shared<const FloodMeasures>(wanted.mesh, wanted.gauss));
  }
  if (!wanted.seams) {
    cursor->go(wanted.record, wanted.step);
  } else {
    if (cursor->record() != wanted.record || cursor->step() != wanted.record->size()) {
      cursor->go(wanted.record, wanted.record->size());
    }
    cursor->refine(wanted.seams, wanted.step);
  }
  auto stats = std::make_shared<const ChartStats>(
      statsOf(*cursor, std::max(cursor->chartCount(), wanted.charts)));
  return {wanted, std::move(cursor), std::move(stats)};
}

}  // namespace chartflood
