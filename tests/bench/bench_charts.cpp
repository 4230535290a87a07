// Time of taking charts out and cutting them into disks, on growing and on real meshes:
//   build/release/tests/bench_charts
// One chart over the whole mesh is the hard case; "bands" are 20 slices, and most of them fall into
// pieces, which are left uncut: there it measures what is done around the cutting.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "core/base/parallel.h"
#include "core/charts/chart_surface.h"
#include "core/charts/cut_charts.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "core/samples/samples.h"

namespace chartflood {
namespace {

/// "double-torus/20000" is a sample of so many triangles, anything else a file of the folder.
const Mesh& meshOf(const std::string& name) {
  static std::map<std::string, std::shared_ptr<const Mesh>> made;
  std::shared_ptr<const Mesh>& entry = made[name];
  if (!entry) {
    const std::size_t slash = name.find('/');
    entry = buildMesh(slash == std::string::npos
                          ? readMesh(std::filesystem::path(CHARTFLOOD_MESHES) / name)
                          : makeSample(name.substr(0, slash), std::stoul(name.substr(slash + 1))));
  }
  return *entry;
}

Segmentation bands(const Mesh& mesh, Index count) {
  Segmentation segmentation;
  segmentation.chartCount = count;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Index v = mesh.triangles()[mesh.triangleBegin(f)][0];
    const double share = std::max(0.0, mesh.positions()[v].x + 0.5);
    segmentation.label.push_back(std::min(count - 1, static_cast<Index>(share * count)));
  }
  return segmentation;
}

void extract(benchmark::State& state, const std::string& name) {
  const Mesh& mesh = meshOf(name);
  const Segmentation segmentation = bands(mesh, 20);
  for (auto _ : state) benchmark::DoNotOptimize(extractCharts(mesh, segmentation.label, 20));
}

template <Index kCharts, HandleSearch kSearch>
void cut(benchmark::State& state, const std::string& name) {
  const Mesh& mesh = meshOf(name);
  const Segmentation segmentation = bands(mesh, kCharts);
  CutOptions options;
  options.handleSearch = kSearch;
  double length = 0;
  for (auto _ : state) {
    Progress progress;
    const auto set = cutCharts(mesh, segmentation, options, progress);
    length = 0;
    for (const CutChart& chart : set->charts) length += chart.cutLength();
  }
  state.counters["length"] = length;
}

void record(benchmark::State& state, const std::string& name) {
  const Mesh& mesh = meshOf(name);
  const auto charts = extractCharts(mesh, bands(mesh, 1).label, 1);
  const Progress progress;
  for (auto _ : state) benchmark::DoNotOptimize(recordHandleCutter(charts.front(), 1, progress));
}

void registerAll(const std::string& mesh) {
  using Stage = void (*)(benchmark::State&, const std::string&);
  const std::pair<const char*, Stage> stages[] = {
      {"extract", extract},
      {"bands", cut<20, HandleSearch::Shortest>},
      {"whole_shortest", cut<1, HandleSearch::Shortest>},
      {"whole_wavefront", cut<1, HandleSearch::Wavefront>},
      {"record", record}};
  for (const auto& [name, stage] : stages) {
    benchmark::RegisterBenchmark((std::string(name) + "/" + mesh).c_str(),
                                 [stage = stage, mesh](benchmark::State& s) { stage(s, mesh); })
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace chartflood

int main(int argc, char** argv) {
  // One thread unless asked: figures of one thread compare between machines.
  const char* threads = std::getenv("CHARTFLOOD_THREADS");
  chartflood::setThreadCount(threads != nullptr ? static_cast<unsigned>(std::atoi(threads)) : 1);
  for (const char* mesh : {"double-torus/5000", "double-torus/20000", "double-torus/80000"}) {
    chartflood::registerAll(mesh);
  }
  for (const char* file : {"cheese.off", "tray-ascii.stl", "casting.off"}) {
    if (std::filesystem::exists(std::filesystem::path(CHARTFLOOD_MESHES) / file)) {
      chartflood::registerAll(file);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
