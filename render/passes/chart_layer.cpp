#include "render/passes/chart_layer.h"

#include <algorithm>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/base/error.h"

namespace chartflood {

namespace {

const ChartPalette& paletteNamed(const std::string& id) {
  const ChartPalette* palette = findChartPalette(id);
  if (!palette) throw UsageError("There is no chart palette \"" + id + "\".");
  return *palette;
}

}  // namespace

ChartLayer::ChartLayer(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) { setLabels({}); }

void ChartLayer::setSegmentation(const Segmentation& segmentation) {
  growTo(segmentation.chartCount);
  // Half-grown charts have not met all their neighbours yet: colours wait for the end.
  if (segmentation.complete) recolor(neighbourCharts(*mesh_, segmentation.label));
}

void ChartLayer::setLabels(std::span<const Index> label) {
  label_.assign(mesh_->triangleCount(), kNone);
  labelled_ = !label.empty();
  if (labelled_) {
    for (Index t = 0; t < label_.size(); ++t) label_[t] = label[mesh_->faceOf(t)];
  }
  labels_.upload<Index>(GL_R32UI, label_, GL_DYNAMIC_DRAW);
  uploadSeams();
}

void ChartLayer::setSeeds(std::span<const glm::dvec3> places) {
  if (places.size() <= colorNumber_.size()) return;
  recolor(nearbyPairs(places));
}

void ChartLayer::growTo(std::size_t chartCount) {
  while (colorNumber_.size() < chartCount) {
    const std::size_t usual = chartPaletteTable()[0].colors.size() - chartPaletteTable()[0].reserve;
    colorNumber_.push_back(static_cast<Index>(colorNumber_.size() % usual));
  }
}

void ChartLayer::paint(std::span<const Index> numbers) {
  growTo(numbers.size());
  std::copy(numbers.begin(), numbers.end(), colorNumber_.begin());
}

void ChartLayer::recolor(std::span<const ChartPair> neighbours) {
  std::size_t count = colorNumber_.size();
  for (const ChartPair& pair : neighbours) count = std::max<std::size_t>(count, pair.second + 1u);
  colorNumber_ = colorCharts(count, neighbours, colorNumber_, chartPaletteTable()[0]);
}

void ChartLayer::update(const RenderSettings& settings, std::span<const float> longestTime,
                        std::span<const float> chartValues) {
  std::vector<glm::vec4> colors;
  std::vector<glm::vec2> values;
  for (Index chart = 0; chart < colorNumber_.size(); ++chart) {
    const bool steppedBack =
        !settings.selectedCharts.empty() && !holdsChart(settings.selectedCharts, chart);
    const float state = holdsChart(settings.hiddenCharts, chart) ? 0.0f : steppedBack ? 0.5f : 1.0f;
    colors.emplace_back(chartColor(chart, settings.palette), state);
    const float longest = chart < longestTime.size() ? longestTime[chart] : 0.0f;
    values.emplace_back(chart < chartValues.size() ? chartValues[chart] : 0.0f,
                        longest > 0 ? 1 / longest : 0.0f);
  }
  if (!colors_ || colors != uploadedColors_) colors_.upload<glm::vec4>(GL_RGBA32F, colors);
  if (!values_ || values != uploadedValues_) values_.upload<glm::vec2>(GL_RG32F, values);
  uploadedColors_ = std::move(colors);
  uploadedValues_ = std::move(values);
}

glm::vec3 ChartLayer::chartColor(Index chart, const std::string& palette) const {
  const std::span<const std::uint32_t> colors = paletteNamed(palette).colors;
  const Rgb8 color = rgb8(colors[colorNumber_[chart] % colors.size()]);
  return glm::vec3(color[0], color[1], color[2]) / 255.0f;
}

void ChartLayer::uploadSeams() {
  std::vector<glm::vec4> ends;
  if (labelled_) {
    for (Index side = 0; side < mesh_->opposite().size(); ++side) {
      const Index other = mesh_->opposite()[side];
      if (other == kNone || other < side) continue;
      const Index a = label_[side / 3], b = label_[other / 3];
      if (a == b || a == kNone || b == kNone) continue;
      ends.emplace_back(glm::vec3(mesh_->positions()[mesh_->sideStart(side)]),
                        static_cast<float>(a));
      ends.emplace_back(glm::vec3(mesh_->positions()[mesh_->sideEnd(side)]), static_cast<float>(b));
    }
  }
  seamCount_ = ends.size() / 2;
  seams_.upload<glm::vec4>(GL_RGBA32F, ends);
}

}  // namespace chartflood
