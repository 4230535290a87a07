#include "app/host/insight/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "render/scene/mode_range.h"

namespace chartflood {

namespace {

constexpr std::size_t kBins = 48;
constexpr const char* kOfSurface = "of the surface";

using Values = std::vector<WeightedValue>;

ModeHistogram binned(const Values& values, ScalarRange range, ColorMode mode, const char* weight,
                     const RenderSettings& settings) {
  const ColorModeInfo& info = colorModeInfo(mode);
  range.title = info.title;
  range.unit = info.unit;
  range.scale = info.scale;
  ModeHistogram result;
  result.range = chosenRange(std::move(range), settings);
  result.weight = weight;
  result.histogram = binValues(values, result.range, kBins);
  return result;
}

Values ofTriangles(const Mesh& mesh, std::span<const float> values) {
  Values weighted;
  weighted.reserve(values.size());
  for (std::size_t t = 0; t < values.size(); ++t) {
    weighted.push_back({double{values[t]}, mesh.triangleArea()[t]});
  }
  return weighted;
}

/// Creases by their length.
Values ofEdges(const GaussValues& gauss) {
  Values weighted;
  for (std::size_t i = 0; i + 1 < gauss.edges.size(); i += 2) {
    const double length =
        double{glm::distance(glm::vec3(gauss.edges[i]), glm::vec3(gauss.edges[i + 1]))};
    weighted.push_back({double{gauss.edges[i].w}, length});
  }
  return weighted;
}

/// Corners, each once.
Values ofVertices(const GaussValues& gauss) {
  Values weighted;
  for (std::size_t i = 0; i + 1 < gauss.vertices.size(); i += 2) {
    weighted.push_back({double{gauss.vertices[i].w}, 1});
  }
  return weighted;
}

void addGauss(const HistogramSource& source, const RenderSettings& settings,
              std::vector<ModeHistogram>& out) {
  if (!source.surface) return;
  const GaussValues& gauss = source.surface->gaussValues;
  const ColorMode mode = settings.colorMode;
  const bool all = mode == ColorMode::Gauss;
  RenderSettings own = settings;
  if (all) own.range.reset();  // each kind is drawn on its own
  if (all || mode == ColorMode::GaussFace) {
    out.push_back(binned(ofTriangles(*source.surface->mesh, gauss.faces), gauss.faceRange,
                         ColorMode::GaussFace, kOfSurface, own));
  }
  if (all || mode == ColorMode::GaussEdge) {
    out.push_back(binned(ofEdges(gauss), gauss.edgeRange, ColorMode::GaussEdge,
                         "of the creases' length", own));
  }
  if (all || mode == ColorMode::GaussVertex) {
    out.push_back(binned(ofVertices(gauss), gauss.vertexRange, ColorMode::GaussVertex,
                         "of the corners", own));
  }
}

void addBalance(const HistogramSource& source, const RenderSettings& settings,
                std::vector<ModeHistogram>& out) {
  if (!source.stats || source.stats->charts.empty()) return;
  std::vector<double> areas;
  for (const ChartFigures& chart : source.stats->charts) areas.push_back(chart.gaussArea);
  const std::vector<float> balance = balanceValues(areas);
  Values values;
  for (std::size_t c = 0; c < balance.size(); ++c) {
    values.push_back({double{balance[c]}, source.stats->charts[c].area});
  }
  out.push_back(binned(values, balanceRange(balance), ColorMode::Balance, kOfSurface, settings));
}

double faceArea(const Mesh& mesh, Index face) {
  double area = 0;
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    area += mesh.triangleArea()[t];
  }
  return area;
}

void addFlood(const HistogramSource& source, const RenderSettings& settings,
              std::vector<ModeHistogram>& out) {
  if (!source.record || !source.mesh || source.taken == 0) return;
  const FloodRecord& record = *source.record;
  const bool order = settings.colorMode == ColorMode::FloodOrder;
  std::vector<double> longest;
  for (std::size_t i = 0; i < source.recorded; ++i) {
    const Incorporation& entry = record[i];
    if (entry.chart >= longest.size()) longest.resize(entry.chart + 1, 0.0);
    longest[entry.chart] = std::max(longest[entry.chart], double{entry.time});
  }
  Values values;
  values.reserve(source.taken + 1);
  double dry = 0;
  for (const double area : source.mesh->triangleArea()) dry += area;
  const auto all = static_cast<double>(source.mesh->faceCount());
  for (std::size_t i = 0; i < source.taken; ++i) {
    const Incorporation& entry = record[i];
    const double whole = longest[entry.chart];
    const double time = whole > 0 ? double{entry.time} / whole : 0;
    const double area = faceArea(*source.mesh, entry.face);
    values.push_back({order ? static_cast<double>(i) / all : time, area});
    dry -= area;
  }
  // Shares are of the whole surface, so that bars stay where they are while more of it is taken.
  if (source.taken < source.mesh->faceCount()) {
    values.push_back({std::numeric_limits<double>::quiet_NaN(), dry});
  }
  out.push_back(binned(values, ScalarRange{}, settings.colorMode, kOfSurface, settings));
  Histogram& histogram = out.back().histogram;
  for (double& share : histogram.share) share *= 1 - histogram.missing;
}

void addDistortion(const HistogramSource& source, const RenderSettings& settings,
                   std::vector<ModeHistogram>& out) {
  if (!source.unwrap || !source.mesh) return;
  const ColorMode mode = settings.colorMode;
  const std::vector<float>& values = mode == ColorMode::Stretch          ? source.unwrap->stretch
                                     : mode == ColorMode::AreaDistortion ? source.unwrap->area
                                                                         : source.unwrap->angle;
  if (values.size() != source.mesh->triangleCount()) return;
  const ScalarRange range = distortionRange(mode, values, source.mesh->triangleArea());
  out.push_back(binned(ofTriangles(*source.mesh, values), range, mode, kOfSurface, settings));
}

}  // namespace

Histogram binValues(std::span<const WeightedValue> values, const ScalarRange& range,
                    std::size_t bins) {
  Histogram result;
  result.share.assign(bins, 0.0);
  double total = 0, missing = 0;
  for (const WeightedValue& v : values) {
    if (!(v.weight > 0)) continue;
    if (!std::isfinite(v.value)) {
      missing += v.weight;
      continue;
    }
    total += v.weight;
    if (v.value < range.min) result.below += v.weight;
    if (v.value > range.max) result.above += v.weight;
    const auto bin = static_cast<std::size_t>(range.place(v.value) * static_cast<double>(bins));
    result.share[std::min(bin, bins - 1)] += v.weight;
  }
  if (total > 0) {
    for (double& share : result.share) share /= total;
    result.below /= total;
    result.above /= total;
  }
  if (total + missing > 0) result.missing = missing / (total + missing);
  return result;
}

double valueAt(const ScalarRange& range, double place) {
  if (range.scale == ScalarScale::Log) return range.min * std::pow(range.max / range.min, place);
  const double t = range.scale == ScalarScale::Root ? place * place : place;
  return range.min + t * (range.max - range.min);
}

std::vector<ModeHistogram> modeHistograms(const HistogramSource& source,
                                          const RenderSettings& settings) {
  std::vector<ModeHistogram> result;
  switch (settings.colorMode) {
  case ColorMode::Gauss:
  case ColorMode::GaussFace:
  case ColorMode::GaussEdge:
  case ColorMode::GaussVertex:
    addGauss(source, settings, result);
    break;
  case ColorMode::Balance:
    addBalance(source, settings, result);
    break;
  case ColorMode::FloodTime:
  case ColorMode::FloodOrder:
    addFlood(source, settings, result);
    break;
  case ColorMode::Stretch:
  case ColorMode::AreaDistortion:
  case ColorMode::AngleDistortion:
    addDistortion(source, settings, result);
    break;
  case ColorMode::Shaded:
  case ColorMode::Charts:
  case ColorMode::Checkerboard:
    break;
  }
  return result;
}

}  // namespace chartflood
