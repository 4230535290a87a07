#include "core/io/write/write_report.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace chartflood {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

template <typename T>
Json whole(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json inputJson(const InputReport& input) {
  Json repairs = Json::array();
  for (const Repair& repair : input.repairs) {
    repairs.push_back({{"what", repair.what}, {"count", repair.count}, {"text", repair.text}});
  }
  return {{"file", input.file},
          {"faces", input.faces},
          {"triangles", input.triangles},
          {"vertices", input.vertices},
          {"components", input.components},
          {"boundary_loops", input.boundaryLoops},
          {"genus", input.genus},
          {"repairs", std::move(repairs)}};
}

Json parametersJson(const Report& report) {
  Json values = Json::object();
  for (const auto& [id, value] : report.parameters) {
    values[id] = std::visit([](const auto& v) { return Json(v); }, value);
  }
  if (!report.seeds.empty()) values["seeds"] = report.seeds;
  return values;
}

Json gaussJson(const GaussReport& gauss) {
  return {{"total", number(gauss.total)},
          {"vertices", number(gauss.vertices)},
          {"edges", number(gauss.edges)},
          {"faces", number(gauss.faces)},
          {"mean", number(gauss.mean)},
          {"std_eq3", number(gauss.stdEq3)},
          {"std", number(gauss.std)},
          {"std_over_mean", number(gauss.stdOverMean)},
          {"max_over_mean", number(gauss.maxOverMean)}};
}

Json historyJson(const std::vector<IterationReport>& history) {
  Json rounds = Json::array();
  for (const IterationReport& round : history) {
    rounds.push_back({{"iteration", round.iteration},
                      {"std_over_mean", number(round.stdOverMean)},
                      {"moved_seeds", round.movedSeeds}});
  }
  return rounds;
}

/// Figures of the unwrap are null for a chart that is not laid flat.
Json chartJson(const ChartReport& chart) {
  const auto figure = [&](double Distortion::*member) {
    return chart.distortion ? number(*chart.distortion.*member) : Json(nullptr);
  };
  return {{"chart", chart.chart},
          {"seed_face", whole(chart.seedFace)},
          {"faces", chart.faces},
          {"area", number(chart.area)},
          {"gauss_area", number(chart.gaussArea)},
          {"perimeter", number(chart.perimeter)},
          {"euler", chart.euler},
          {"boundary_loops", chart.boundaryLoops},
          {"disk", chart.disk},
          {"cut_length", number(chart.cutLength)},
          {"l2_stretch", figure(&Distortion::l2)},
          {"linf_stretch", figure(&Distortion::linf)},
          {"area_distortion", figure(&Distortion::area)},
          {"angle_distortion", figure(&Distortion::angle)},
          {"flipped", chart.distortion ? Json(chart.distortion->flipped) : Json(nullptr)},
          {"triangles_without_area",
           chart.distortion ? Json(chart.distortion->shapeless) : Json(nullptr)}};
}

/// A figure over all charts, null where no chart is laid flat.
template <class Figure>
Json over(const ResultReport& result, Figure figure) {
  return result.stretch ? Json(figure(*result.stretch)) : Json(nullptr);
}

Json stretchJson(const ResultReport& result) {
  using S = StretchReport;
  return {{"l2_mean", over(result, [](const S& s) { return s.l2.mean; })},
          {"l2_std", over(result, [](const S& s) { return s.l2.std; })},
          {"l2_median", over(result, [](const S& s) { return s.l2.median; })},
          {"l2_max", over(result, [](const S& s) { return s.l2.max; })},
          {"l2_area_weighted", over(result, [](const S& s) { return s.l2AreaWeighted; })},
          {"linf_max", over(result, [](const S& s) { return s.linfMax; })}};
}

Json timingJson(const TimingReport& timing) {
  return {{"read", number(timing.read)},
          {"gauss_area", number(timing.gaussArea)},
          {"flood_graph", number(timing.floodGraph)},
          {"segment", number(timing.segment)},
          {"cut", number(timing.cut)},
          {"unwrap", number(timing.unwrap)},
          {"pack", number(timing.pack)}};
}

Json comparisonJson(const ComparisonRow& row) {
  return {{"method", row.method},
          {"borders", row.alike ? "alike" : "as-left"},
          {"charts", row.charts},
          {"gauss_std_eq3", number(row.gaussStdEq3)},
          {"gauss_std_eq3_over_mean", number(row.gaussStdOverMean)},
          {"circle_l2_mean", number(row.circleMean)},
          {"circle_l2_std", number(row.circleStd)},
          {"circle_l2_median", number(row.circleMedian)},
          {"circle_l2_max", number(row.circleMax)},
          {"free_l2_mean", number(row.freeMean)},
          {"free_l2_max", number(row.freeMax)},
          {"seam_length_over_sqrt_area", number(row.seamLengthOverSqrtArea)},
          {"cut_share", number(row.cutShare)},
          {"segment_ms", number(row.segmentMilliseconds)}};
}

Json runsJson(const std::vector<RunReport>& runs) {
  Json json = Json::array();
  for (const RunReport& run : runs) {
    json.push_back({{"rng_seed", run.rngSeed},
                    {"charts", run.charts},
                    {"std_over_mean", number(run.stdOverMean)},
                    {"seam_length_over_sqrt_area", number(run.seamLengthOverSqrtArea)},
                    {"l2_area_weighted", number(run.l2AreaWeighted)},
                    {"l2_max", number(run.l2Max)},
                    {"chosen", run.chosen}});
  }
  return json;
}

/// In the charts that are laid flat.
Json trianglesWithoutArea(const ResultReport& result) {
  if (!result.stretch) return nullptr;
  std::size_t sum = 0;
  for (const ChartReport& chart : result.perChart) {
    if (chart.distortion) sum += chart.distortion->shapeless;
  }
  return sum;
}

Json aboveLimitJson(const std::vector<AboveLimit>& charts) {
  Json json = Json::array();
  for (const AboveLimit& chart : charts) {
    json.push_back(
        {{"chart", chart.chart}, {"l2_stretch", number(chart.l2)}, {"limit", number(chart.limit)}});
  }
  return json;
}

Json resultJson(const ResultReport& result) {
  using S = StretchReport;
  Json charts = Json::array();
  for (const ChartReport& chart : result.perChart) charts.push_back(chartJson(chart));
  return {{"method", result.method},
          {"search", result.search ? Json(*result.search) : Json(nullptr)},
          {"charts", result.charts},
          {"iterations", result.iterations},
          {"best_iteration", whole(result.bestIteration)},
          {"stop_reason", result.stopReason},
          {"gauss_area", gaussJson(result.gaussArea)},
          {"stretch", stretchJson(result)},
          {"angle_distortion_mean", over(result, [](const S& s) { return s.angle.mean; })},
          {"angle_distortion_median", over(result, [](const S& s) { return s.angle.median; })},
          {"angle_distortion_max", over(result, [](const S& s) { return s.angle.max; })},
          {"area_distortion_mean", over(result, [](const S& s) { return s.area.mean; })},
          {"area_distortion_median", over(result, [](const S& s) { return s.area.median; })},
          {"area_distortion_max", over(result, [](const S& s) { return s.area.max; })},
          {"flipped_triangles", over(result, [](const S& s) { return s.flippedTriangles; })},
          {"triangles_without_area", trianglesWithoutArea(result)},
          {"seam_length", number(result.seamLength)},
          {"seam_length_over_sqrt_area", number(result.seamLengthOverSqrtArea)},
          {"cut_length", number(result.cutLength)},
          {"crease_share", number(result.creaseShare)},
          {"packing_efficiency", number(result.packingEfficiency)},
          {"texel_density", number(result.texelDensity)},
          {"above_limit", aboveLimitJson(result.aboveLimit)},
          {"history", historyJson(result.history)},
          {"seed_runs", runsJson(result.seedRuns)},
          {"chart_runs", runsJson(result.chartRuns)},
          {"per_chart", std::move(charts)},
          {"timing_ms", timingJson(result.timing)}};
}

}  // namespace

std::string reportText(const Report& report) {
  Json results = Json::array();
  for (const ResultReport& result : report.results) results.push_back(resultJson(result));
  Json json = {{"chartflood", report.version},
               {"input", inputJson(report.input)},
               {"parameters", parametersJson(report)},
               {"results", std::move(results)},
               {"peak_memory_bytes", report.peakMemoryBytes}};
  if (!report.comparison.empty()) {
    json["comparison"] = Json::array();
    for (const ComparisonRow& row : report.comparison) {
      json["comparison"].push_back(comparisonJson(row));
    }
  }
  // A file name need not be UTF-8, JSON must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace chartflood
