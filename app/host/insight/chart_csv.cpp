#include "app/host/insight/chart_csv.h"

#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "core/base/check.h"

namespace chartflood {

namespace {

using Cells = std::vector<std::pair<const char*, std::string>>;

/// The shortest text that reads back as the same number, in any locale.
std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

const char* word(bool value) { return value ? "yes" : "no"; }

void addTexture(const Results& results, Index chart, Cells& cells) {
  const bool flat = results.flat && results.unwrap && chart < results.unwrap->charts.size() &&
                    !results.unwrap->charts[chart].uv.empty();
  const Distortion d = flat ? results.unwrap->charts[chart].distortion : Distortion{};
  const auto add = [&](const char* name, const std::string& value) {
    cells.emplace_back(name, flat ? value : std::string());
  };
  add("stretch_l2", number(d.l2));
  add("stretch_linf", number(d.linf));
  add("area_distortion", number(d.area));
  add("angle_distortion", number(d.angle));
  add("flipped", std::to_string(d.flipped));
}

Cells cellsOf(const Results& results, Index chart) {
  const ChartStats& stats = *results.chartStats;
  const ChartFigures& f = stats.charts[chart];
  const double total = results.gaussArea ? results.gaussArea->total() : 0;
  const bool cut = results.flat && results.charts && chart < results.charts->charts.size();
  Cells cells = {
      {"chart", std::to_string(chart)},
      {"faces", std::to_string(f.faces)},
      {"area", number(f.area)},
      {"gauss_area_sr", number(f.gaussArea)},
      {"gauss_share_of_mean",
       stats.balanceDefined ? number(f.gaussArea / stats.gaussMean) : std::string()},
      {"gauss_share_of_total", total > 0 ? number(f.gaussArea / total) : std::string()},
      {"perimeter", number(f.perimeter)},
      {"euler_number", std::to_string(f.euler)},
      {"boundary_loops", std::to_string(f.boundaryLoops)},
      {"connected", word(f.connected)},
      {"disk", word(cut ? results.charts->charts[chart].disk() : f.disk)},
      {"seed_face",
       f.seedFace == kNone ? std::string() : std::to_string(results.mesh->inputFace(f.seedFace))},
  };
  addTexture(results, chart, cells);
  return cells;
}

}  // namespace

std::string chartsCsv(const Results& results) {
  if (!results.chartStats || !results.mesh) return "";
  std::string text;
  for (Index chart = 0; chart < results.chartStats->charts.size(); ++chart) {
    const Cells cells = cellsOf(results, chart);
    std::string names, values;
    for (const auto& [name, value] : cells) {
      if (!names.empty()) names += ',', values += ',';
      names += name;
      values += value;
    }
    if (chart == 0) text += names + '\n';
    text += values + '\n';
  }
  return text;
}

std::string chartFigures(const Results& results, Index chart) {
  CF_CHECK(results.chartStats && results.mesh && chart < results.chartStats->charts.size());
  std::string text;
  for (const auto& [name, value] : cellsOf(results, chart)) {
    if (!value.empty()) text += std::string(name) + ": " + value + '\n';
  }
  return text;
}

}  // namespace chartflood
