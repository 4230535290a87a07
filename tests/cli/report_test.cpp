// The report file: every key, its type, and figures that can be checked from outside.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>

#include "tests/support/run_program.h"

namespace chartflood {
namespace {

using nlohmann::json;

std::set<std::string> keysOf(const json& object) {
  std::set<std::string> keys;
  for (const auto& item : object.items()) keys.insert(item.key());
  return keys;
}

json reportOf(std::vector<std::string> words) {
  const TemporaryFolder folder;
  words.insert(words.begin(), CHARTFLOOD_PROGRAM);
  words.push_back("--report=-");
  const ProgramRun done = runProgramIn(folder.path(), words);
  EXPECT_EQ(done.exitCode, 0) << done.errors;
  return json::parse(done.output, nullptr, false);
}

TEST(Report, HasEveryKeyOfTheFormat) {
  const json report = reportOf({"--sample=rocket", "--triangles=4000", "--charts=6"});
  using Keys = std::set<std::string>;
  EXPECT_EQ(keysOf(report),
            (Keys{"chartflood", "input", "parameters", "results", "peak_memory_bytes"}));
  EXPECT_EQ(keysOf(report["input"]), (Keys{"file", "faces", "triangles", "vertices", "components",
                                           "boundary_loops", "genus", "repairs"}));
  ASSERT_EQ(report["results"].size(), 1u);
  const json& result = report["results"][0];
  EXPECT_EQ(keysOf(result), (Keys{"method",
                                  "charts",
                                  "iterations",
                                  "best_iteration",
                                  "stop_reason",
                                  "gauss_area",
                                  "stretch",
                                  "angle_distortion_mean",
                                  "angle_distortion_median",
                                  "angle_distortion_max",
                                  "area_distortion_mean",
                                  "area_distortion_median",
                                  "area_distortion_max",
                                  "flipped_triangles",
                                  "seam_length",
                                  "seam_length_over_sqrt_area",
                                  "cut_length",
                                  "crease_share",
                                  "packing_efficiency",
                                  "texel_density",
                                  "above_limit",
                                  "history",
                                  "seed_runs",
                                  "chart_runs",
                                  "per_chart",
                                  "search",
                                  "triangles_without_area",
                                  "timing_ms"}));
  EXPECT_EQ(keysOf(result["gauss_area"]),
            (Keys{"total", "vertices", "edges", "faces", "mean", "std_eq3", "std", "std_over_mean",
                  "max_over_mean"}));
  EXPECT_EQ(keysOf(result["stretch"]),
            (Keys{"l2_mean", "l2_std", "l2_median", "l2_max", "l2_area_weighted", "linf_max"}));
  EXPECT_EQ(keysOf(result["timing_ms"]),
            (Keys{"read", "gauss_area", "flood_graph", "segment", "cut", "unwrap", "pack"}));
  ASSERT_FALSE(result["history"].empty());
  EXPECT_EQ(keysOf(result["history"][0]), (Keys{"iteration", "std_over_mean", "moved_seeds"}));
  ASSERT_EQ(result["per_chart"].size(), 6u);
  EXPECT_EQ(keysOf(result["per_chart"][0]),
            (Keys{"chart", "seed_face", "faces", "area", "gauss_area", "perimeter", "euler",
                  "boundary_loops", "disk", "cut_length", "l2_stretch", "linf_stretch",
                  "area_distortion", "angle_distortion", "flipped", "triangles_without_area"}));
}

/// Calls `visit` for every number below.
void forEachNumber(const json& value, const std::function<void(double)>& visit) {
  if (value.is_number()) visit(value.get<double>());
  if (value.is_structured()) {
    for (const json& child : value) forEachNumber(child, visit);
  }
}

TEST(Report, NumbersAreFiniteAndAddUp) {
  const json report = reportOf({"--sample=double-torus", "--charts=7"});
  std::size_t count = 0;
  forEachNumber(report, [&](double value) {
    EXPECT_TRUE(std::isfinite(value));
    ++count;
  });
  EXPECT_GT(count, 100u);
  const json& result = report["results"][0];
  const json& gauss = result["gauss_area"];
  EXPECT_NEAR(gauss["total"].get<double>(),
              gauss["vertices"].get<double>() + gauss["edges"].get<double>() +
                  gauss["faces"].get<double>(),
              1e-9);
  EXPECT_GE(gauss["total"].get<double>(), 4 * std::numbers::pi - 1e-6);
  double sum = 0, squares = 0, faces = 0, perimeter = 0, cuts = 0, surface = 0, stretched = 0;
  for (const json& chart : result["per_chart"]) {
    sum += chart["gauss_area"].get<double>();
    faces += chart["faces"].get<double>();
    perimeter += chart["perimeter"].get<double>();
    EXPECT_EQ(chart["euler"], 1);
    EXPECT_EQ(chart["boundary_loops"], 1);
    EXPECT_EQ(chart["disk"], true);
    EXPECT_EQ(chart["flipped"], 0);
    const double area = chart["area"].get<double>(), l2 = chart["l2_stretch"].get<double>();
    EXPECT_GE(l2, 1 - 1e-9);
    EXPECT_LE(l2, chart["linf_stretch"].get<double>());
    EXPECT_GE(chart["angle_distortion"].get<double>(), 1 - 1e-9);
    EXPECT_GE(chart["area_distortion"].get<double>(), 1 - 1e-9);
    cuts += chart["cut_length"].get<double>();
    surface += area;
    stretched += area * l2 * l2;
  }
  const double mean = sum / 7;
  for (const json& chart : result["per_chart"]) {
    squares += std::pow(chart["gauss_area"].get<double>() - mean, 2);
  }
  EXPECT_EQ(faces, report["input"]["faces"].get<double>());
  EXPECT_NEAR(gauss["mean"].get<double>(), mean, 1e-9);
  EXPECT_NEAR(gauss["std_eq3"].get<double>(), std::sqrt(squares), 1e-9);
  EXPECT_NEAR(gauss["std"].get<double>(), std::sqrt(squares / 7), 1e-9);
  EXPECT_NEAR(gauss["std_over_mean"].get<double>(), std::sqrt(squares / 7) / mean, 1e-9);
  EXPECT_LE(sum, gauss["total"].get<double>() + 1e-9);
  // A closed mesh: every border side of a chart lies against another chart's.
  EXPECT_NEAR(perimeter + 2 * cuts, 2 * result["seam_length"].get<double>(), 1e-9 * perimeter);
  EXPECT_NEAR(result["cut_length"].get<double>(), cuts, 1e-9);
  const json& stretch = result["stretch"];
  EXPECT_NEAR(stretch["l2_area_weighted"].get<double>(), std::sqrt(stretched / surface), 1e-9);
  EXPECT_LE(stretch["l2_median"].get<double>(), stretch["l2_max"].get<double>());
  EXPECT_GT(result["packing_efficiency"].get<double>(), 0.4);
  EXPECT_LT(result["packing_efficiency"].get<double>(), 1);
  EXPECT_GT(result["texel_density"].get<double>(), 0);
  EXPECT_EQ(report["input"]["genus"], 2);
  EXPECT_EQ(result["iterations"].get<std::size_t>(), result["history"].size());
}

TEST(Report, WhatDoesNotExistIsNull) {
  const json stepped = reportOf({"--sample=sphere", "--steps=50"});
  const json& result = stepped["results"][0];
  EXPECT_TRUE(result["best_iteration"].is_null());
  EXPECT_TRUE(result["stretch"]["l2_mean"].is_null());
  EXPECT_TRUE(result["packing_efficiency"].is_null());
  EXPECT_TRUE(result["timing_ms"]["unwrap"].is_null());
  const json flat = reportOf({"--sample=plane", "--charts=4"});
  EXPECT_TRUE(flat["results"][0]["gauss_area"]["std_over_mean"].is_null());
  EXPECT_NEAR(flat["results"][0]["gauss_area"]["total"].get<double>(), 0, 1e-9);
}

TEST(Report, NamesTheParametersInForce) {
  const json report = reportOf({"--sample=cube", "--preset=paper-happy", "--charts=5"});
  const json& parameters = report["parameters"];
  EXPECT_EQ(parameters["charts"], 5);
  EXPECT_EQ(parameters["speed-power"], 3);
  EXPECT_EQ(parameters["speed-epsilon"], 1e-4);
  EXPECT_EQ(parameters["offset-damping"], 0.9);
  EXPECT_EQ(parameters["refine"], "none");
  EXPECT_EQ(parameters["lookahead"], true);
  EXPECT_EQ(report["results"][0]["method"], "t-flooding");
}

}  // namespace
}  // namespace chartflood
