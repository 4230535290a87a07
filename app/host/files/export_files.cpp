#include "app/host/files/export_files.h"

#include <cstdint>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/io/write/write_seams.h"
#include "core/io/write/write_uv_svg.h"
#include "core/io/write_mesh.h"
#include "render/scene/chart_palette.h"

namespace chartflood {

namespace {

ChartedMesh chartedMesh(const Results& results) {
  return {*results.mesh, results.segmentation->label, *results.charts, *results.atlas};
}

/// The colour of each chart, as the renderer gives them out.
std::vector<std::uint32_t> colorsOf(const Results& results, const std::string& palette,
                                    std::span<const Index> kept) {
  const ChartPalette* wanted = findChartPalette(palette);
  if (wanted == nullptr) throw UsageError("There is no chart palette \"" + palette + "\".");
  const Segmentation& labels = *results.segmentation;
  const std::vector<ChartPair> neighbours = neighbourCharts(*results.mesh, labels.label);
  const ChartPalette& usual = chartPaletteTable().front();
  std::vector<Index> first(labels.chartCount);
  for (Index chart = 0; chart < first.size(); ++chart) {
    first[chart] = chart < kept.size()
                       ? kept[chart]
                       : chart % static_cast<Index>(usual.colors.size() - usual.reserve);
  }
  std::vector<std::uint32_t> colors;
  for (const Index number : colorCharts(labels.chartCount, neighbours, first, usual)) {
    colors.push_back(wanted->colors[number % wanted->colors.size()]);
  }
  return colors;
}

}  // namespace

std::string exportRefusal(const Results& results) {
  if (!results.mesh) return "There is no model yet; open one first.";
  if (results.sketch) return "These charts are a preview: let go of the slider, or press Enter.";
  return results.flat ? "" : "The charts are not laid flat yet; press Unwrap (W) first.";
}

bool isSameFile(const std::filesystem::path& target, const std::filesystem::path& input) {
  std::error_code unknown;  // what is not there is not the same
  return !input.empty() && std::filesystem::equivalent(target, input, unknown);
}

std::string exportedMesh(const Results& results, const std::filesystem::path& file) {
  MeshWriteOptions options;
  options.glb.sharpAngle = results.parameters.sharpAngle;
  return meshBytes(file, chartedMesh(results), options);
}

std::string exportedSeams(const Results& results) { return seamsText(chartedMesh(results)); }

std::string exportedUvSvg(const Results& results, const std::string& palette,
                          std::span<const Index> chartColors) {
  const std::vector<std::uint32_t> colors = colorsOf(results, palette, chartColors);
  return uvSvgText(chartedMesh(results), {.colors = colors});
}

}  // namespace chartflood
