#include "app/host/insight/insight.h"

#include <algorithm>
#include <mutex>

#include "core/gauss/sector_normals.h"

namespace chartflood {

namespace {

constexpr std::size_t kMostDots = 2500;

bool labelled(const Results& results) {
  return results.mesh && results.segmentation &&
         results.segmentation->label.size() == results.mesh->faceCount();
}

}  // namespace

/// Outlives the Insight where a thread still holds it.
struct Insight::Waker {
  std::mutex mutex;
  std::function<void()> wake;
};

Insight::Insight(bool immediate) : waker_(std::make_shared<Waker>()) {
  place_.immediate = immediate;
  place_.wake = [waker = waker_] {
    const std::scoped_lock lock(waker->mutex);
    if (waker->wake) waker->wake();
  };
}

std::unique_ptr<Insight> Insight::beside() const {
  auto other = std::make_unique<Insight>(place_.immediate);
  other->waker_ = waker_;
  other->place_ = place_;
  return other;
}

void Insight::setWake(std::function<void()> wake) {
  const std::scoped_lock lock(waker_->mutex);
  waker_->wake = std::move(wake);
}

std::shared_ptr<const SurfaceDerived> Insight::surface(const Results& results) {
  if (!results.mesh || !results.gaussArea) return nullptr;
  if (results.gaussArea->triangle.size() != results.mesh->triangleCount()) return nullptr;
  auto value =
      surface_.get(results.gaussArea, place_, [mesh = results.mesh, gaussArea = results.gaussArea] {
        CornerNormals normals = computeCornerNormals(*mesh, gaussArea->sharpAngle);
        auto vertices = surfaceVertices(*mesh, &normals);
        return SurfaceDerived{mesh, gaussArea, std::move(normals), std::move(vertices),
                              std::make_shared<const GaussValues>(gaussValues(*mesh, *gaussArea))};
      });
  return value && value->mesh == results.mesh ? value : nullptr;
}

std::shared_ptr<const TriangleTree> Insight::tree(const Results& results) {
  if (!results.mesh) return nullptr;
  auto value =
      trees_.get(results.mesh, place_, [mesh = results.mesh] { return TriangleTree(mesh); });
  return value && value->mesh() == results.mesh ? value : nullptr;
}

Insight::ProblemKey Insight::problemKey(const Results& results) {
  return {results.segmentation, results.chartStats, results.gaussArea, results.atlas, results.flat};
}

bool Insight::sameProblems(const Results& one, const Results& other) {
  return problemKey(one) == problemKey(other);
}

std::shared_ptr<const Insight::ProblemReport> Insight::problemReport(const Results& results) {
  if (!labelled(results) || !results.chartStats) return nullptr;
  return problems_.get(problemKey(results), place_, [results] {
    std::vector<Problem> problems = findProblems(results);
    SurfaceMarks marks = chartflood::problemMarks(*results.mesh, *results.segmentation, problems);
    return ProblemReport{results.segmentation, std::move(problems), std::move(marks)};
  });
}

std::shared_ptr<const std::vector<Problem>> Insight::problems(const Results& results) {
  const auto report = problemReport(results);
  if (!report) return nullptr;
  return {report, &report->problems};
}

std::shared_ptr<const SurfaceMarks> Insight::problemMarks(const Results& results) {
  const auto report = problemReport(results);
  if (!report || report->segmentation != results.segmentation) return nullptr;
  return {report, &report->marks};
}

std::shared_ptr<const std::vector<ModeHistogram>>
Insight::histograms(const Results& results, const ShownMoment& moment,
                    const RenderSettings& settings) {
  const auto derived = surface(results);
  ModeSource source;
  source.mesh = results.mesh;
  if (derived) source.gauss = derived->gaussValues;
  source.stats = moment.stats;
  source.unwrap = results.unwrap;
  source.record = moment.record;
  source.recorded = moment.record ? moment.record->size() : 0;
  source.taken = std::min(moment.taken, source.recorded);
  source = neededBy(settings.colorMode, source);
  const HistogramKey key{source, settings.colorMode, settings.scale, settings.range};
  return histograms_.get(key, place_, [source = std::move(source), settings] {
    return modeHistograms(source, settings);
  });
}

std::shared_ptr<const SpherePatch> Insight::patch(const Results& results, Index chart) {
  const auto derived = surface(results);
  if (!derived || !labelled(results) || chart >= results.segmentation->chartCount) return nullptr;
  const auto labels = results.segmentation;
  const auto value = patch_.get({derived, labels, chart}, place_, [derived, labels, chart] {
    return OwnedPatch{derived, labels,
                      std::make_shared<const SpherePatch>(spherePatch(*derived, *labels, chart))};
  });
  const bool present = value && value->surface == derived && value->segmentation == labels &&
                       value->patch->chart == chart;
  return present ? value->patch : nullptr;
}

std::shared_ptr<const std::vector<SphereDot>> Insight::dots(const Results& results) {
  const auto derived = surface(results);
  if (!derived) return nullptr;
  return dots_.get(derived, place_, [derived] { return sphereDots(*derived, kMostDots); });
}

}  // namespace chartflood
