#include "core/session/pipeline/make_report.h"

#include "core/charts/crease_share.h"
#include "core/session/pipeline/run_set.h"
#include "core/session/pipeline/stretch_limit.h"

#include "core/segment/registry.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace chartflood {

namespace {

std::optional<double> timeTaken(double milliseconds) {
  return milliseconds < 0 ? std::nullopt : std::optional(milliseconds);
}

GaussReport gaussReport(const Results& results) {
  GaussReport report;
  if (results.gaussArea) {
    report.total = results.gaussArea->total();
    report.vertices = results.gaussArea->cornerTotal;
    report.edges = results.gaussArea->edgeTotal;
    report.faces = results.gaussArea->triangleTotal;
  }
  if (!results.chartStats) return report;
  const ChartStats& stats = *results.chartStats;
  report.mean = stats.gaussMean;
  report.stdEq3 = stats.gaussStdEq3;
  report.std = stats.gaussStd;
  if (stats.balanceDefined) {
    report.stdOverMean = stats.stdOverMean();
    report.maxOverMean = stats.gaussMaxOverMean;
  }
  return report;
}

ChartReport chartReport(const Mesh& mesh, std::size_t number, const ChartFigures& figures) {
  ChartReport report;
  report.chart = number;
  if (figures.seedFace != kNone) report.seedFace = mesh.inputFace(figures.seedFace);
  report.faces = figures.faces;
  report.area = figures.area;
  report.gaussArea = figures.gaussArea;
  report.perimeter = figures.perimeter;
  report.euler = figures.euler;
  report.boundaryLoops = figures.boundaryLoops;
  report.disk = figures.disk;
  return report;
}

/// Replaces what is known of a chart as segmented by what it is after cutting and unwrapping.
void addFlat(ChartReport& report, const CutChart& chart, const ChartUv& uv, double scale) {
  report.euler = chart.topology.euler;
  report.boundaryLoops = chart.topology.boundaryLoops;
  report.disk = chart.disk();
  report.cutLength = chart.cutLength() * scale;
  if (!uv.uv.empty()) report.distortion = uv.distortion;
}

Spread spreadOf(std::vector<double> values) {
  Spread spread;
  const auto n = static_cast<double>(values.size());
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  for (const double v : values) spread.std += (v - spread.mean) * (v - spread.mean) / n;
  spread.std = std::sqrt(spread.std);
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  spread.median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  spread.max = values.back();
  return spread;
}

std::optional<StretchReport> stretchReport(const std::vector<ChartReport>& charts) {
  StretchReport report;
  std::vector<double> l2, area, angle;
  double surface = 0, squares = 0;
  for (const ChartReport& chart : charts) {
    if (!chart.distortion) continue;
    const Distortion& d = *chart.distortion;
    l2.push_back(d.l2);
    area.push_back(d.area);
    angle.push_back(d.angle);
    surface += chart.area;
    squares += chart.area * d.l2 * d.l2;
    report.linfMax = std::max(report.linfMax, d.linf);
    report.flippedTriangles += d.flipped;
  }
  if (l2.empty()) return std::nullopt;
  report.l2 = spreadOf(std::move(l2));
  report.area = spreadOf(std::move(area));
  report.angle = spreadOf(std::move(angle));
  report.l2AreaWeighted = surface > 0 ? std::sqrt(squares / surface) : report.l2.mean;
  return report;
}

std::vector<IterationReport> historyReport(const Results& results) {
  std::vector<IterationReport> rounds;
  for (const IterationSummary& round : results.history) {
    rounds.push_back({round.iteration,
                      round.balanceDefined ? std::optional(round.stdOverMean) : std::nullopt,
                      round.movedSeeds});
  }
  return rounds;
}

std::vector<RunReport> runReports(const std::shared_ptr<const RunSet>& set) {
  std::vector<RunReport> reports;
  if (!set) return reports;
  for (std::size_t i = 0; i < set->runs.size(); ++i) {
    const Run& run = set->runs[i];
    reports.push_back({run.parameters.rngSeed, run.charts, run.spread, run.seams, run.stretch,
                       run.worst, i == set->chosen});
  }
  return reports;
}

void addCharts(ResultReport& report, const Results& results) {
  const ChartStats& stats = *results.chartStats;
  const double scale = results.mesh->scale();
  double cutLength = 0;
  for (std::size_t c = 0; c < stats.charts.size(); ++c) {
    ChartReport& chart =
        report.perChart.emplace_back(chartReport(*results.mesh, c, stats.charts[c]));
    if (!results.flat) continue;
    addFlat(chart, results.charts->charts[c], results.unwrap->charts[c], scale);
    cutLength += *chart.cutLength;
  }
  report.seamLength = stats.seamLength + cutLength;
  if (stats.surfaceArea > 0) {
    report.seamLengthOverSqrtArea = *report.seamLength / std::sqrt(stats.surfaceArea);
  }
  if (results.gaussArea && !results.gaussArea->sharpEdges.empty()) {
    report.creaseShare =
        creaseShare(*results.mesh, *results.gaussArea, results.segmentation->label);
  }
  if (!results.flat) return;
  report.cutLength = cutLength;
  report.stretch = stretchReport(report.perChart);
  report.packingEfficiency = results.atlas->efficiency;
  report.texelDensity = texelDensity(*results.atlas, *results.mesh);
  const double limit = stretchLimit(results.parameters, results.chartRuns != nullptr);
  for (const Index c : chartsAbove(limit, *results.unwrap)) {
    report.aboveLimit.push_back({c, results.unwrap->charts[c].distortion.l2, limit});
  }
}

ResultReport resultReport(const Results& results) {
  ResultReport report;
  report.method = results.parameters.method;
  report.charts = results.segmentation ? results.segmentation->chartCount : 0;
  if (segmenterOf(report.method).knowsFast && results.segmentation && !results.start.creases) {
    report.search = results.start.fast ? "fast" : "literal";
  }
  report.iterations = results.history.size();
  if (!results.history.empty()) report.bestIteration = results.bestIteration;
  report.stopReason = stopReasonId(results.stopReason);
  report.gaussArea = gaussReport(results);
  report.history = historyReport(results);
  report.seedRuns = runReports(results.seedRuns);
  report.chartRuns = runReports(results.chartRuns);
  if (results.chartStats) addCharts(report, results);
  const Timing& t = results.timing;
  report.timing = {timeTaken(t.read),    timeTaken(t.gaussArea), timeTaken(t.floodGraph),
                   timeTaken(t.segment), timeTaken(t.cut),       timeTaken(t.unwrap),
                   timeTaken(t.pack)};
  return report;
}

}  // namespace

InputReport inputReport(const Mesh& mesh) {
  InputReport report;
  report.file = mesh.input().file;
  report.faces = mesh.input().faceCount();
  report.triangles = mesh.triangleCount();
  report.vertices = mesh.input().positions.size();
  report.components = mesh.componentCount();
  report.boundaryLoops = mesh.boundaryLoopCount();
  report.genus = mesh.genus();
  report.repairs.assign(mesh.repairs().begin(), mesh.repairs().end());
  return report;
}

Report makeReport(const Results& results, const std::vector<Index>& seeds,
                  const std::string& version) {
  Report report;
  report.version = version;
  report.input = inputReport(*results.mesh);
  const Parameters values = inForce(results.parameters, results.features);
  for (const ParameterInfo& info : parameterTable()) {
    report.parameters.emplace_back(info.id, parameterValue(values, info));
  }
  for (const Index seed : seeds) report.seeds.push_back(results.mesh->inputFace(seed));
  report.results.push_back(resultReport(results));
  return report;
}

}  // namespace chartflood
