#include "core/session/pipeline/stretch_limit.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

namespace chartflood {

namespace {

constexpr std::size_t kNamed = 5;  // charts that a sentence names

std::string twoDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

}  // namespace

UnwrapOptions unwrapOptions(const Parameters& p) {
  using Boundary = UnwrapOptions::Boundary;
  return {p.unwrap == "circle" ? Boundary::Circle : Boundary::Free, p.reliefStretch};
}

double stretchLimit(const Parameters& p, bool searched) {
  if (p.reliefStretch > 0) return reliefLimit(unwrapOptions(p));
  return searched ? p.maxStretch : std::numeric_limits<double>::infinity();
}

std::vector<Index> chartsAbove(double limit, const Unwrap& unwrap) {
  std::vector<Index> above;
  for (Index c = 0; c < unwrap.charts.size(); ++c) {
    const ChartUv& chart = unwrap.charts[c];
    if (!chart.uv.empty() && chart.distortion.l2 > limit) above.push_back(c);
  }
  return above;
}

std::string aboveLimitText(double limit, const Unwrap& unwrap) {
  const std::vector<Index> above = chartsAbove(limit, unwrap);
  if (above.empty()) return "";
  std::string names;
  for (std::size_t i = 0; i < std::min(above.size(), kNamed); ++i) {
    names += (i == 0 ? "" : ", ") + std::to_string(above[i]) + " (" +
             twoDigits(unwrap.charts[above[i]].distortion.l2) + ")";
  }
  if (above.size() > kNamed) names += " and " + std::to_string(above.size() - kNamed) + " more";
  return (above.size() == 1 ? "Chart " : "Charts ") + names +
         (above.size() == 1 ? " stretches" : " stretch") + " more than the " + twoDigits(limit) +
         " allowed, and no more cuts inside help: more charts would.";
}

}  // namespace chartflood
