#include "app/host/state/compare.h"

#include <algorithm>
#include <utility>

#include "app/host/settings/slider_scale.h"
#include "core/session/pipeline/make_report.h"

namespace chartflood {

CompareFigures compareFigures(const Results& results) {
  CompareFigures figures;
  figures.method = results.parameters.method;
  if (!results.mesh || !results.segmentation) return figures;
  figures.method = results.segmentation->method;
  figures.charts = results.segmentation->chartCount;
  if (!results.chartStats || !results.segmentation->complete) return figures;
  if (results.chartStats->balanceDefined) figures.spread = results.chartStats->stdOverMean();
  const Report report = makeReport(results, {}, "");
  const ResultReport& result = report.results.front();
  figures.seams = result.seamLengthOverSqrtArea;
  if (result.stretch) {
    figures.stretch = result.stretch->l2.mean;
    figures.stretchStd = result.stretch->l2.std;
  }
  return figures;
}

std::vector<ComparePane> Compare::panes() const {
  std::vector<ComparePane> list;
  if (layout == Layout::Off || stored.empty()) return list;
  const std::size_t most = layout == Layout::Wipe ? 2 : kMostPanes;
  for (std::size_t i = 0; i < std::min(stored.size(), most); ++i) list.push_back({i});
  if (list.size() < 2) list.push_back({});
  return list;
}

void Compare::store(StoredResult result) {
  const auto place = std::find_if(stored.begin(), stored.end(), [&](const StoredResult& each) {
    return each.name == result.name;
  });
  if (place != stored.end()) {
    *place = std::move(result);
  } else {
    stored.push_back(std::move(result));
  }
}

const StoredResult* Compare::find(const std::string& name) const {
  const auto place = std::find_if(stored.begin(), stored.end(),
                                  [&](const StoredResult& each) { return each.name == name; });
  return place == stored.end() ? nullptr : &*place;
}

void Compare::update(const std::shared_ptr<const Results>& live) {
  if (!live->flat) return;
  for (StoredResult& each : stored) {
    const bool same = each.results->segmentation == live->segmentation && !each.results->flat;
    if (!same || each.document.parameters != live->parameters) continue;
    each.results = live;
    each.figures = compareFigures(*live);
  }
}

std::string paneName(const Compare& compare, ComparePane pane) {
  return pane.live() ? "Live" : compare.stored[pane.stored].name;
}

std::vector<std::string> differingParameters(const Parameters& mine, const Parameters& other,
                                             std::size_t most) {
  std::vector<std::string> texts;
  for (const ParameterInfo& info : parameterTable()) {
    const std::string_view id = info.id;
    if (id == "method" || id == "charts") continue;  // stand in the heading
    const ParameterValue value = parameterValue(mine, info);
    if (value == parameterValue(other, info)) continue;
    if (texts.size() == most) {
      texts.emplace_back("\u2026");
      return texts;
    }
    const bool number = std::holds_alternative<int>(value) || std::holds_alternative<double>(value);
    const std::string name = *info.symbol != '\0' ? info.symbol : info.label;
    texts.push_back(name + ' ' +
                    (number ? sliderText(info, asNumber(value)) : parameterText(value)));
  }
  return texts;
}

std::optional<std::pair<double, double>>
commonRange(const std::vector<std::optional<ScalarRange>>& ranges) {
  std::optional<std::pair<double, double>> common;
  for (const std::optional<ScalarRange>& range : ranges) {
    if (!range || range->plainEnds) continue;
    if (!common) common = {range->min, range->max};
    common = {std::min(common->first, range->min), std::max(common->second, range->max)};
  }
  return common;
}

}  // namespace chartflood
