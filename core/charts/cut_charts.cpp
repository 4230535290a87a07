#include "core/charts/cut_charts.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

#include "core/base/counted.h"
#include "core/base/parallel.h"
#include "core/charts/chart_surface.h"
#include "core/charts/loop_merge_cutter.h"
#include "core/charts/tip_cutter.h"

namespace chartflood {

namespace {

/// Why a chart is no disk, for somebody who has the switches at hand; "" for a disk.
std::string problemOf(const ChartTopology& topology, const CutOptions& options) {
  if (topology.disk()) return "";
  if (topology.pieces == 0) return "it has no faces.";
  if (topology.pieces > 1) {
    return "it is in " + std::to_string(topology.pieces) +
           " pieces: each of them needs a chart of its own.";
  }
  const auto handles = static_cast<std::size_t>(std::max(0l, topology.genus()));
  const std::size_t borders = topology.boundaryLoops;
  std::string what, cure;
  if (handles > 0) {
    what = counted(handles, "handle", "handles");
    if (!options.handles) cure = "Cut handles";
  }
  if (borders != 1) {
    what += what.empty() ? "" : " and ";
    what += borders == 0 ? "no border" : counted(borders, "border", "borders");
    if (!options.loops) cure += cure.empty() ? "Open into disks" : " and Open into disks";
  }
  if (!cure.empty()) return "it has " + what + ": turn on " + cure + ".";
  return "it has " + what + " that its edges cannot open: split its polygons into triangles.";
}

void append(std::vector<Cut>& cuts, std::vector<Cut>&& more) {
  for (Cut& cut : more) cuts.push_back(std::move(cut));
}

void cutChart(CutChart& chart, const CutOptions& options, std::uint32_t seed,
              const Progress& progress) {
  ChartSurface& surface = chart.surface;
  chart.before = chart.topology = topologyOf(surface);
  if (chart.topology.pieces == 1) {
    if (options.handles && chart.topology.genus() > 0) {
      append(chart.cuts, cutHandles(surface, options.handleSearch, seed, progress));
      chart.topology = topologyOf(surface);
    }
    if (progress.cancelled()) return;
    if (options.loops && chart.topology.boundaryLoops != 1) {
      const bool closed = chart.topology.boundaryLoops == 0;
      if (!closed) append(chart.cuts, mergeLoops(surface));
      if (closed && chart.topology.genus() == 0) append(chart.cuts, openClosed(surface));
      chart.topology = topologyOf(surface);
    }
    if (options.tips && options.tip > 0 && chart.disk()) cutTips(chart, options.tip);
  }
  chart.problem = problemOf(chart.topology, options);
}

}  // namespace

std::shared_ptr<const ChartSet> cutCharts(const Mesh& mesh, const Segmentation& segmentation,
                                          const CutOptions& options, Progress& progress) {
  std::vector<ChartSurface> surfaces =
      extractCharts(mesh, segmentation.label, segmentation.chartCount);
  const auto set = std::make_shared<ChartSet>();
  set->charts = CutCharts(surfaces.size());
  std::atomic<std::size_t> triangles{0};
  parallelFor(surfaces.size(), [&](std::size_t c) {
    if (progress.cancelled()) return;
    CutChart chart;
    chart.surface = std::move(surfaces[c]);
    const std::size_t size = chart.surface.triangleCount();
    cutChart(chart, options, options.seed + static_cast<std::uint32_t>(c), progress);
    set->charts.put(c, std::move(chart));
    const std::size_t done = triangles.fetch_add(size) + size;
    progress.setFraction(static_cast<float>(done) / static_cast<float>(mesh.triangleCount()));
  });
  if (progress.cancelled()) return nullptr;
  return set;
}

}  // namespace chartflood
