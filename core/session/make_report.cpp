#include "core/session/make_report.h"

#include <cmath>

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

std::vector<IterationReport> historyReport(const Results& results) {
  std::vector<IterationReport> rounds;
  for (const IterationSummary& round : results.history) {
    rounds.push_back({round.iteration,
                      round.balanceDefined ? std::optional(round.stdOverMean) : std::nullopt,
                      round.movedSeeds});
  }
  return rounds;
}

void addCharts(ResultReport& report, const Mesh& mesh, const ChartStats& stats) {
  for (std::size_t c = 0; c < stats.charts.size(); ++c) {
    report.perChart.push_back(chartReport(mesh, c, stats.charts[c]));
  }
  report.seamLength = stats.seamLength;
  if (stats.surfaceArea > 0) {
    report.seamLengthOverSqrtArea = stats.seamLength / std::sqrt(stats.surfaceArea);
  }
}

ResultReport resultReport(const Results& results) {
  ResultReport report;
  report.method = results.parameters.method;
  report.charts = results.segmentation ? results.segmentation->chartCount : 0;
  report.iterations = results.history.size();
  if (!results.history.empty()) report.bestIteration = results.bestIteration;
  report.stopReason = stopReasonId(results.stopReason);
  report.gaussArea = gaussReport(results);
  report.history = historyReport(results);
  if (results.chartStats) addCharts(report, *results.mesh, *results.chartStats);
  report.timing = {timeTaken(results.timing.read), timeTaken(results.timing.gaussArea),
                   timeTaken(results.timing.floodGraph), timeTaken(results.timing.segment)};
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
  for (const ParameterInfo& info : parameterTable()) {
    report.parameters.emplace_back(info.id, parameterValue(results.parameters, info));
  }
  for (const Index seed : seeds) report.seeds.push_back(results.mesh->inputFace(seed));
  report.results.push_back(resultReport(results));
  return report;
}

}  // namespace chartflood
