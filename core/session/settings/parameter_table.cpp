#include "core/session/settings/parameter_table.h"

#include <algorithm>

namespace chartflood {

namespace {

std::vector<ParameterInfo> allRows() {
  std::vector<ParameterInfo> rows;
  for (std::vector<ParameterInfo> part :
       {chartRows(), balanceRows(), borderRows(), cuttingRows(), unwrapRows(), stoppingRows(),
        methodRows(), modelRows()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

/// Settings that the printed method has and the defaults do not.
std::vector<std::pair<const char*, ParameterValue>> printedValues(double power) {
  return {{"method", std::string("t-flooding")},
          {"sharp-angle", 45.0},
          {"speed-power", power},
          {"speed-epsilon", 1e-4},
          {"offset-damping", 0.9},
          {"area-share", 0.0},
          {"settle", 0},
          {"seeding", std::string("one-by-one")},
          {"keep", std::string("eq3")},
          {"detect-cycles", false},  // it ends the rounds before their offsets have done their work
          {"search", std::string("literal")},
          {"start", std::string("flood")},
          {"refine", std::string("none")},
          {"handle-search", std::string("wavefront")},
          {"tip", 1.0},
          {"relief-stretch", 0.0},
          {"unwrap", std::string("circle")},
          {"layout", std::string("square")}};
}

std::vector<Preset> allPresets() {
  return {
      {"paper", "Paper",
       "The printed values: p 1, \u03b5 1e-4, \u03b2 0.9, borders as flooded, charts on circles.",
       printedValues(1)},
      {"paper-happy", "Paper: Happy", "The printed values for the Happy Buddha: p 3.",
       printedValues(3)},
      {"few-large",
       "Few large charts",
       "Eight round charts, as few seams as possible.",
       {{"charts", 8}, {"speed-power", 1.0}}},
      {"hard-surface",
       "Hard surface",
       "Machine parts: charts begin from creases, soft bevels too.",
       {{"sharp-angle", 30.0}, {"speed-power", 3.0}, {"start", std::string("creases")}}},
      {"organic",
       "Organic",
       "Figures and scans: the model is treated as smooth clay.",
       {{"sharp-angle", 90.0}, {"speed-power", 2.0}}},
  };
}

}  // namespace

std::span<const ParameterInfo> parameterTable() {
  static const std::vector<ParameterInfo> rows = allRows();
  return rows;
}

const ParameterInfo* findParameter(std::string_view id) {
  const auto rows = parameterTable();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const ParameterInfo& row) { return id == row.id; });
  return found == rows.end() ? nullptr : &*found;
}

std::span<const Preset> presetTable() {
  static const std::vector<Preset> presets = allPresets();
  return presets;
}

const Preset* findPreset(std::string_view id) {
  const auto presets = presetTable();
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [&](const Preset& preset) { return id == preset.id; });
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace chartflood
